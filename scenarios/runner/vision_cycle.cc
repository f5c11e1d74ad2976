// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/vision_cycle.h"

#include <utility>

#include "control/kinematics/head_kinematics.h"
#include "scenarios/runner/stack_config.h"
#include "vision/disparity/disparity_factory.h"
#include "vision/regions/extract_regions.h"
#include "vision/segmentation/colour_edges.h"

namespace horopter::scenarios {
namespace {

std::unique_ptr<vision::DisparityEstimator> MakeEstimator(const VisionSpec& spec) {
  if (spec.method != "v1") return vision::CreateDisparityEstimator(spec.method, spec.preset);
  vision::V1Config config = vision::V1Config::Preset(spec.preset);
  config.scales = spec.scales;
  return vision::CreateDisparityEstimator(config);
}

}  // namespace

VisionCycle::VisionCycle(const VisionSpec& spec,
                         const hardware::PerEye<hardware::CameraModel>& cameras,
                         const RobotDescription& robot)
    : spec_(spec),
      geometry_(robot.head_geometry),
      obstacles_(ObstacleConfigOf(robot)),
      reconstructor_(cameras),
      estimator_(MakeEstimator(spec)) {}

VisionResult VisionCycle::Run(const hardware::StereoFrame& frame,
                              const hardware::HeadAngles& angles,
                              hardware::StageTimes& times) const {
  VisionResult result;
  result.t_capture = frame.left.t_capture;

  // Where: the match of every left pixel, and from it a point.
  result.disparity = times.Measure(
      "disparity", [&] { return estimator_->Estimate(frame.left.bgr, frame.right.bgr); });
  const vision::PointField points_B = times.Measure("reconstruction", [&] {
    const auto points_H = reconstructor_.Reconstruct(result.disparity, angles, geometry_.baseline_m,
                                                     geometry_.axis_to_optical_centre_m);
    return vision::Transformed(points_H, control::HeadPose(geometry_, angles.neck));
  });
  result.points_B =
      times.Measure("obstacle points", [&] { return control::Split(points_B, obstacles_); });
  result.depth_m = vision::DepthAlongOptical(
      points_B, control::EyePose(geometry_, angles, hardware::Eye::kLeft));

  // What: surfaces bounded by colour edges, each with its depth.
  const cv::Mat1b interior = times.Measure("segmentation", [&] {
    return vision::FindColourEdges(
        frame.left.bgr, {.median_px = spec_.median_px, .threshold = spec_.edge_threshold});
  });
  result.regions = times.Measure(
      "regions", [&] { return vision::ExtractRegions(interior, frame.left.bgr, result.depth_m); });
  return result;
}

}  // namespace horopter::scenarios
