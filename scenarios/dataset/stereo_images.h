// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// An image and what messages call it.
struct NamedImage {
  std::string name;
  cv::Mat pixels;
};

/// A pair as vision::DisparityEstimator takes it.
struct StereoImages {
  cv::Mat left;                    ///< CV_8UC1 or CV_8UC3 (BGR)
  cv::Mat right;                   ///< of the same size and type
  std::vector<std::string> notes;  ///< what was changed beyond scaling, a line each
};

/// Makes a pair of images of any depth, grey or colour.
///
/// More than 8 bits are scaled by one factor for both eyes, so that their contrasts stay alike: the
/// full scale is that of the least number of bits, 8 to 16, that 99.9 % of all values fit into
/// (cameras of 10 or 12 bits write them into 16; single hot pixels saturate); of floats up to 1, it
/// is 1. Where only one eye has more than 8 bits it is scaled by itself, and that is noted. Colour
/// beside grey becomes grey, which is noted, and alpha is left out.
/// @throws FormatError naming the file: different sizes (both stated), or a float that is NaN or
///         infinite (with its place)
StereoImages ConvertStereoImages(const NamedImage& left, const NamedImage& right);

/// The same from files. @throws as ReadImage() besides
StereoImages ReadStereoImages(const std::filesystem::path& left,
                              const std::filesystem::path& right);

}  // namespace horopter::scenarios
