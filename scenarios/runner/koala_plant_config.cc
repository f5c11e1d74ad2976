// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/koala_plant_config.h"

namespace horopter::scenarios {

sim::KoalaPlantConfig KoalaPlantConfigOf(const WheelsDescription& wheels) {
  sim::KoalaPlantConfig plant;
  plant.metres_per_pulse = wheels.properties.metres_per_pulse;
  plant.pulses_per_turn = wheels.pulses_per_turn;
  plant.max_wheel_speed_m_s = wheels.properties.max_wheel_speed_m_s;
  plant.max_wheel_acceleration_m_s2 = wheels.max_acceleration_m_s2;
  plant.deadman = hardware::FromSeconds(wheels.deadman_s);
  return plant;
}

}  // namespace horopter::scenarios
