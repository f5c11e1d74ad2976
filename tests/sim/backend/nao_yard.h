// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "sim/backend/nao_simulation.h"

namespace horopter::sim {

/// A NAO on open ground, with small images and feet that do not slip.
inline NaoSimulationConfig NaoInYard() {
  NaoSimulationConfig config;
  config.scene = std::filesystem::path(HOROPTER_SOURCE_DIR) / "tests" / "sim" / "backend" /
                 "data/nao_yard.xml";
  config.variation.heading_rad = 0;
  config.camera = NaoCamera(NaoLens::kWide, 64, 48);
  config.gait.slip_gain = config.gait.slip_step = config.gait.slip_turn_rad = 0;
  return config;
}

}  // namespace horopter::sim
