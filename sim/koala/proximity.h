// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sim/world/world.h"

namespace horopter::sim {

inline constexpr int kKoalaProximityCount = 16;

/// The Koala's 16 infrared proximity sensors, as rays from the sites ir_0 to ir_15 along their z
/// axes. Values are 10-bit: 1023 at contact, falling linearly to 0 at the sensor's range (0.5 m,
/// 0.35 m for the four at the corners). In the order of the robot's `N` answer: 0 to 7 left from
/// front to rear, 8 to 15 right from front to rear.
class KoalaProximity {
 public:
  /// @throws SceneError when a site is missing
  explicit KoalaProximity(const World& world);

  std::array<int, kKoalaProximityCount> Read(const World& world) const;

 private:
  std::array<int, kKoalaProximityCount> sites_{};
};

}  // namespace horopter::sim
