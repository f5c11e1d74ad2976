// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/disparity_files.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/image_file.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"

namespace horopter::scenarios {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

[[noreturn]] void ThrowUnknownFormat(const std::filesystem::path& file, const char* known) {
  throw std::invalid_argument(fmt::format("{}: unknown disparity format '{}': known are {}",
                                          file.string(), ExtensionOf(file), known));
}

cv::Mat1f Scaled(const cv::Mat1f& map, double factor) {
  cv::Mat1f out;
  map.convertTo(out, CV_32F, factor);
  return out;
}

/// Pictures whose channels are equal are as good as grey.
cv::Mat OneChannel(const cv::Mat& pixels, const std::string& name) {
  if (pixels.channels() == 1) return pixels;
  std::vector<cv::Mat> channels;
  cv::split(pixels, channels);
  for (std::size_t i = 1; i < std::min<std::size_t>(channels.size(), 3); ++i) {
    if (cv::norm(channels[0], channels[i], cv::NORM_INF) > 0) {
      throw FormatError(fmt::format(
          "{}: a colour picture holds no disparity: expected grey levels, or KITTI's 16 bits",
          name));
    }
  }
  return channels[0];
}

vision::DisparityMaps OfPicture(const cv::Mat& pixels, double scale, bool png,
                                const std::string& name) {
  if (png && pixels.type() == CV_16UC3) {
    const DisplacementMaps flow = UnpackKittiFlow(pixels);
    return {flow.dx, flow.dy};
  }
  const cv::Mat grey = OneChannel(pixels, name);
  if (grey.depth() != CV_8U && grey.depth() != CV_16U) {
    throw FormatError(fmt::format("{}: expected 8 or 16 bits", name));
  }
  if (png && grey.depth() == CV_16U) return {Scaled(UnpackKittiDisparity(grey), -1), {}};
  cv::Mat1f dx;
  grey.convertTo(dx, CV_32F, -1 / scale);
  dx.setTo(kNaN, grey == 0);
  return {dx, {}};
}

}  // namespace

void RequireDisparityFormat(const std::filesystem::path& file) {
  const std::string extension = ExtensionOf(file);
  if (extension != ".flo" && extension != ".pfm" && extension != ".png") {
    ThrowUnknownFormat(file, ".flo, .pfm, .png");
  }
}

int WriteDisparity(const std::filesystem::path& file, const vision::DisparityField& field) {
  RequireDisparityFormat(file);
  const std::string extension = ExtensionOf(file);
  if (extension == ".flo") {
    WriteFlo(file, {field.dx, field.dy});
    return 0;
  }
  const cv::Mat1f disparity = Scaled(field.dx, -1);
  if (extension == ".pfm") {
    WritePfm(file, disparity);
    return 0;
  }
  const Packed packed = PackKittiDisparity(disparity);
  WritePng(file, packed.pixels);
  return packed.left_out;
}

vision::DisparityMaps ReadDisparity(const std::filesystem::path& file, double scale) {
  if (!(std::isfinite(scale) && scale > 0)) {
    throw std::invalid_argument(fmt::format("scale {}: must be positive", scale));
  }
  const std::string extension = ExtensionOf(file), name = file.string();
  if (extension == ".flo") {
    const DisplacementMaps flow = DecodeFlo(ReadInputFile(file), name);
    return {flow.dx, flow.dy};
  }
  if (extension == ".pfm") {
    const cv::Mat map = DecodePfm(ReadInputFile(file), name);
    if (map.channels() == 1) return {Scaled(map, -1), {}};
    throw FormatError(fmt::format("{}: three channels: a disparity has one", name));
  }
  if (extension == ".png" || extension == ".pgm") {
    return OfPicture(ReadImage(file), scale, extension == ".png", name);
  }
  ThrowUnknownFormat(file, ".flo, .pfm, .png (KITTI's 16 bits, or 8 bits), .pgm");
}

}  // namespace horopter::scenarios
