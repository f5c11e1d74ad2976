// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <string_view>

namespace horopter::scenarios {

/// What the first bytes of a picture say, before anything is allocated for it.
struct ImageHeader {
  std::string_view format;       ///< "PNG", "JPEG", "PNM", "BMP" or "TIFF"
  std::optional<cv::Size> size;  ///< nothing where the header ends early or makes no sense
};

/// Nothing for a file that does not begin as one of these formats does.
std::optional<ImageHeader> ReadImageHeader(std::string_view bytes);

}  // namespace horopter::scenarios
