// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/png16.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/image_file.h"
#include "scenarios/results/files.h"

namespace horopter::scenarios {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr int kLargest = 65535;
constexpr double kDisparitySteps = 256;
constexpr double kFlowSteps = 64;
constexpr int kFlowZero = 1 << 15;

std::uint32_t BigEndian32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

/// Walks the chunks from the signature to IEND: OpenCV shows a truncated picture as far as it goes.
void RequireWhole(std::string_view bytes, const std::string& name) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  if (bytes.substr(0, kSignature.size()) != kSignature) {
    throw FormatError(fmt::format("{}: no PNG file: the signature is missing", name));
  }
  constexpr std::size_t kAround = 12;  // length, type and check sum of a chunk
  std::size_t at = kSignature.size();
  while (at + kAround <= bytes.size()) {
    const std::size_t length = BigEndian32(bytes, at);
    const bool last = bytes.substr(at + 4, 4) == "IEND";
    if (length > bytes.size() - at - kAround) break;
    at += kAround + length;
    if (!last) continue;
    if (at == bytes.size()) return;
    throw FormatError(
        fmt::format("{}: {} bytes left over after the PNG's end", name, bytes.size() - at));
  }
  throw FormatError(
      fmt::format("{}: truncated: {} bytes without the PNG's last chunk", name, bytes.size()));
}

}  // namespace

Packed PackKittiDisparity(const cv::Mat1f& disparity_px) {
  cv::Mat1w pixels(disparity_px.size(), std::uint16_t{0});
  int left_out = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const double steps = kDisparitySteps * disparity_px(y, x);
      if (!std::isfinite(steps)) continue;
      if (steps > 0 && std::round(steps) <= kLargest) {
        pixels(y, x) = static_cast<std::uint16_t>(std::max(1.0, std::round(steps)));
      } else {
        ++left_out;
      }
    }
  }
  return {pixels, left_out};
}

cv::Mat1f UnpackKittiDisparity(const cv::Mat1w& pixels) {
  cv::Mat1f disparity(pixels.size(), kNaN);
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      if (pixels(y, x) > 0) disparity(y, x) = static_cast<float>(pixels(y, x) / kDisparitySteps);
    }
  }
  return disparity;
}

Packed PackKittiFlow(const DisplacementMaps& field) {
  cv::Mat3w pixels(field.dx.size(), cv::Vec3w(0, 0, 0));
  int left_out = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const double red = std::round(kFlowSteps * field.dx(y, x)) + kFlowZero;
      const double green = std::round(kFlowSteps * field.dy(y, x)) + kFlowZero;
      if (!std::isfinite(red) || !std::isfinite(green)) continue;
      if (std::min(red, green) < 0 || std::max(red, green) > kLargest) {
        ++left_out;
        continue;
      }
      pixels(y, x) = {1, static_cast<std::uint16_t>(green), static_cast<std::uint16_t>(red)};
    }
  }
  return {pixels, left_out};
}

DisplacementMaps UnpackKittiFlow(const cv::Mat3w& pixels) {
  DisplacementMaps field{cv::Mat1f(pixels.size(), kNaN), cv::Mat1f(pixels.size(), kNaN)};
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const cv::Vec3w& bgr = pixels(y, x);
      if (bgr[0] == 0) continue;
      field.dx(y, x) = static_cast<float>((bgr[2] - kFlowZero) / kFlowSteps);
      field.dy(y, x) = static_cast<float>((bgr[1] - kFlowZero) / kFlowSteps);
    }
  }
  return field;
}

Packed PackDepth(const cv::Mat1f& depth_m, double units_per_m) {
  cv::Mat1w pixels(depth_m.size(), std::uint16_t{0});
  int left_out = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const double steps = std::round(units_per_m * depth_m(y, x));
      if (!std::isfinite(steps)) continue;
      if (steps >= 1 && steps <= kLargest) {
        pixels(y, x) = static_cast<std::uint16_t>(steps);
      } else {
        ++left_out;
      }
    }
  }
  return {pixels, left_out};
}

cv::Mat1f UnpackDepth(const cv::Mat1w& pixels, double units_per_m) {
  cv::Mat1f depth(pixels.size(), std::numeric_limits<float>::infinity());
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      if (pixels(y, x) > 0) depth(y, x) = static_cast<float>(pixels(y, x) / units_per_m);
    }
  }
  return depth;
}

cv::Mat1w PackIds(const cv::Mat1i& ids) {
  cv::Mat1w pixels(ids.size());
  for (int y = 0; y < ids.rows; ++y) {
    for (int x = 0; x < ids.cols; ++x) {
      const int id = ids(y, x);
      if (id < -1 || id >= kLargest) {
        throw std::invalid_argument(fmt::format(
            "id {} at ({}, {}): a 16-bit picture takes -1 to {}", id, x, y, kLargest - 1));
      }
      pixels(y, x) = static_cast<std::uint16_t>(id + 1);
    }
  }
  return pixels;
}

cv::Mat1i UnpackIds(const cv::Mat1w& pixels) {
  cv::Mat1i ids(pixels.size());
  for (int y = 0; y < ids.rows; ++y) {
    for (int x = 0; x < ids.cols; ++x) ids(y, x) = pixels(y, x) - 1;
  }
  return ids;
}

std::string EncodePng(const cv::Mat& pixels) {
  const bool good_depth = pixels.depth() == CV_8U || pixels.depth() == CV_16U;
  if (pixels.empty() || !good_depth || (pixels.channels() != 1 && pixels.channels() != 3)) {
    throw std::invalid_argument("a PNG picture has one or three channels of 8 or 16 bits");
  }
  std::vector<uchar> bytes;
  cv::imencode(".png", pixels, bytes);
  return {bytes.begin(), bytes.end()};
}

cv::Mat DecodePng16(std::string_view bytes, int channels, const std::string& name) {
  RequireWhole(bytes, name);
  const cv::Mat pixels = DecodeImage(bytes, name);
  if (pixels.depth() != CV_16U || pixels.channels() != channels) {
    throw FormatError(fmt::format("{}: {} channels of {} bits, expected {} of 16", name,
                                  pixels.channels(), 8 * pixels.elemSize1(), channels));
  }
  return pixels;
}

void WritePng(const std::filesystem::path& file, const cv::Mat& pixels) {
  WriteFileAtomically(file, EncodePng(pixels), Durability::kProcess);
}

cv::Mat ReadPng16(const std::filesystem::path& file, int channels) {
  return DecodePng16(ReadFile(file), channels, file.string());
}

}  // namespace horopter::scenarios
