// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/colourise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

constexpr int kSteps = 256;
using Table = std::array<cv::Vec3b, kSteps>;

const cv::Vec3b kInvalid(56, 52, 50);
const cv::Vec3b kHatch(92, 88, 86);

Table Viridis() {
  cv::Mat1b ramp(1, kSteps);
  for (int i = 0; i < kSteps; ++i) ramp(i) = static_cast<std::uint8_t>(kSteps - 1 - i);
  cv::Mat3b colours;
  cv::applyColorMap(ramp, colours, cv::COLORMAP_VIRIDIS);
  Table table;
  std::copy(colours.begin(), colours.end(), table.begin());
  return table;
}

/// Straight lines in CIE L*a*b* from one end over near-white to the other: equal steps look equal,
/// and both signs of a value are equally striking (Moreland 2009 argues for such maps).
Table Diverging(const cv::Vec3f& low_lab, const cv::Vec3f& high_lab) {
  const cv::Vec3f middle(96, 0, 0);
  cv::Mat3f lab(1, kSteps);
  for (int i = 0; i < kSteps; ++i) {
    const float t = 2.f * i / (kSteps - 1) - 1;
    lab(i) = middle + std::abs(t) * ((t < 0 ? low_lab : high_lab) - middle);
  }
  cv::Mat3f bgr;
  cv::cvtColor(lab, bgr, cv::COLOR_Lab2BGR);
  Table table;
  std::transform(bgr.begin(), bgr.end(), table.begin(), [](const cv::Vec3f& c) {
    return cv::Vec3b(cv::saturate_cast<std::uint8_t>(c[0] * 255),
                     cv::saturate_cast<std::uint8_t>(c[1] * 255),
                     cv::saturate_cast<std::uint8_t>(c[2] * 255));
  });
  return table;
}

const Table& TableOf(ColourMap map) {
  static const Table depth = Viridis();
  static const Table disparity = Diverging({58, 42, 64}, {36, 40, -58});
  static const Table error = Diverging({40, 4, -48}, {42, 62, 42});
  switch (map) {
    case ColourMap::kDepth:
    case ColourMap::kRange:
      return depth;
    case ColourMap::kDisparity:
      return disparity;
    case ColourMap::kSignedError:
      return error;
  }
  return depth;
}

bool IsHatched(int x, int y) { return (x + y) % 6 < 2; }

/// Colours every pixel by its fraction of the scale; not finite means invalid.
template <typename Fraction>
cv::Mat3b Colourise(const cv::Size& size, ColourMap map, Fraction&& fraction) {
  cv::Mat3b picture(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double f = fraction(x, y);
      picture(y, x) = std::isfinite(f) ? MapColour(map, f) : IsHatched(x, y) ? kHatch : kInvalid;
    }
  }
  return picture;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void RequireDepthScale(double near_m, double far_m) {
  if (!(near_m > 0 && far_m > near_m)) {
    throw std::invalid_argument(
        fmt::format("depth scale {} to {} m: must be 0 < near < far", near_m, far_m));
  }
}

double DepthFraction(double depth_m, double near_m, double far_m) {
  if (!std::isfinite(depth_m) || depth_m <= 0) return kNone;
  return std::clamp(std::log(depth_m / near_m) / std::log(far_m / near_m), 0.0, 1.0);
}

void RequireLimit(double limit) {
  if (!(limit > 0)) {
    throw std::invalid_argument(fmt::format("colour scale of +-{}: must be positive", limit));
  }
}

/// Fraction of a scale from -limit to limit.
double SignedFraction(double value, double limit) {
  return std::isfinite(value) ? std::clamp(0.5 + 0.5 * value / limit, 0.0, 1.0) : kNone;
}

/// White with a dark rim, readable on any colour; centred on a point.
void DrawLabel(cv::Mat3b& picture, const std::string& text, cv::Point centre, double scale) {
  int baseline = 0;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &baseline);
  const cv::Point origin(
      std::clamp(centre.x - size.width / 2, 2, std::max(2, picture.cols - size.width - 2)),
      std::clamp(centre.y + size.height / 2, size.height + 2,
                 std::max(size.height + 2, picture.rows - 3)));
  cv::putText(picture, text, origin, cv::FONT_HERSHEY_SIMPLEX, scale, {24, 24, 24}, 3, cv::LINE_AA);
  cv::putText(picture, text, origin, cv::FONT_HERSHEY_SIMPLEX, scale, {255, 255, 255}, 1,
              cv::LINE_AA);
}

}  // namespace

cv::Vec3b MapColour(ColourMap map, double fraction) {
  if (std::isnan(fraction)) return kInvalid;
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  return TableOf(map)[static_cast<int>(std::lround(clamped * (kSteps - 1)))];
}

cv::Mat3b ColouriseDepth(const cv::Mat1f& depth_m, double near_m, double far_m) {
  RequireDepthScale(near_m, far_m);
  return Colourise(depth_m.size(), ColourMap::kDepth,
                   [&](int x, int y) { return DepthFraction(depth_m(y, x), near_m, far_m); });
}

cv::Mat3b ColouriseDisparity(const vision::DisparityField& field, double limit_px) {
  RequireLimit(limit_px);
  return Colourise(field.dx.size(), ColourMap::kDisparity, [&](int x, int y) {
    return field.valid(y, x) ? SignedFraction(field.dx(y, x), limit_px) : kNone;
  });
}

cv::Mat3b ColouriseValues(const cv::Mat1f& values, ColourMap map, double low, double high) {
  if (!(low < high)) {
    throw std::invalid_argument(
        fmt::format("colour scale {} to {}: must be low < high", low, high));
  }
  return Colourise(values.size(), map, [&](int x, int y) {
    const double v = values(y, x);
    return std::isfinite(v) ? std::clamp((v - low) / (high - low), 0.0, 1.0) : kNone;
  });
}

cv::Mat3b ColouriseSignedError(const cv::Mat1f& error, double limit) {
  RequireLimit(limit);
  return Colourise(error.size(), ColourMap::kSignedError,
                   [&](int x, int y) { return SignedFraction(error(y, x), limit); });
}

cv::Mat3b DrawRegions(const cv::Mat& image_bgr, const vision::RegionMap& regions, double near_m,
                      double far_m) {
  RequireDepthScale(near_m, far_m);
  if (image_bgr.size() != regions.labels.size() || image_bgr.type() != CV_8UC3) {
    throw std::invalid_argument(fmt::format(
        "regions of {}x{} on an image of {}x{}: must be one size, and the image CV_8UC3",
        regions.labels.cols, regions.labels.rows, image_bgr.cols, image_bgr.rows));
  }
  int highest_label = 0;
  for (const vision::Region& region : regions.regions) {
    highest_label = std::max(highest_label, region.label);
  }
  std::vector<double> fraction(highest_label + 1, kNone);
  for (const vision::Region& region : regions.regions) {
    if (region.label < 1 || region.depth.count == 0) continue;
    fraction[region.label] = DepthFraction(region.depth.mean_m, near_m, far_m);
  }

  cv::Mat1b grey;
  cv::cvtColor(image_bgr, grey, cv::COLOR_BGR2GRAY);
  cv::Mat3b picture(image_bgr.size());
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const int label = regions.labels(y, x);
      const double g = grey(y, x);
      const double f = label >= 1 && label <= highest_label ? fraction[label] : kNone;
      if (label == 0) {
        picture(y, x) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(g * 0.25));
      } else if (std::isnan(f)) {
        picture(y, x) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(40 + g * 0.6));
      } else {
        const cv::Vec3b colour = MapColour(ColourMap::kDepth, f);
        for (int c = 0; c < 3; ++c) {
          picture(y, x)[c] = cv::saturate_cast<std::uint8_t>(0.6 * colour[c] + 0.4 * g);
        }
      }
    }
  }
  const double scale = std::max(0.36, picture.cols / 900.0);
  for (const vision::Region& region : regions.regions) {
    const bool has_room = region.box.width >= 70 * scale && region.box.height >= 30 * scale;
    if (region.depth.count == 0 || !has_room) continue;
    DrawLabel(picture, fmt::format("{:.2f} m", region.depth.mean_m),
              {static_cast<int>(region.centroid.x), static_cast<int>(region.centroid.y)}, scale);
  }
  return picture;
}

cv::Mat3b LegendStrip(ColourMap map, double low, double high, const std::string& unit,
                      int width_px) {
  width_px = std::max(width_px, 160);
  constexpr int kBarHeight = 14;
  constexpr int kSwatch = 46;
  cv::Mat3b strip(kBarHeight + 18, width_px, cv::Vec3b(255, 255, 255));
  const int bar_width = width_px - kSwatch - 8;
  for (int x = 0; x < bar_width; ++x) {
    strip(cv::Rect(x, 0, 1, kBarHeight)).setTo(MapColour(map, x / (bar_width - 1.0)));
  }
  for (int y = 0; y < kBarHeight; ++y) {
    for (int x = width_px - kSwatch; x < width_px; ++x) {
      strip(y, x) = IsHatched(x, y) ? kHatch : kInvalid;
    }
  }
  const bool logarithmic = map == ColourMap::kDepth;
  const double middle = logarithmic ? std::sqrt(low * high) : (low + high) / 2;
  const auto write = [&](const std::string& text, double anchor, int at) {
    int baseline = 0;
    const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.36, 1, &baseline);
    cv::putText(strip, text, {at - static_cast<int>(anchor * size.width), kBarHeight + 13},
                cv::FONT_HERSHEY_SIMPLEX, 0.36, {32, 32, 32}, 1, cv::LINE_AA);
  };
  write(fmt::format("{:.3g}", low), 0, 0);
  write(fmt::format("{:.3g}", middle), 0.5, bar_width / 2);
  write(fmt::format("{:.3g} {}", high, unit), 1, bar_width);
  write("none", 0.5, width_px - kSwatch / 2);
  return strip;
}

}  // namespace horopter::scenarios
