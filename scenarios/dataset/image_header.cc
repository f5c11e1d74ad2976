// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/image_header.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>

namespace horopter::scenarios {
namespace {

/// Big-endian or little-endian numbers of two or four bytes; zero beyond the end.
class HeaderBytes {
 public:
  explicit HeaderBytes(std::string_view bytes) : bytes_(bytes) {}

  std::int64_t Big(std::size_t at, int count) const { return Number(at, count, true); }
  std::int64_t Little(std::size_t at, int count) const { return Number(at, count, false); }
  std::int64_t Number(std::size_t at, int count, bool big_endian) const {
    std::int64_t value = 0;
    for (int i = 0; i < count; ++i) {
      value = value << 8 | Byte(at + static_cast<std::size_t>(big_endian ? i : count - 1 - i));
    }
    return value;
  }
  bool Has(std::size_t at, std::size_t count) const {
    return at <= bytes_.size() && count <= bytes_.size() - at;
  }
  std::string_view text() const { return bytes_; }

 private:
  std::int64_t Byte(std::size_t at) const {
    return at < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at]) : 0;
  }
  std::string_view bytes_;
};

/// Sides too large for an int, or negative, are as good as infinite.
cv::Size SizeOf(std::int64_t width, std::int64_t height) {
  static constexpr std::int64_t kLargest = 1 << 30;
  const auto side = [](std::int64_t v) {
    return static_cast<int>(v < 0 ? kLargest : std::min(v, kLargest));
  };
  return {side(width), side(height)};
}

/// The frame header (SOF0 to SOF15, but for three markers that are none) behind other segments.
std::optional<cv::Size> JpegSize(const HeaderBytes& bytes) {
  std::size_t at = 2;
  while (bytes.Has(at, 9)) {
    const std::int64_t marker = bytes.Big(at, 2);
    if (marker < 0xff00) return std::nullopt;
    const bool frame = marker >= 0xffc0 && marker <= 0xffcf && marker != 0xffc4 &&
                       marker != 0xffc8 && marker != 0xffcc;
    if (frame) return SizeOf(bytes.Big(at + 7, 2), bytes.Big(at + 5, 2));
    const bool filling = marker == 0xffff;
    at += filling ? 1 : 2 + static_cast<std::size_t>(bytes.Big(at + 2, 2));
  }
  return std::nullopt;
}

/// "P5 640 480", with comments.
std::optional<cv::Size> PnmSize(const HeaderBytes& bytes) {
  const std::string_view text = bytes.text();
  std::int64_t sides[2] = {0, 0};
  std::size_t at = 2;
  for (std::int64_t& side : sides) {
    while (at < text.size() &&
           (std::isspace(static_cast<unsigned char>(text[at])) != 0 || text[at] == '#')) {
      at = text[at] == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
    }
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), side);
    if (error != std::errc()) return std::nullopt;
    at = static_cast<std::size_t>(end - text.data());
  }
  return SizeOf(sides[0], sides[1]);
}

/// Tags 256 and 257 of the first directory.
std::optional<cv::Size> TiffSize(const HeaderBytes& bytes, bool big_endian) {
  const auto directory = static_cast<std::size_t>(bytes.Number(4, 4, big_endian));
  const std::int64_t entries = bytes.Number(directory, 2, big_endian);
  std::int64_t sides[2] = {0, 0};
  for (std::int64_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * static_cast<std::size_t>(i);
    if (!bytes.Has(at, 12)) return std::nullopt;
    const std::int64_t tag = bytes.Number(at, 2, big_endian);
    constexpr std::int64_t kShort = 3;
    const int width = bytes.Number(at + 2, 2, big_endian) == kShort ? 2 : 4;
    if (tag == 256 || tag == 257) sides[tag - 256] = bytes.Number(at + 8, width, big_endian);
  }
  return SizeOf(sides[0], sides[1]);
}

}  // namespace

std::optional<ImageHeader> ReadImageHeader(std::string_view bytes) {
  const HeaderBytes header(bytes);
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) {
    return ImageHeader{"PNG", SizeOf(header.Big(16, 4), header.Big(20, 4))};
  }
  if (bytes.starts_with("\xff\xd8\xff")) return ImageHeader{"JPEG", JpegSize(header)};
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    return ImageHeader{"PNM", PnmSize(header)};
  }
  if (bytes.starts_with("BM")) {
    const auto width = static_cast<std::int32_t>(header.Little(18, 4));
    const auto height = static_cast<std::int32_t>(header.Little(22, 4));
    // Negative: the top row comes first.
    return ImageHeader{"BMP", SizeOf(width, std::abs(std::int64_t{height}))};
  }
  if (bytes.starts_with(std::string_view("II*\0", 4))) {
    return ImageHeader{"TIFF", TiffSize(header, false)};
  }
  if (bytes.starts_with(std::string_view("MM\0*", 4))) {
    return ImageHeader{"TIFF", TiffSize(header, true)};
  }
  return std::nullopt;
}

}  // namespace horopter::scenarios
