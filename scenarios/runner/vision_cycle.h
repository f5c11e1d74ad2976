// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "control/navigator/obstacle_points.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "hardware/types/stage_times.h"
#include "hardware/types/stereo_frame.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/disparity_field.h"
#include "vision/reconstruction/reconstruct.h"
#include "vision/regions/region.h"

namespace horopter::scenarios {

/// Everything that one stereo frame tells the stack. Maps have the left image's size.
struct VisionResult {
  hardware::Time t_capture{};
  vision::DisparityField disparity;
  cv::Mat1f depth_m;  ///< along the left optical axis; NaN = none
  control::SplitPoints points_B;  ///< in the base frame at t_capture: what could be hit, and floor
  vision::RegionMap regions;      ///< their depth is that of depth_m
};

/// The vision half of the Koala paper's Figure 1: disparity and reconstruction on one side,
/// segmentation and blobs on the other, joined as depth per region.
class VisionCycle {
 public:
  /// @throws hardware::ConfigError
  VisionCycle(const VisionSpec& spec, const hardware::PerEye<hardware::CameraModel>& cameras,
              const RobotDescription& robot);

  /// @param angles as the encoders reported them when the images were taken
  VisionResult Run(const hardware::StereoFrame& frame, const hardware::HeadAngles& angles,
                   hardware::StageTimes& times) const;

 private:
  VisionSpec spec_;
  hardware::HeadGeometry geometry_;
  control::ObstacleConfig obstacles_;
  vision::Reconstructor reconstructor_;
  std::unique_ptr<vision::DisparityEstimator> estimator_;
};

}  // namespace horopter::scenarios
