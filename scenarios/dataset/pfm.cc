// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/pfm.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/little_endian.h"
#include "scenarios/results/files.h"

namespace horopter::scenarios {
namespace {

constexpr int kLargestSide = 99999;

bool IsSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The header's words, each ended by white space; of that after the last word exactly one byte
/// belongs to the header.
class Header {
 public:
  Header(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::string_view Word(const char* what) {
    constexpr std::size_t kLongest = 32;  // far beyond any number; pixels are not searched
    while (at_ < bytes_.size() && IsSpace(bytes_[at_])) ++at_;
    const std::size_t begin = at_;
    const std::size_t limit = std::min(bytes_.size(), begin + kLongest);
    while (at_ < limit && !IsSpace(bytes_[at_])) ++at_;
    if (at_ == limit) {
      throw FormatError(fmt::format("{}: truncated or no .pfm header: no {}", name_, what));
    }
    return bytes_.substr(begin, at_++ - begin);
  }

  template <typename Number>
  Number Parse(const char* what) {
    const std::string_view word = Word(what);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) {
      throw FormatError(fmt::format("{}: {} '{}' is no number", name_, what, word));
    }
    return number;
  }

  std::size_t end() const { return at_; }

 private:
  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

std::uint32_t Swapped(std::uint32_t v) {
  return v >> 24 | (v >> 8 & 0xff00) | (v << 8 & 0xff0000) | v << 24;
}

}  // namespace

std::string EncodePfm(const cv::Mat& map) {
  if (map.empty() || (map.type() != CV_32FC1 && map.type() != CV_32FC3)) {
    throw std::invalid_argument("a .pfm file holds 32-bit floats in one or three channels");
  }
  std::string bytes =
      fmt::format("{}\n{} {}\n-1.0\n", map.channels() == 1 ? "Pf" : "PF", map.cols, map.rows);
  const int row_floats = map.cols * map.channels();
  bytes.reserve(bytes.size() + 4 * map.total() * map.channels());
  for (int y = map.rows - 1; y >= 0; --y) {
    const float* row = map.ptr<float>(y);
    for (int i = 0; i < row_floats; ++i) {
      AppendFloat(std::isnan(row[i]) ? std::numeric_limits<float>::infinity() : row[i], &bytes);
    }
  }
  return bytes;
}

cv::Mat DecodePfm(std::string_view bytes, const std::string& name) {
  const std::string_view magic = bytes.substr(0, 2);
  if (magic != "Pf" && magic != "PF") {
    throw FormatError(fmt::format("{}: no .pfm file: it begins with neither Pf nor PF", name));
  }
  Header header(bytes, name);
  header.Word("magic number");
  const int width = header.Parse<int>("width"), height = header.Parse<int>("height");
  const double scale = header.Parse<double>("scale");
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw FormatError(
        fmt::format("{}: size {} x {}: both must be 1 to {}", name, width, height, kLargestSide));
  }
  if (!std::isfinite(scale) || scale == 0) {
    throw FormatError(
        fmt::format("{}: scale {}: its sign gives the byte order, so it must be a "
                    "number other than zero",
                    name, scale));
  }
  const int channels = magic == "Pf" ? 1 : 3;
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(width) * channels;
  const std::size_t expected = header.end() + row_bytes * height;
  if (bytes.size() != expected) {
    throw FormatError(fmt::format("{}: {}: {} bytes, {} x {} x {} floats take {}", name,
                                  bytes.size() < expected ? "truncated" : "bytes left over",
                                  bytes.size(), width, height, channels, expected));
  }
  cv::Mat map(height, width, CV_32FC(channels));
  std::size_t at = header.end();
  for (int y = height - 1; y >= 0; --y) {
    float* row = map.ptr<float>(y);
    for (int i = 0; i < width * channels; ++i, at += 4) {
      const std::uint32_t bits = Read32(bytes, at);
      row[i] = std::bit_cast<float>(scale < 0 ? bits : Swapped(bits));
    }
  }
  return map;
}

void WritePfm(const std::filesystem::path& file, const cv::Mat& map) {
  WriteFileAtomically(file, EncodePfm(map), Durability::kProcess);
}

cv::Mat ReadPfm(const std::filesystem::path& file) {
  return DecodePfm(ReadFile(file), file.string());
}

}  // namespace horopter::scenarios
