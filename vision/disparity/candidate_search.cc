// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/candidate_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace horopter::vision {
namespace {

constexpr int kRowsAtOnce = 8;
/// Rows whose lanes are pooled downwards while they are still in the cache.
constexpr int kStripRows = 16;
constexpr int kStripColumns = 128;

/// Candidates in the order in which they fill lanes; lanes left over repeat the pixel's own.
class CandidateList {
 public:
  CandidateList() { Clear(); }

  void Clear() {
    candidates_ = {};
    count_ = 1;  // lane 0: the pixel's own
  }
  bool full() const { return count_ == kLanes; }
  bool holds_others() const { return count_ > 1; }
  void Add(int from_x, int from_y, int move_x, int move_y) {
    candidates_.from_x[count_] = from_x;
    candidates_.from_y[count_] = from_y;
    candidates_.move_x[count_] = move_x;
    candidates_.move_y[count_] = move_y;
    ++count_;
  }
  const Candidates& candidates() const { return candidates_; }

 private:
  Candidates candidates_;
  int count_;
};

/// A component of a field at twice the size, in the finer octave's pixels: bilinear, pixel (x, y)
/// of the coarser one on (2x, 2y).
void DoubleComponent(const float* coarse, int coarse_width, int coarse_height, float* fine,
                     int width, int height) {
  for (int y = 0; y < height; ++y) {
    const float* above = coarse + static_cast<std::ptrdiff_t>(y / 2) * coarse_width;
    const float* below =
        coarse +
        static_cast<std::ptrdiff_t>(std::min((y + 1) / 2, coarse_height - 1)) * coarse_width;
    float* out = fine + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x) {
      const int left = x / 2, right = std::min((x + 1) / 2, coarse_width - 1);
      out[x] = 0.5F * ((above[left] + above[right]) + (below[left] + below[right]));
    }
  }
}

}  // namespace

CandidateSearch::CandidateSearch(const ClosedFormConfig& config, const CellBank& bank,
                                 const ClosedFormKernels& kernels)
    : config_(config),
      bank_(bank),
      kernels_(kernels),
      score_weights_(MakePoolingWeights(config.score_pool_px, config.score_pool_grey)),
      product_weights_(MakePoolingWeights(config.product_pool_px, config.product_pool_grey)) {}

void CandidateSearch::Map::Resize(int width, int height) {
  dx.Resize(width, height);
  dy.Resize(width, height);
}

template <typename Loop>
void CandidateSearch::ForRows(Loop loop) const {
  tbb::parallel_for(tbb::blocked_range<int>(0, height_, kRowsAtOnce), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) loop(y);
  });
}

template <typename Loop>
void CandidateSearch::ForColumns(Loop loop) const {
  const int blocks = (width_ + kColumnsAtOnce - 1) / kColumnsAtOnce;
  tbb::parallel_for(0, blocks, [&](int block) {
    loop(block * kColumnsAtOnce, std::min((block + 1) * kColumnsAtOnce, width_));
  });
}

template <typename Fill>
void CandidateSearch::FillLanes(const PoolingWeights& weights, Fill fill) {
  const ColumnPool columns = Columns(weights);
  for (int begin = 0; begin < height_; begin += kStripRows) {
    const int end = std::min(begin + kStripRows, height_);
    tbb::parallel_for(tbb::blocked_range<int>(begin, end, kRowsAtOnce), [&](const auto& rows) {
      for (int y = rows.begin(); y < rows.end(); ++y) {
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * width_;
        fill(y);
        kernels_.pool_row(lanes_.data() + row * kLanes, from_->edges.x.data() + row, weights,
                          width_);
      }
    });
    tbb::parallel_for(tbb::blocked_range<int>(0, width_, kStripColumns),
                      [&](const auto& columns_x) {
                        kernels_.pool_down(columns, begin, end, columns_x.begin(), columns_x.end());
                      });
  }
}

void CandidateSearch::Run(const ViewPyramid& from, const ViewPyramid& to,
                          const SearchBounds& bounds, DisparityField& field) {
  const int coarsest = from.size() - 1, finest = from.finest();
  for (int octave = coarsest; octave >= finest; --octave) {
    const int coarse_width = width_, coarse_height = height_;
    Enter(from[octave], to[octave]);
    if (octave == coarsest) {
      SearchEverything(octave, bounds);
    } else {
      Double(coarse_width, coarse_height);
      if (octave >= config_.explore_from && octave <= config_.explore_to) Explore();
    }
    for (int i = 0; i < config_.iterations; ++i) {
      if (i < config_.rounds) CompeteWithNeighbours(i == 0 && octave >= config_.try_steps_from);
      Smooth();
      Refine();
    }
    Median();
  }
  const float one = static_cast<float>(kScoreOne);
  cv::Mat1f(height_, width_, field_.dx.data()).copyTo(field.dx);
  cv::Mat1f(height_, width_, field_.dy.data()).copyTo(field.dy);
  field.confidence.create(height_, width_);
  field.valid.create(height_, width_);
  ForRows([&](int y) {
    const std::int16_t* best = best_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int x = 0; x < width_; ++x) {
      const float coherence = static_cast<float>(best[x]) / one;
      field.confidence(y, x) = std::clamp(coherence, 0.0F, 1.0F);
      field.valid(y, x) = coherence >= static_cast<float>(config_.min_coherence) ? 255 : 0;
    }
  });
}

void CandidateSearch::Enter(const ViewOctave& from, const ViewOctave& to) {
  from_ = &from;
  to_ = &to;
  width_ = from.width;
  height_ = from.height;
  hypothesis_x_.Resize(width_, height_);
  hypothesis_y_.Resize(width_, height_);
  best_.Resize(width_, height_);
  winner_.Resize(width_, height_);
  lanes_.Resize(width_, height_, kLanes);
  other_.Resize(width_, height_);
}

void CandidateSearch::SearchEverything(int octave, const SearchBounds& bounds) {
  field_.Resize(width_, height_);
  const double pixel = 1 << octave;
  const auto below = [pixel](double px) { return static_cast<int>(std::floor(px / pixel)); };
  const auto above = [pixel](double px) { return static_cast<int>(std::ceil(px / pixel)); };
  // No pixel has a match further away than the image is wide.
  const auto reachable = [](int px, int side) { return std::clamp(px, 1 - side, side - 1); };
  const Range everything{
      reachable(below(bounds.low_x), width_), reachable(above(bounds.high_x), width_),
      reachable(below(bounds.low_y), height_), reachable(above(bounds.high_y), height_)};
  SearchRange(everything);
  SearchRange(Likely(everything));
}

void CandidateSearch::SearchRange(const Range& range) {
  for (int dy = range.low_y; dy <= range.high_y; ++dy) {
    CompeteShifts(range.low_x, range.high_x, dy * kHypothesisSteps, false, dy == range.low_y);
  }
  TakeWinners();
}

CandidateSearch::Range CandidateSearch::Likely(const Range& range) {
  const std::size_t pixels = static_cast<std::size_t>(width_) * height_;
  scores_.assign(best_.data(), best_.data() + pixels);
  const auto middle = scores_.begin() + static_cast<std::ptrdiff_t>(pixels / 2);
  std::nth_element(scores_.begin(), middle, scores_.end());
  const auto spread = [&](const float* component, int low, int high) {
    sample_.clear();
    for (std::size_t i = 0; i < pixels; ++i) {
      if (best_.data()[i] >= *middle) sample_.push_back(component[i]);
    }
    constexpr double kShare = 0.05;
    constexpr int kMore = 2;
    return std::pair(std::max(low, static_cast<int>(SampleQuantile(kShare)) - kMore),
                     std::min(high, static_cast<int>(SampleQuantile(1 - kShare)) + kMore));
  };
  const auto [low_x, high_x] = spread(field_.dx.data(), range.low_x, range.high_x);
  const auto [low_y, high_y] = spread(field_.dy.data(), range.low_y, range.high_y);
  return {low_x, high_x, low_y, high_y};
}

float CandidateSearch::SampleQuantile(double share) {
  const auto at = sample_.begin() +
                  static_cast<std::ptrdiff_t>(share * static_cast<double>(sample_.size() - 1));
  std::nth_element(sample_.begin(), at, sample_.end());
  return *at;
}

void CandidateSearch::Double(int coarse_width, int coarse_height) {
  DoubleComponent(field_.dx.data(), coarse_width, coarse_height, other_.dx.data(), width_, height_);
  DoubleComponent(field_.dy.data(), coarse_width, coarse_height, other_.dy.data(), width_, height_);
  std::swap(field_, other_);
  other_.Resize(width_, height_);
}

void CandidateSearch::Explore() {
  QuantiseHypotheses();
  sample_.clear();
  for (int y = 0; y < height_; y += 2) {
    const float* row = field_.dx.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int x = 0; x < width_; x += 2) sample_.push_back(row[x]);
  }
  const int low = static_cast<int>(std::floor(SampleQuantile(0.02))) - 1;
  const int high = static_cast<int>(std::ceil(SampleQuantile(0.98))) + 1;
  Compete(CandidateList().candidates(), true);
  for (const int move_y : {0, -kHypothesisSteps, kHypothesisSteps}) {
    CompeteShifts(low, high, move_y, true, false);
  }
  TakeWinners();
}

void CandidateSearch::CompeteWithNeighbours(bool try_steps) {
  QuantiseHypotheses();
  CandidateList list;
  bool first = true;
  const auto finish = [&] {
    Compete(list.candidates(), first);
    first = false;
    list.Clear();
  };
  const auto add = [&](int from_x, int from_y, int move_x, int move_y) {
    if (list.full()) finish();
    list.Add(from_x, from_y, move_x, move_y);
  };
  for (const int distance : config_.neighbour_px) {
    if (distance == 0) continue;
    add(distance, 0, 0, 0);
    add(-distance, 0, 0, 0);
    add(0, -distance, 0, 0);
    if (distance != config_.neighbour_px[3]) add(0, distance, 0, 0);
  }
  if (try_steps) {
    constexpr int kStep = 2 * kHypothesisSteps;
    for (const int y : {-kStep, 0, kStep}) {
      for (const int x : {-kStep, 0, kStep}) {
        if (x != 0 || y != 0) add(0, 0, x, y);
      }
    }
  }
  if (first || list.holds_others()) finish();
  TakeWinners();
}

void CandidateSearch::Compete(const Candidates& candidates, bool first) {
  const NeighbourTask score{.left = from_->cells.view(),
                            .right = to_->cells.view(),
                            .hypothesis_x = hypothesis_x_.data(),
                            .hypothesis_y = hypothesis_y_.data(),
                            .tables = &bank_.tables(),
                            .candidates = &candidates,
                            .scores = lanes_.data()};
  FillLanes(score_weights_, [&](int y) { kernels_.score_neighbours(score, y); });
  KeepTask keep = Keep(first);
  constexpr float kStep = 1.0F / kHypothesisSteps;
  for (int k = 0; k < kLanes; ++k) {
    origins_.push_back({candidates.from_x[k], candidates.from_y[k],
                        kStep * static_cast<float>(candidates.move_x[k]),
                        kStep * static_cast<float>(candidates.move_y[k]), true, true});
  }
  if (first) keep.favour_own = static_cast<std::int16_t>(config_.favour_own * kScoreOne);
  ForColumns([&](int x_begin, int x_end) { kernels_.keep_best(keep, x_begin, x_end); });
}

void CandidateSearch::CompeteShifts(int first_dx, int last_dx, int move_y, bool from_field,
                                    bool first) {
  for (int dx = first_dx; dx <= last_dx; dx += kLanes) {
    const ShiftTask score{.left = from_->cells.view(),
                          .right = to_->cells.view(),
                          .hypothesis_y = from_field ? hypothesis_y_.data() : nullptr,
                          .tables = &bank_.tables(),
                          .first_dx = dx,
                          .move_y = move_y,
                          .scores = lanes_.data()};
    FillLanes(score_weights_, [&](int y) { kernels_.score_shifts(score, y); });
    KeepTask keep = Keep(first);
    for (int k = 0; k < kLanes; ++k) {
      origins_.push_back({0, 0, static_cast<float>(dx + k),
                          static_cast<float>(move_y) / kHypothesisSteps, false, from_field});
    }
    keep.lanes = std::min(kLanes, last_dx - dx + 1);
    ForColumns([&](int x_begin, int x_end) { kernels_.keep_best(keep, x_begin, x_end); });
    first = false;
  }
}

KeepTask CandidateSearch::Keep(bool first) {
  if (first) origins_.clear();
  KeepTask task{};
  task.pool = Columns(score_weights_);
  task.lanes = kLanes;
  task.first = first;
  task.lane_0 = static_cast<std::int32_t>(origins_.size());
  task.best = best_.data();
  task.winner = winner_.data();
  return task;
}

void CandidateSearch::Refine() {
  const ProductTask product{from_->cells.view(), to_->cells.view(), field_.dx.data(),
                            field_.dy.data(),    &bank_.tables(),   lanes_.data()};
  FillLanes(product_weights_, [&](int y) { kernels_.multiply_row(product, y); });
  SolveTask solve{};
  solve.pool = Columns(product_weights_);
  solve.orientations = bank_.orientations();
  for (int o = 0; o < bank_.orientations(); ++o) {
    solve.nx[o] = static_cast<float>(bank_.nx(o));
    solve.ny[o] = static_cast<float>(bank_.ny(o));
  }
  solve.px_per_rad = static_cast<float>(bank_.px_per_rad());
  solve.ridge = static_cast<float>(config_.ridge);
  solve.max_step_px = static_cast<float>(config_.max_step_px);
  solve.dx = field_.dx.data();
  solve.dy = field_.dy.data();
  ForColumns([&](int x_begin, int x_end) { kernels_.solve(solve, x_begin, x_end); });
}

void CandidateSearch::Smooth() {
  if (config_.smooth_px == 0) return;
  const auto step = static_cast<float>(config_.smooth_step_px);
  const SmoothTask along_rows{
      field_.dx.data(), field_.dy.data(), other_.dx.data(),  other_.dy.data(),
      width_,           height_,          config_.smooth_px, step};
  const std::size_t scratch_size =
      2 * static_cast<std::size_t>(PaddedRow(width_, config_.smooth_px));
  ForRows([&](int y) {
    thread_local std::vector<float> scratch;
    if (scratch.size() < scratch_size) scratch.resize(scratch_size);
    kernels_.smooth_row(along_rows, y, scratch.data());
  });
  const SmoothTask across_rows{
      other_.dx.data(), other_.dy.data(), field_.dx.data(),  field_.dy.data(),
      width_,           height_,          config_.smooth_px, step};
  ForRows([&](int y) { kernels_.smooth_across_rows(across_rows, y); });
}

void CandidateSearch::Median() {
  if (config_.median_px == 0) return;
  const auto filter = [this](PaddedMap<float>& from, PaddedMap<float>& to) {
    cv::Mat1f filtered(height_, width_, to.data());
    cv::medianBlur(cv::Mat1f(height_, width_, from.data()), filtered, config_.median_px);
  };
  filter(field_.dx, other_.dx);
  filter(field_.dy, other_.dy);
  std::swap(field_, other_);
}

void CandidateSearch::TakeWinners() {
  ForRows([&](int y) {
    for (int x = 0; x < width_; ++x) {
      const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * width_ + x;
      const Origin& origin = origins_[winner_.data()[pixel]];
      const std::ptrdiff_t from =
          static_cast<std::ptrdiff_t>(std::clamp(y + origin.from_y, 0, height_ - 1)) * width_ +
          std::clamp(x + origin.from_x, 0, width_ - 1);
      other_.dx.data()[pixel] = (origin.of_x ? field_.dx.data()[from] : 0) + origin.add_x;
      other_.dy.data()[pixel] = (origin.of_y ? field_.dy.data()[from] : 0) + origin.add_y;
    }
  });
  std::swap(field_, other_);
}

void CandidateSearch::QuantiseHypotheses() {
  static constexpr int kReach = 32000;  // of 16 bits [1/16 px]
  const auto quantise = [](float disparity) {
    const float bounded =
        std::min(std::max(disparity * kHypothesisSteps, -1.0F * kReach), 1.0F * kReach);
    // Truncation of a positive number rounds without a call.
    return static_cast<std::int16_t>(static_cast<int>(bounded + (kReach + 0.5F)) - kReach);
  };
  ForRows([&](int y) {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * width_;
    for (std::ptrdiff_t i = row; i < row + width_; ++i) {
      hypothesis_x_.data()[i] = quantise(field_.dx.data()[i]);
      hypothesis_y_.data()[i] = quantise(field_.dy.data()[i]);
    }
  });
}

ColumnPool CandidateSearch::Columns(const PoolingWeights& weights) {
  return {lanes_.data(), width_, height_, from_->edges.y.data(), &weights};
}

}  // namespace horopter::vision
