// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// A picture of any format that OpenCV reads, as it is stored: bits, channels (BGR) and alpha.
/// @param name of the file, for messages
/// @throws FormatError when it cannot be read, or claims more pixels than that many bytes can hold
///         (nothing is allocated for it then)
cv::Mat DecodeImage(std::string_view bytes, const std::string& name);

/// The same from a file. A `.pfm` file keeps its floats.
/// @throws UnusableResults besides, when there is no such file
cv::Mat ReadImage(const std::filesystem::path& file);

/// The bytes of a file that the user named. @throws UnusableResults when it cannot be read
std::string ReadInputFile(const std::filesystem::path& file);

/// A file's extension in lower case, with its dot: ".png".
std::string ExtensionOf(const std::filesystem::path& file);

}  // namespace horopter::scenarios
