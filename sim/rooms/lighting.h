// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/rooms/scene_document.h"

namespace horopter::sim {

/// daylight, evening, lamps, overcast.
std::vector<std::string> LightingNames();

/// What was chosen, for the record.
struct Lighting {
  std::string name;
  double brightness = 1;  ///< of all lights, relative to the name's own
};

/// Dims and tints the scene's lights, each by its part: "lamp" from above, "window", and every
/// other as what the walls throw back. The lamp's direction turns about the vertical.
/// @param kind "varied": the seed chooses one; "as_built": nothing changes; else a LightingNames()
Lighting ApplyLighting(SceneDocument& scene, const std::string& kind, std::uint64_t seed);

}  // namespace horopter::sim
