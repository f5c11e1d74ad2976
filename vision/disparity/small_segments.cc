// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/small_segments.h"

#include <cmath>
#include <vector>

namespace horopter::vision {
namespace {

/// Grows segments by flood fill; every valid pixel is visited once.
class SegmentGrower {
 public:
  SegmentGrower(double max_step_px, const DisparityField& field)
      : max_step2_(static_cast<float>(max_step_px * max_step_px)),
        field_(field),
        seen_(cv::Mat1b::zeros(field.valid.size())) {}

  bool Seen(cv::Point p) const { return seen_(p) != 0; }

  /// The segment that contains `seed`; valid until the next call.
  const std::vector<cv::Point>& Grow(cv::Point seed) {
    segment_.assign(1, seed);
    seen_(seed) = 1;
    for (std::size_t next = 0; next < segment_.size(); ++next) {
      const cv::Point p = segment_[next];
      for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) Join(p, p + step);
    }
    return segment_;
  }

 private:
  void Join(cv::Point from, cv::Point to) {
    if (!cv::Rect({}, seen_.size()).contains(to) || seen_(to) != 0 || field_.valid(to) == 0) return;
    const float dx = field_.dx(to) - field_.dx(from), dy = field_.dy(to) - field_.dy(from);
    if (dx * dx + dy * dy > max_step2_) return;
    seen_(to) = 1;
    segment_.push_back(to);
  }

  float max_step2_;
  const DisparityField& field_;
  cv::Mat1b seen_;
  std::vector<cv::Point> segment_;
};

}  // namespace

void InvalidateSmallSegments(int min_px, double max_step_px, DisparityField& field) {
  SegmentGrower grower(max_step_px, field);
  cv::Mat1b kept = field.valid.clone();
  for (int y = 0; y < kept.rows; ++y) {
    for (int x = 0; x < kept.cols; ++x) {
      if (field.valid(y, x) == 0 || grower.Seen({x, y})) continue;
      const auto& segment = grower.Grow({x, y});
      if (static_cast<int>(segment.size()) >= min_px) continue;
      for (const cv::Point p : segment) kept(p) = 0;
    }
  }
  field.valid = kept;
}

}  // namespace horopter::vision
