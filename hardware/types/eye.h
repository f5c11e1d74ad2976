// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace horopter::hardware {

/// Left and right are the robot's own.
enum class Eye { kLeft, kRight };

inline constexpr Eye kBothEyes[] = {Eye::kLeft, Eye::kRight};

inline const char* ToString(Eye eye) { return eye == Eye::kLeft ? "left" : "right"; }

/// The same thing for either eye.
template <typename T>
struct PerEye {
  T left{};
  T right{};

  T& operator[](Eye eye) { return eye == Eye::kLeft ? left : right; }
  const T& operator[](Eye eye) const { return eye == Eye::kLeft ? left : right; }
};

}  // namespace horopter::hardware
