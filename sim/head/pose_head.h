// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/head_angles.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Puts the head's joints (hardware::kHeadAxisNames) straight to these angles, for views that no
/// time passes between; then World::Forward(). Axes that the scene lacks are left out.
/// @throws SceneError when the scene has none of the axes
void PoseHead(World& world, const hardware::HeadAngles& angles);

}  // namespace horopter::sim
