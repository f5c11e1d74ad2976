// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "scenarios/dataset/flo.h"

namespace horopter::scenarios {

/// What a 16-bit picture can say of a map. Values that do not fit are written as invalid.
struct Packed {
  cv::Mat pixels;    ///< CV_16UC1, or CV_16UC3 in OpenCV's order (blue first)
  int left_out = 0;  ///< valid pixels that did not fit
};

/// KITTI disparity (Geiger et al. 2012): 256 times the disparity in px; 0 = invalid. A disparity is
/// x_left - x_right and positive; what rounds to 0 is written as 1, as the benchmark's own tools
/// do.
/// @param disparity_px NaN = none
Packed PackKittiDisparity(const cv::Mat1f& disparity_px);
/// NaN where invalid.
cv::Mat1f UnpackKittiDisparity(const cv::Mat1w& pixels);

/// KITTI flow: red and green are 64 times dx and dy in px, plus 2^15; blue is 1 where valid, else
/// 0.
Packed PackKittiFlow(const DisplacementMaps& field);
/// NaN where invalid.
DisplacementMaps UnpackKittiFlow(const cv::Mat3w& pixels);

/// Depth in whole steps of 1 / units_per_m (1000: millimetres, as the TUM and ScanNet data sets
/// nearly have it; they differ in the scale); 0 = nothing there.
/// @param depth_m +inf or NaN = nothing there @param units_per_m positive
Packed PackDepth(const cv::Mat1f& depth_m, double units_per_m);
/// +inf where nothing is.
cv::Mat1f UnpackDepth(const cv::Mat1w& pixels, double units_per_m);

/// Ids from 0, written plus one; 0 = nothing there (-1).
/// @throws std::invalid_argument for an id below -1 or above 65534
cv::Mat1w PackIds(const cv::Mat1i& ids);
cv::Mat1i UnpackIds(const cv::Mat1w& pixels);

/// A PNG file of an 8-bit or 16-bit picture. @throws std::invalid_argument when OpenCV cannot
std::string EncodePng(const cv::Mat& pixels);

/// A PNG file of exactly this many channels of 16 bits.
/// @param name of the file, for messages
/// @throws FormatError when it is no PNG, is truncated or damaged, or has other channels or bits
cv::Mat DecodePng16(std::string_view bytes, int channels, const std::string& name);

/// The same to and from a file; it appears whole or not at all. @throws ResultsError besides.
void WritePng(const std::filesystem::path& file, const cv::Mat& pixels);
cv::Mat ReadPng16(const std::filesystem::path& file, int channels);

}  // namespace horopter::scenarios
