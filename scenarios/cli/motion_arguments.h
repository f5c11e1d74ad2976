// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scenarios/cli/render_options.h"
#include "scenarios/render/motion.h"
#include "sim/camera/camera_profile.h"

namespace horopter::scenarios {

/// The motion that the options ask for; none: still views.
/// @throws hardware::ConfigError, ScenarioError
std::optional<Motion> MotionOf(const RenderArguments& arguments);

/// Cameras of a motion run at a rate: the one asked for, or else the profile's own or the usual.
void SetRate(const RenderArguments& arguments, sim::CameraProfile& profile);

}  // namespace horopter::scenarios
