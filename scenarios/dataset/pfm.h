// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// The portable float map of Debevec's HDR Shop, as the Middlebury stereo benchmark uses it: "Pf"
/// (one channel) or "PF" (three), width and height, a scale whose sign gives the byte order
/// (negative: little-endian), each ended by white space, then the rows from the bottom up.
///
/// Written little-endian with scale -1; NaN becomes +infinity, the benchmark's sign for "unknown".
/// @param map CV_32FC1 or CV_32FC3; channels in their order in memory
/// @throws std::invalid_argument for any other type, or an empty map
std::string EncodePfm(const cv::Mat& map);

/// Either byte order. The scale's magnitude is a unit of brightness and not applied, as the
/// benchmark does not either.
/// @param name of the file, for messages
/// @throws FormatError for another magic number, a header that is none, a size outside 1 to 99999,
///         a scale of zero, or bytes missing or left over
cv::Mat DecodePfm(std::string_view bytes, const std::string& name);

/// The same to and from a file; it appears whole or not at all. @throws ResultsError besides.
void WritePfm(const std::filesystem::path& file, const cv::Mat& map);
cv::Mat ReadPfm(const std::filesystem::path& file);

}  // namespace horopter::scenarios
