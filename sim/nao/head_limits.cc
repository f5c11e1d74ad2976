// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/head_limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace horopter::sim {

namespace {

constexpr double kDegree = M_PI / 180;

struct Row {
  double yaw_deg;
  double min_deg;
  double max_deg;
};

// Aldebaran's documentation of HeadPitch, "anti collision limitation".
constexpr std::array kTable{Row{0, -38.5, 29.51},      Row{27.85, -38.5, 24.18},
                            Row{43.32, -31.4, 21.2},   Row{51.74, -27.5, 18.91},
                            Row{62.45, -24.64, 17.19}, Row{87.49, -18.91, 11.46},
                            Row{119.52, -25.73, 18.91}};

}  // namespace

PitchRange NaoPitchRange(double yaw_rad) {
  const double yaw_deg = std::abs(yaw_rad) / kDegree;
  const auto above = std::upper_bound(kTable.begin(), kTable.end(), yaw_deg,
                                      [](double yaw, const Row& row) { return yaw < row.yaw_deg; });
  if (above == kTable.end())
    return {kTable.back().min_deg * kDegree, kTable.back().max_deg * kDegree};
  const Row& low = *(above - 1);
  const double t = (yaw_deg - low.yaw_deg) / (above->yaw_deg - low.yaw_deg);
  return {std::lerp(low.min_deg, above->min_deg, t) * kDegree,
          std::lerp(low.max_deg, above->max_deg, t) * kDegree};
}

hardware::HeadLimits NaoHeadLimits() {
  constexpr double kAcceleration_rad_s2 = 3000 * kDegree;
  const hardware::AxisLimits yaw{-2.08567, 2.08567, 8.268, kAcceleration_rad_s2};
  const hardware::AxisLimits pitch{-0.671952, 0.514872, 7.194, kAcceleration_rad_s2};
  return {yaw, pitch, {}, {}, {}, {}};
}

hardware::HeadAngles NaoReachable(const hardware::HeadAngles& target) {
  const hardware::HeadLimits limits = NaoHeadLimits();
  hardware::HeadAngles reached;
  reached.neck.pan_rad = std::clamp(target.neck.pan_rad, limits[0].min_rad, limits[0].max_rad);
  const PitchRange pitch = NaoPitchRange(reached.neck.pan_rad);
  reached.neck.tilt_rad =
      std::clamp(target.neck.tilt_rad, std::max(limits[1].min_rad, pitch.min_rad),
                 std::min(limits[1].max_rad, pitch.max_rad));
  return reached;
}

}  // namespace horopter::sim
