// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/small_segments.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace horopter::vision {
namespace {

/// Neighbours with which a pixel is in one segment.
constexpr std::uint8_t kLeft = 1, kAbove = 2;

/// Pixels of a row or of a part of one.
struct Pixels {
  const float *dx, *dy;
  const std::uint8_t* valid;

  Pixels(const DisparityField& field, int x, int y)
      : dx(field.dx[y] + x), dy(field.dy[y] + x), valid(field.valid[y] + x) {}
};

/// Adds `link` to the links of those of `count` pixels that are in one segment with the other.
void AddLinks(const Pixels& a, const Pixels& b, int count, float max_step2, std::uint8_t link,
              std::uint8_t* links) {
  for (int x = 0; x < count; ++x) {
    const float dx = a.dx[x] - b.dx[x], dy = a.dy[x] - b.dy[x];
    const bool apart = dx * dx + dy * dy > max_step2;
    const bool linked = !apart & (a.valid[x] != 0) & (b.valid[x] != 0);
    links[x] |= linked ? link : std::uint8_t{0};
  }
}

/// For every pixel, kLeft and kAbove as far as they hold.
cv::Mat1b FindLinks(const DisparityField& field, float max_step2) {
  constexpr int kRowsAtOnce = 32;
  cv::Mat1b links = cv::Mat1b::zeros(field.valid.size());
  tbb::parallel_for(tbb::blocked_range<int>(0, links.rows, kRowsAtOnce), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      AddLinks({field, 1, y}, {field, 0, y}, links.cols - 1, max_step2, kLeft, links[y] + 1);
      if (y > 0)
        AddLinks({field, 0, y}, {field, 0, y - 1}, links.cols, max_step2, kAbove, links[y]);
    }
  });
  return links;
}

/// Valid pixels of a row, each linked to the one before.
struct Run {
  int y, begin, end;
};

/// Runs, joined to segments: a forest whose roots know how many pixels their segments have.
class Segments {
 public:
  int Add(const Run& run) {
    runs_.push_back(run);
    const int number = static_cast<int>(parents_.size());
    parents_.push_back(number);
    return number;
  }

  void Lengthen(int run) { ++runs_[run].end; }

  void Join(int a, int b) {
    const int root_a = Root(a), root_b = Root(b);
    // The earlier one stays: a parent always comes before its children.
    parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

  /// Clears what belongs to segments of fewer than `min_px` pixels.
  void ClearSmall(int min_px, cv::Mat1b& valid) {
    std::vector<int> pixels(runs_.size(), 0);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      pixels[Root(static_cast<int>(i))] += runs_[i].end - runs_[i].begin;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (pixels[Root(static_cast<int>(i))] >= min_px) continue;
      std::fill(valid[runs_[i].y] + runs_[i].begin, valid[runs_[i].y] + runs_[i].end,
                std::uint8_t{0});
    }
  }

 private:
  int Root(int run) {
    while (parents_[run] != run) {
      parents_[run] = parents_[parents_[run]];
      run = parents_[run];
    }
    return run;
  }

  std::vector<Run> runs_;
  std::vector<int> parents_;
};

Segments JoinRuns(const cv::Mat1b& valid, const cv::Mat1b& links) {
  Segments segments;
  std::vector<int> above(valid.cols), here(valid.cols);  // run of each pixel of two rows
  for (int y = 0; y < valid.rows; ++y) {
    int joined = -1;  // run above that this run was joined to last
    for (int x = 0; x < valid.cols; ++x) {
      if (valid(y, x) == 0) continue;
      const std::uint8_t linked = links(y, x);
      if ((linked & kLeft) != 0) {
        here[x] = here[x - 1];
        segments.Lengthen(here[x]);
      } else {
        here[x] = segments.Add({y, x, x + 1});
        joined = -1;
      }
      if ((linked & kAbove) == 0 || above[x] == joined) continue;
      joined = above[x];
      segments.Join(here[x], joined);
    }
    std::swap(above, here);
  }
  return segments;
}

}  // namespace

void InvalidateSmallSegments(int min_px, double max_step_px, DisparityField& field) {
  const cv::Mat1b links = FindLinks(field, static_cast<float>(max_step_px * max_step_px));
  JoinRuns(field.valid, links).ClearSmall(min_px, field.valid);
}

}  // namespace horopter::vision
