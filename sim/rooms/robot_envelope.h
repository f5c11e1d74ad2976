// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/rooms/scene_document.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// An upright cylinder about the vertical through a robot's base frame [m].
struct UprightCylinder {
  double radius_m = 0;
  double bottom_m = 0;  ///< above the floor
  double top_m = 0;
};

/// A robot between two cylinders: where the outer one is free, so is the robot whatever its
/// heading; where the core touches something, so does the robot.
struct RobotEnvelope {
  UprightCylinder outer;
  UprightCylinder core;
};

/// Envelope of what of the robot can collide, its base standing level on the floor. The core lies
/// within the one box that holds the widest.
/// @throws SceneError when there is no such body, or the base frame lies in none of its boxes
RobotEnvelope EnvelopeOf(const World& world, std::string_view base_body);

/// Adds a body with that cylinder, which collides with what the Koala's hull collides with.
void AddProbe(SceneDocument& scene, const char* name, const UprightCylinder& cylinder);

}  // namespace horopter::sim
