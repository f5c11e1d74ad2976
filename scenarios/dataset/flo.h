// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// A field of displacements: what is at (x, y) in one image is at (x + dx, y + dy) in another.
struct DisplacementMaps {
  cv::Mat1f dx;  ///< [px]; NaN = unknown
  cv::Mat1f dy;
};

/// The Middlebury flow format (Baker et al. 2011; vision.middlebury.edu/flow): the float 202021.25,
/// width and height as 32-bit integers, then dx and dy of each pixel row by row, all little-endian.
/// A component above 1e9 means that the pixel is unknown; NaN is written as 1e10.
/// @throws std::invalid_argument when the maps differ in size or are empty
std::string EncodeFlo(const DisplacementMaps& field);

/// @param name of the file, for messages
/// @throws FormatError for another magic number (naming a file of the wrong byte order), a size
///         outside 1 to 99999, or bytes missing or left over
DisplacementMaps DecodeFlo(std::string_view bytes, const std::string& name);

/// The same to and from a file; it appears whole or not at all. @throws ResultsError besides.
void WriteFlo(const std::filesystem::path& file, const DisplacementMaps& field);
DisplacementMaps ReadFlo(const std::filesystem::path& file);

}  // namespace horopter::scenarios
