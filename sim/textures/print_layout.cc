// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/print_layout.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter::sim {

namespace {

/// Ascending edges: an interval that contains x starts at an even index.
bool Inside(const std::vector<double>& edges, double x) {
  return (std::upper_bound(edges.begin(), edges.end(), x) - edges.begin()) % 2 == 1;
}

}  // namespace

cv::Vec3f RandomColour(RandomStream& random, float saturation) {
  const double hue = random.Uniform(0, 2 * M_PI);
  const float value = static_cast<float>(random.Uniform(45, 150));
  cv::Vec3f bgr;
  for (int c = 0; c < 3; ++c) {
    bgr[c] = value * (1 + saturation * static_cast<float>(std::cos(hue + c * 2 * M_PI / 3)));
  }
  return bgr;
}

cv::Vec3f HueColour(double hue_deg, float saturation, float value) {
  cv::Vec3f bgr;
  for (int c = 0; c < 3; ++c) {
    // Red peaks at 0, green at 120, blue at 240 degrees; each falls to nothing 120 degrees away.
    const double peak_deg = 240 - 120 * c;
    const double away = std::abs(std::remainder(hue_deg - peak_deg, 360.0));
    const float pure = static_cast<float>(std::clamp(2 - away / 60, 0.0, 1.0));
    bgr[c] = value * (1 - saturation + saturation * pure);
  }
  return bgr;
}

TextBlock::TextBlock(RandomStream& random, const Rectangle& area, double line_m)
    : area_(area), line_m_(line_m) {
  const int lines = static_cast<int>(area.height_m() / line_m);
  for (int line = 0; line < lines; ++line) {
    std::vector<double>& edges = edges_.emplace_back();
    const double stop = random.Uniform(0, 1) < 0.2 ? random.Uniform(0.3, 0.9) : 1.0;
    for (double x = area.left_m; x < area.left_m + stop * area.width_m();) {
      edges.push_back(x);
      x += line_m * random.Uniform(0.8, 3.5);
      edges.push_back(x);
      x += line_m * 0.4;
    }
  }
}

bool TextBlock::Inked(double x, double y) const {
  if (!area_.Contains(x, y)) return false;
  const auto line = static_cast<std::size_t>((y - area_.top_m) / line_m_);
  if (line >= edges_.size() || std::fmod(y - area_.top_m, line_m_) > 0.6 * line_m_) return false;
  return Inside(edges_[line], x);
}

Lettering::Lettering(const std::string& word, const Rectangle& area) : area_(area) {
  if (word.empty()) return;
  constexpr double kScale = 4;  // capital letters of about 85 px
  constexpr int kBold = 15;
  const cv::Size size = cv::getTextSize(word, cv::FONT_HERSHEY_DUPLEX, kScale, kBold, nullptr);
  mask_ = cv::Mat1b(size.height + 2 * kBold, size.width, uchar{0});
  cv::putText(mask_, word, {0, size.height + kBold}, cv::FONT_HERSHEY_DUPLEX, kScale, 255, kBold,
              cv::LINE_AA);
  mask_ = mask_(cv::boundingRect(mask_)).clone();
}

float Lettering::Ink(double x, double y) const {
  if (mask_.empty() || !area_.Contains(x, y)) return 0;
  const double u = (x - area_.left_m) / area_.width_m() * mask_.cols - 0.5;
  const double v = (y - area_.top_m) / area_.height_m() * mask_.rows - 0.5;
  const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
  const auto at = [this](int r, int c) {
    return static_cast<float>(
        mask_(std::clamp(r, 0, mask_.rows - 1), std::clamp(c, 0, mask_.cols - 1)));
  };
  const float right = static_cast<float>(u - column), down = static_cast<float>(v - row);
  const float upper = at(row, column) * (1 - right) + at(row, column + 1) * right;
  const float lower = at(row + 1, column) * (1 - right) + at(row + 1, column + 1) * right;
  return (upper * (1 - down) + lower * down) / 255;
}

Barcode::Barcode(RandomStream& random, const Rectangle& area) : area_(area) {
  const double unit_m = area.width_m() / 95;  // modules of a 13-digit article number
  for (double x = area.left_m; x < area.right_m;) {
    edges_.push_back(x);
    x += unit_m * std::floor(random.Uniform(1, 4.99));
  }
}

bool Barcode::Inked(double x) const { return Inside(edges_, x); }

}  // namespace horopter::sim
