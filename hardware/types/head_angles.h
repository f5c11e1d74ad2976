// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "hardware/types/eye.h"

namespace horopter::hardware {

/// Pan and tilt about one point, right-handed in body frames: pan positive to the left (about z),
/// then tilt positive down (about y).
struct PanTilt {
  double pan_rad = 0;
  double tilt_rad = 0;
};

/// Angles of a stereo head: a neck that turns both eyes, then pan and tilt of each eye.
///
/// One type for the three heads of the papers. Koala: eyes only, neck zero. NAO: neck only (yaw and
/// pitch), eyes zero. Yorick: neck pan and elevation, and a vergence (pan) per eye. An axis that a
/// head does not have reads zero and has limits [0, 0].
struct HeadAngles {
  PanTilt neck;
  PanTilt left;
  PanTilt right;

  const PanTilt& eye(Eye e) const { return e == Eye::kLeft ? left : right; }
  PanTilt& eye(Eye e) { return e == Eye::kLeft ? left : right; }
};

/// The six axes in the order used for every per-axis array.
enum class HeadAxis { kNeckPan, kNeckTilt, kLeftPan, kLeftTilt, kRightPan, kRightTilt };
inline constexpr int kHeadAxisCount = 6;
inline constexpr std::array<std::string_view, kHeadAxisCount> kHeadAxisNames = {
    "neck_pan", "neck_tilt", "left_pan", "left_tilt", "right_pan", "right_tilt"};

using HeadAxisArray = std::array<double, kHeadAxisCount>;

inline HeadAxisArray ToArray(const HeadAngles& a) {
  return {a.neck.pan_rad,  a.neck.tilt_rad, a.left.pan_rad,
          a.left.tilt_rad, a.right.pan_rad, a.right.tilt_rad};
}

inline HeadAngles FromArray(const HeadAxisArray& a) {
  return {{a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]}};
}

/// What one axis can do. An axis that does not exist has min = max = 0.
struct AxisLimits {
  double min_rad = 0;
  double max_rad = 0;
  double max_speed_rad_s = 0;
  double max_acceleration_rad_s2 = 0;

  bool exists() const { return max_rad > min_rad; }
};

using HeadLimits = std::array<AxisLimits, kHeadAxisCount>;

}  // namespace horopter::hardware
