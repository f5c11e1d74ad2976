// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/camera_model.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// Of either camera of a pair; size and field of view are the pair's own where none is asked for
/// (RenderRequest::kNative, kRobotsOwn). @throws hardware::ConfigError
hardware::CameraModel CameraModelOf(const CameraSpec& asked, const CameraPairDescription& native);

}  // namespace horopter::scenarios
