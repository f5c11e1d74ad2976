// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/tables.h"

#include <fmt/format.h>

#include <vector>

#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

std::string Row(const std::vector<std::string>& fields) {
  return fmt::format("{}", fmt::join(fields, ","));
}

std::string PoseFields(const hardware::Pose2& pose) {
  return Row({ExactNumber(pose.x_m), ExactNumber(pose.y_m), ExactNumber(pose.heading_rad)});
}

std::string PoseFields(const std::optional<hardware::Pose2>& pose) {
  return pose ? PoseFields(*pose) : ",,";
}

std::string AngleFields(const hardware::HeadAngles& angles) {
  std::vector<std::string> fields;
  for (const double rad : hardware::ToArray(angles)) fields.push_back(ExactNumber(rad));
  return Row(fields);
}

std::string DepthFields(const std::optional<DepthScore>& depth) {
  if (!depth) return ",,,";
  return Row({ExactNumber(depth->density), ExactNumber(depth->abs_rel_median),
              ExactNumber(depth->abs_rel_mean), ExactNumber(depth->bias_m)});
}

}  // namespace

std::string_view FrameTableHeader() {
  return "index,t_s,step,decision,odometry_x_m,odometry_y_m,odometry_heading_rad,"
         "true_x_m,true_y_m,true_heading_rad,"
         "neck_pan_rad,neck_tilt_rad,left_pan_rad,left_tilt_rad,right_pan_rad,right_tilt_rad,"
         "disparity_density,regions,"
         "depth_density,depth_abs_rel_median,depth_abs_rel_mean,depth_bias_m,"
         "fixation_error_deg,clearance_m";
}

std::string FrameTableRow(const FrameRecord& frame) {
  return Row({std::to_string(frame.index), ExactNumber(hardware::ToSeconds(frame.t_capture)),
              CsvField(frame.step), CsvField(frame.decision), PoseFields(frame.odometry),
              PoseFields(frame.true_pose), AngleFields(frame.angles),
              ExactNumber(frame.disparity_density), std::to_string(frame.regions),
              DepthFields(frame.depth), ExactNumber(frame.fixation_error_deg),
              ExactNumber(frame.clearance_m)});
}

std::string_view PathTableHeader() {
  return "t_s,odometry_x_m,odometry_y_m,odometry_heading_rad,true_x_m,true_y_m,true_heading_rad";
}

std::string PathTableRow(const PathPoint& point) {
  return Row({ExactNumber(point.t_s), PoseFields(point.odometry), PoseFields(point.true_pose)});
}

}  // namespace horopter::scenarios
