// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "vision/disparity/disparity_field.h"

namespace horopter::vision::testing {

/// Where the published stereo pairs lie: $HOROPTER_DATA_DIR, else ../shared/data beside the
/// sources; nothing where neither holds motorcycle/.
std::optional<std::string> DataFolder();

/// What to tell whoever runs a test without the data.
inline constexpr char kDataRemedy[] =
    "the Motorcycle pair is not there: put left.png, right.png and disparity.pfm (Middlebury 2014, "
    "as scikit-image ships it) into a folder motorcycle/ and set HOROPTER_DATA_DIR to its parent";

/// Reads a one-channel PFM (bottom row first). @throws std::runtime_error naming the path.
cv::Mat1f ReadPfm(const std::string& path);

/// A pair and the true vector disparity of its left image.
struct PairWithTruth {
  cv::Mat left;
  cv::Mat right;
  cv::Mat1f dx;  ///< NaN where unknown, or where the match lies outside the right image
  cv::Mat1f dy;
};

/// The right camera turned about its optical centre, in degrees: pan to the left, tilt down, roll
/// counter-clockwise, so that what it shows moves right, up and clockwise.
struct EyeTurn {
  double pan_deg = 0;
  double tilt_deg = 0;
  double roll_deg = 0;
};

/// Middlebury's Motorcycle as a verged head would see it: the right image and the truth are
/// carried through the homography of the turn. Occluded pixels keep their truth.
PairWithTruth VergedMotorcycle(const std::string& data_folder, const EyeTurn& turn);

/// A published pair as it is, rectified: "motorcycle", "teddy" or "reindeer".
PairWithTruth RectifiedPair(const std::string& data_folder, const std::string& name);

/// Middlebury's Aloe, as OpenCV ships it (1282x1110, disparities of 43 to 211 px); nothing where
/// Debian's opencv-doc is not installed.
inline constexpr char kAloeFolder[] = "/usr/share/doc/opencv-doc/examples/data/";
std::optional<PairWithTruth> AloePair();

/// How a field compares with the truth, over the pixels that have one.
struct FieldScore {
  double density = 0;          ///< share that is valid
  double median_error_px = 0;  ///< of the distance between vectors, over the valid
  double bad2 = 0;             ///< share of the valid off by more than 2 px
};
/// @throws std::invalid_argument as ScoreDisparity()
FieldScore Score(const DisparityField& field, const cv::Mat1f& true_dx, const cv::Mat1f& true_dy);

}  // namespace horopter::vision::testing
