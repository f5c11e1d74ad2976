// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/field_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace horopter::vision {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string Describe(cv::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

void RequireSize(const char* what, cv::Size size, cv::Size truth) {
  if (size == truth) return;
  throw std::invalid_argument(std::string(what) + " is " + Describe(size) + ", truth is " +
                              Describe(truth) + ": both must be of one size");
}

/// Half of an even number of values lies at or below it, half at or above.
double Median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

/// @param error_at the absolute error at (x, y); NaN without an estimate, infinite without truth
template <typename ErrorAt>
ErrorScore Gather(cv::Size size, const cv::Mat1b& mask, ErrorAt error_at) {
  ErrorScore score;
  std::vector<double> errors;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (!mask.empty() && mask(y, x) == 0) continue;
      const double error = error_at(x, y);
      if (std::isinf(error)) continue;
      ++score.known;
      if (std::isnan(error)) continue;
      if (errors.empty() || error > score.max_px) {
        score.max_px = error;
        score.max_at = {x, y};
      }
      errors.push_back(error);
    }
  }
  score.estimated = static_cast<std::int64_t>(errors.size());
  const auto known = static_cast<double>(score.known);
  const auto estimated = static_cast<double>(score.estimated);
  score.density = estimated / known;
  for (std::size_t i = 0; i < kBadLimitsPx.size(); ++i) {
    const auto bad = static_cast<double>(std::count_if(
        errors.begin(), errors.end(), [i](double error) { return error > kBadLimitsPx[i]; }));
    score.bad_estimated[i] = bad / estimated;
    score.bad_known[i] = (bad + known - estimated) / known;
  }
  if (errors.empty()) {
    score.mean_px = score.median_px = score.rms_px = score.max_px = kNaN;
    return score;
  }
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  score.mean_px = sum / estimated;
  score.rms_px = std::sqrt(squares / estimated);
  score.median_px = Median(errors);
  return score;
}

/// As Gather() takes it.
double Error(float estimate, float truth) {
  if (!std::isfinite(truth)) return std::numeric_limits<double>::infinity();
  return std::isfinite(estimate) ? std::abs(static_cast<double>(estimate) - truth) : kNaN;
}

}  // namespace

FieldScores ScoreDisparity(const DisparityMaps& estimate, const DisparityMaps& truth,
                           const cv::Mat1b& mask) {
  const cv::Size size = truth.dx.size();
  RequireSize("estimate", estimate.dx.size(), size);
  if (!mask.empty()) RequireSize("mask", mask.size(), size);
  const auto dx = [&](int x, int y) { return Error(estimate.dx(y, x), truth.dx(y, x)); };
  FieldScores scores{Gather(size, mask, dx), std::nullopt, std::nullopt};
  if (scores.dx.known == 0) {
    throw std::invalid_argument(mask.empty() ? "the truth is unknown everywhere"
                                             : "the truth is unknown wherever the mask counts");
  }
  if (estimate.dy.empty() || truth.dy.empty()) return scores;
  RequireSize("estimate's dy", estimate.dy.size(), size);
  RequireSize("truth's dy", truth.dy.size(), size);
  const auto dy = [&](int x, int y) { return Error(estimate.dy(y, x), truth.dy(y, x)); };
  scores.dy = Gather(size, mask, dy);
  // Unknown in either component is unknown: infinity and NaN outlast the sum in that order.
  scores.vector = Gather(size, mask, [&](int x, int y) { return std::hypot(dx(x, y), dy(x, y)); });
  return scores;
}

}  // namespace horopter::vision
