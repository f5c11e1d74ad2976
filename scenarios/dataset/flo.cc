// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/flo.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/little_endian.h"
#include "scenarios/results/files.h"

namespace horopter::scenarios {
namespace {

constexpr std::string_view kMagic = "PIEH";  // the bytes of 202021.25f
constexpr std::size_t kHeaderBytes = 12;
constexpr float kUnknown = 1e10f;
constexpr float kUnknownAbove = 1e9f;
constexpr int kLargestSide = 99999;  // what Middlebury's own reader takes

}  // namespace

std::string EncodeFlo(const DisplacementMaps& field) {
  if (field.dx.empty() || field.dx.size() != field.dy.size()) {
    throw std::invalid_argument(
        fmt::format("flow of {}x{} and {}x{} pixels: both components must "
                    "have one size, and not none",
                    field.dx.cols, field.dx.rows, field.dy.cols, field.dy.rows));
  }
  std::string bytes(kMagic);
  bytes.reserve(kHeaderBytes + 8 * field.dx.total());
  Append32(static_cast<std::uint32_t>(field.dx.cols), &bytes);
  Append32(static_cast<std::uint32_t>(field.dx.rows), &bytes);
  for (int y = 0; y < field.dx.rows; ++y) {
    for (int x = 0; x < field.dx.cols; ++x) {
      const float dx = field.dx(y, x), dy = field.dy(y, x);
      const bool known = std::isfinite(dx) && std::isfinite(dy);
      AppendFloat(known ? dx : kUnknown, &bytes);
      AppendFloat(known ? dy : kUnknown, &bytes);
    }
  }
  return bytes;
}

DisplacementMaps DecodeFlo(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kHeaderBytes) {
    throw FormatError(fmt::format("{}: truncated: {} bytes, a .flo header has {}", name,
                                  bytes.size(), kHeaderBytes));
  }
  if (bytes.substr(0, 4) == "HEIP") {
    throw FormatError(
        fmt::format("{}: a .flo file in big-endian order: the format is "
                    "little-endian; convert it where it was made",
                    name));
  }
  if (bytes.substr(0, 4) != kMagic) {
    throw FormatError(fmt::format("{}: no .flo file: it does not begin with PIEH", name));
  }
  const auto width = static_cast<std::int32_t>(Read32(bytes, 4));
  const auto height = static_cast<std::int32_t>(Read32(bytes, 8));
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw FormatError(
        fmt::format("{}: size {} x {}: both must be 1 to {}", name, width, height, kLargestSide));
  }
  const std::size_t expected = kHeaderBytes + 8 * static_cast<std::size_t>(width) * height;
  if (bytes.size() != expected) {
    throw FormatError(fmt::format("{}: {}: {} bytes, {} x {} pixels take {}", name,
                                  bytes.size() < expected ? "truncated" : "bytes left over",
                                  bytes.size(), width, height, expected));
  }
  DisplacementMaps field{cv::Mat1f(height, width), cv::Mat1f(height, width)};
  std::size_t at = kHeaderBytes;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, at += 8) {
      const float dx = ReadFloat(bytes, at), dy = ReadFloat(bytes, at + 4);
      const bool known = std::abs(dx) <= kUnknownAbove && std::abs(dy) <= kUnknownAbove;
      field.dx(y, x) = known ? dx : std::numeric_limits<float>::quiet_NaN();
      field.dy(y, x) = known ? dy : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return field;
}

void WriteFlo(const std::filesystem::path& file, const DisplacementMaps& field) {
  WriteFileAtomically(file, EncodeFlo(field), Durability::kProcess);
}

DisplacementMaps ReadFlo(const std::filesystem::path& file) {
  return DecodeFlo(ReadFile(file), file.string());
}

}  // namespace horopter::scenarios
