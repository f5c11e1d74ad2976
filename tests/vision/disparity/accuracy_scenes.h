// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/pose.h"
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

/// The turns that RealScenes verges Motorcycle by, in its order.
inline constexpr std::array<EyeTurn, 3> kTurns = {{{2, 0.3, 0.5}, {4, -0.5, 1.5}, {-1, 1, 0}}};

/// Motorcycle's cameras, and where the right one is after a turn (calib.txt of Middlebury 2014, at
/// a quarter of the size).
struct StereoCameras {
  hardware::CameraModel left, right;
};
StereoCameras MotorcycleCameras();
hardware::Pose MotorcyclePose(const EyeTurn& turn);

/// A frame of a data set that `horopter render --truth` made: left.png, right.png and
/// left_disparity.flo.
/// @param folder the data set's; the scene gets its name
/// @throws std::runtime_error naming what cannot be read
AccuracyScene RenderedScene(const std::string& folder);

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
