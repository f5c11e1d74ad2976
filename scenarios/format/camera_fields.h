// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenarios/format/field_visitor.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// The table of a scenario's `camera:`. Width and height outside their range stand for a size that
/// is chosen elsewhere.
void Visit(FieldVisitor& v, CameraSpec& camera);

/// Reads a YAML file of the keys of a scenario's `camera:`, as strictly as a scenario.
/// @param defaults what the keys that are left out mean
/// @throws ScenarioError with everything that is wrong with it, or that it cannot be read
CameraSpec ReadCameraFile(const std::filesystem::path& path, CameraSpec defaults = {});

}  // namespace horopter::scenarios
