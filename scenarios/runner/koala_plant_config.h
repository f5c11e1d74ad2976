// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenarios/format/robot_description.h"
#include "sim/koala/koala_plant.h"

namespace horopter::scenarios {

/// The simulated base of a robot's wheels.
sim::KoalaPlantConfig KoalaPlantConfigOf(const WheelsDescription& wheels);

}  // namespace horopter::scenarios
