// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "real_pair.h"
#include "vision/disparity/search_range.h"

namespace horopter::vision::testing {

/// A pair that methods are held against.
struct AccuracyScene {
  std::string name;
  PairWithTruth pair;
  /// That of its disparities, which a rectified pair's publishers state; nothing for a verged one.
  std::optional<SearchRange> range;
};

/// Motorcycle verged in three ways, and the rectified pairs that are there, by name; of these the
/// ones whose name contains `part`.
std::vector<AccuracyScene> RealScenes(const std::string& data_folder, const std::string& part);

/// The same pair with what a camera may add to it.
/// @param sigma_grey deviation of Gaussian noise, drawn for each eye apart
PairWithTruth WithNoise(const PairWithTruth& pair, double sigma_grey);
/// @param gain of the right eye over the left; the darker one is darkened, so that nothing clips
PairWithTruth WithGain(const PairWithTruth& pair, double gain);
/// The right image moved over an edge of its own; what it no longer shows has no truth.
PairWithTruth WithVerticalOffset(const PairWithTruth& pair, int dy);
/// Both images on a black canvas with margins wide enough for every shift up to (200, 30), the
/// right one moved by (dx, dy): no match is lost.
PairWithTruth Shifted(const PairWithTruth& pair, int dx, int dy);

}  // namespace horopter::vision::testing
