// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/body_placement.h"

#include <cmath>

namespace horopter::scenarios {

hardware::Pose BodyPlacement::X_OBody() const {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  constexpr double kRadians = M_PI / 180;
  hardware::Pose X_OBody = hardware::Pose::Identity();
  X_OBody.linear() = (AngleAxisd(yaw_deg * kRadians, Vector3d::UnitZ()) *
                      AngleAxisd(pitch_deg * kRadians, Vector3d::UnitY()) *
                      AngleAxisd(roll_deg * kRadians, Vector3d::UnitX()))
                         .toRotationMatrix();
  X_OBody.translation() = position_m;
  return X_OBody;
}

}  // namespace horopter::scenarios
