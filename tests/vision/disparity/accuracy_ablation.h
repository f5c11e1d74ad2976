// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "accuracy_scenes.h"
#include "vision/disparity/closed_form_config.h"

namespace horopter::vision::testing {

/// The preset "accurate" with one thing changed.
struct Ablation {
  std::string change;
  ClosedFormConfig config;
  bool with_prior = false;  ///< the eyes' pose is known to 0.1 deg
};

/// The preset itself first, then a change for each ingredient of the model.
std::vector<Ablation> Ablations();

/// What became of a verged pair.
struct AblationResult {
  double density = 0, median_px = 0, bad2 = 0, ms = 0;
};
/// @param turn of the right eye, which the prior knows
AblationResult RunAblation(const Ablation& ablation, const PairWithTruth& pair,
                           const EyeTurn& turn);

}  // namespace horopter::vision::testing
