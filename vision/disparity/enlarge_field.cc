// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/enlarge_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>

namespace horopter::vision {
namespace {

constexpr float kSameSurfacePx = 1;
constexpr int kRowsAtOnce = 8;

/// The coarse pixels around a fine one: one, two or four.
struct Corners {
  std::array<cv::Point, 4> at;
  int count = 0;
};
Corners CornersOf(int x, int y, cv::Size coarse) {
  Corners corners;
  const int right = std::min((x + 1) / 2, coarse.width - 1);
  const int below = std::min((y + 1) / 2, coarse.height - 1);
  for (int cy = y / 2; cy <= below; ++cy) {
    for (int cx = x / 2; cx <= right; ++cx) corners.at[corners.count++] = {cx, cy};
  }
  return corners;
}

int ColourDifference(const cv::Mat& image, int x, int y, cv::Point corner) {
  const int channels = image.channels();
  const std::uint8_t* a = image.ptr(y) + static_cast<std::ptrdiff_t>(x) * channels;
  const std::uint8_t* b =
      image.ptr(2 * corner.y) + static_cast<std::ptrdiff_t>(2 * corner.x) * channels;
  int sum = 0;
  for (int c = 0; c < channels; ++c) sum += std::abs(a[c] - b[c]);
  return sum;
}

cv::Point ClosestInColour(const cv::Mat& image, int x, int y, const Corners& corners) {
  cv::Point closest = corners.at[0];
  int least = INT_MAX;
  for (int i = 0; corners.count > 1 && i < corners.count; ++i) {
    const int difference = ColourDifference(image, x, y, corners.at[i]);
    if (difference < least) closest = corners.at[i];
    least = std::min(least, difference);
  }
  return closest;
}

/// Mean disparity of the corners that are of the anchor's surface.
cv::Vec2f MeanAround(const DisparityField& coarse, const Corners& corners, cv::Point anchor) {
  const float anchor_x = coarse.dx(anchor), anchor_y = coarse.dy(anchor);
  cv::Vec2f sum(0, 0);
  float count = 0;
  for (int i = 0; i < corners.count; ++i) {
    const cv::Point at = corners.at[i];
    const float dx = coarse.dx(at), dy = coarse.dy(at);
    const bool same =
        at == anchor || (coarse.valid(at) != 0 && std::abs(dx - anchor_x) <= kSameSurfacePx &&
                         std::abs(dy - anchor_y) <= kSameSurfacePx);
    if (!same) continue;
    sum += cv::Vec2f(dx, dy);
    ++count;
  }
  return sum / count;
}

}  // namespace

void DoubleField(const cv::Mat& image, DisparityField& field) {
  DisparityField fine;
  for (cv::Mat1f* map : {&fine.dx, &fine.dy, &fine.confidence}) map->create(image.size());
  fine.valid.create(image.size());
  tbb::parallel_for(tbb::blocked_range<int>(0, image.rows, kRowsAtOnce), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const Corners corners = CornersOf(x, y, field.valid.size());
        const cv::Point anchor = ClosestInColour(image, x, y, corners);
        const cv::Vec2f disparity = 2 * MeanAround(field, corners, anchor);
        fine.dx(y, x) = disparity[0];
        fine.dy(y, x) = disparity[1];
        fine.confidence(y, x) = field.confidence(anchor);
        fine.valid(y, x) = field.valid(anchor);
      }
    }
  });
  field = fine;
}

}  // namespace horopter::vision
