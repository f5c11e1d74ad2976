// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "control/kinematics/fixation.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"

namespace horopter::control {

/// How the two optical axes stand to each other.
enum class Gaze {
  kConverging,  ///< both pass through the target
  kParallel,    ///< parallel to each other; the line midway between them passes through the target
};

struct LookAtOptions {
  Gaze gaze = Gaze::kConverging;
  /// Where the neck's pan stays while the eyes alone turn aside. Nothing: it turns until the target
  /// is straight ahead, or as far as it can, and the eyes do the rest.
  std::optional<double> neck_pan_rad{};
};

/// Inverse kinematics of a head with neck pan, elevation and a pan (vergence) axis per eye.
///
/// Closed form of the four-axis model (Davison's SceneLib, "full Yorick"), in body axes, with P, C,
/// I and N as HeadGeometry names them. First the neck's pan: for symmetric vergence atan2(y, x) of
/// the target seen from the pan axis. The target turned back by the pan is (x, y, z) from there;
/// with A = hypot(x - P, z - pan_to_tilt) the elevation that takes it into the eyes' plane is
/// atan2(z - pan_to_tilt, x - P) - asin(C / A), and f = sqrt(A^2 - C^2) is how far in front of H it
/// then is. Each eye pans by atan2 of the target seen from its own axis, atan2(y -+ I/2, f); N
/// lies on the optical axis and turns no angle. Parallel eyes both pan by atan2(y, f).
///
/// The answer keeps every limit. A target that needs more neck pan than there is stays reachable
/// as long as the eyes' pan makes up for it. A head without eye axes (NAO) always looks with
/// parallel axes.
/// @param pair geometry of the pair that is to look; for one of several pairs see ForPair()
/// @param p_BT target in the base frame [m]
Fixation LookAt(const hardware::HeadGeometry& pair, const hardware::HeadLimits& limits,
                const Eigen::Vector3d& p_BT, const LookAtOptions& options = {});

/// Where a pair of cameras stands on the eyes of a head, relative to the pair that the head's
/// geometry is given for. Optical axes of all pairs are parallel, and above each other.
struct PairMount {
  double above_m = 0;  ///< along the eyes' pan axes
  double ahead_m = 0;  ///< along the optical axes
};

/// The head's geometry as another of its pairs has it. A pair mounted higher on the pan axes has
/// only a longer lever C to the elevation axis; one mounted farther ahead a longer N.
/// @throws hardware::ConfigError when the pair would stand behind its pan axes or below the
///         elevation axis, which HeadGeometry does not describe
hardware::HeadGeometry ForPair(const hardware::HeadGeometry& head, const PairMount& mount);

}  // namespace horopter::control
