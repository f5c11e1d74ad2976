// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/world/world.h"

namespace horopter::sim {

struct BodyPose {
  std::string body;
  hardware::Pose X_WB = hardware::Pose::Identity();
};

enum class JointKind { kHinge, kSlide };

/// A joint of one degree of freedom. Free and ball joints are told by the pose of their body.
struct JointReading {
  std::string joint;
  JointKind kind = JointKind::kHinge;
  double position = 0;  ///< [rad] of a hinge, [m] of a slide
  double velocity = 0;  ///< [rad/s] or [m/s]
};

/// Poses, joints and contacts of one instant, unnoisy and unquantised.
struct WorldState {
  hardware::Time t{};                ///< of the world's own clock
  std::vector<BodyPose> bodies;      ///< all but the world; without a name as "body 7"
  std::vector<JointReading> joints;  ///< hinges and slides
  std::vector<Contact> contacts;
};

/// @pre the world's kinematics are up to date (World::Step, World::Forward)
WorldState ReadWorldState(const World& world);

}  // namespace horopter::sim
