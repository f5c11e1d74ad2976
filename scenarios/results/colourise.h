// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "vision/disparity/disparity_field.h"
#include "vision/regions/region.h"

namespace horopter::scenarios {

/// Colour maps of the pictures. kDepth and kRange are sequential (viridis: lightness changes
/// steadily, readable without colour vision); the other two diverge from a light middle that stands
/// for zero.
enum class ColourMap {
  kDepth,        ///< yellow near to violet far, logarithmic: equal steps are equal ratios
  kRange,        ///< yellow low to violet high, linear
  kDisparity,    ///< orange negative (nearer than fixation), white zero, violet positive
  kSignedError,  ///< blue negative (too near), white zero, red positive (too far)
};

/// Colour at a fraction of the scale; fractions outside [0, 1] take the end's colour.
/// @return BGR; the colour of invalid pixels' background for NaN
cv::Vec3b MapColour(ColourMap map, double fraction);

/// Pixels without a value (NaN, infinite; for depth also <= 0) are dark grey with a lighter
/// diagonal hatch, which no map contains. All return CV_8UC3 BGR of the input's size.
/// @throws std::invalid_argument unless 0 < near_m < far_m
cv::Mat3b ColouriseDepth(const cv::Mat1f& depth_m, double near_m, double far_m);

/// The horizontal component of a vector disparity: white is the horopter.
/// @throws std::invalid_argument unless limit_px > 0
cv::Mat3b ColouriseDisparity(const vision::DisparityField& field, double limit_px);

/// Any values on a linear scale from low to high.
/// @throws std::invalid_argument unless low < high
cv::Mat3b ColouriseValues(const cv::Mat1f& values, ColourMap map, double low, double high);

/// @param error of any unit, e.g. (Z - Z*) / Z*
/// @throws std::invalid_argument unless limit > 0
cv::Mat3b ColouriseSignedError(const cv::Mat1f& error, double limit);

/// The image, greyed, under its regions: each tinted by its mean depth, outlined, and, where there
/// is room, labelled with it in metres. Regions without depth stay grey.
/// @throws std::invalid_argument when sizes differ or the scale is no scale
cv::Mat3b DrawRegions(const cv::Mat& image_bgr, const vision::RegionMap& regions, double near_m,
                      double far_m);

/// The map as a horizontal bar with its end and middle values below it, and the swatch of invalid
/// pixels. @param width_px at least 160
cv::Mat3b LegendStrip(ColourMap map, double low, double high, const std::string& unit,
                      int width_px);

}  // namespace horopter::scenarios
