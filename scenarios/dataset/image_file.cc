// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/image_header.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/results/files.h"
#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace {

/// Deflate packs at most 1032 bytes into one, of eight pixels each; no other format packs more.
constexpr std::int64_t kMostPixelsPerByte = 8 * 1032;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;  // 8K has 2^25

/// Refuses a header that claims what so few bytes cannot hold: decoders allocate first.
void RequirePlausibleSize(const ImageHeader& header, std::string_view bytes,
                          const std::string& name) {
  if (!header.size) return;
  const std::int64_t pixels = std::int64_t{header.size->width} * header.size->height;
  const std::int64_t most =
      std::min(kMostPixels, kMostPixelsPerByte * static_cast<std::int64_t>(bytes.size()));
  if (pixels <= most) return;
  throw FormatError(fmt::format("{}: damaged {}, or too large: {} x {} pixels in {} bytes", name,
                                header.format, header.size->width, header.size->height,
                                bytes.size()));
}

}  // namespace

cv::Mat DecodeImage(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw FormatError(fmt::format("{}: empty file", name));
  const std::optional<ImageHeader> header = ReadImageHeader(bytes);
  if (header) RequirePlausibleSize(*header, bytes, name);
  const std::string damaged =
      header ? fmt::format("{}: damaged {}", name, header->format)
             : fmt::format("{}: no image of a known format (PNG, JPEG, PGM, PPM, BMP, TIFF)", name);
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& e) {
    throw FormatError(fmt::format("{}: {}", damaged, e.err));
  }
  if (pixels.empty()) throw FormatError(damaged);
  return pixels;
}

std::string ReadInputFile(const std::filesystem::path& file) {
  try {
    return ReadFile(file);
  } catch (const ResultsError& error) {
    throw UnusableResults(error.what());  // named by the user: bad input, not a fault of the disk
  }
}

cv::Mat ReadImage(const std::filesystem::path& file) {
  const std::string bytes = ReadInputFile(file);
  return ExtensionOf(file) == ".pfm" ? DecodePfm(bytes, file.string())
                                     : DecodeImage(bytes, file.string());
}

std::string ExtensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace horopter::scenarios
