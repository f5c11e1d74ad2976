// SPDX-License-Identifier: Apache-2.0
#include "accuracy_runs.h"

#include <algorithm>
#include <chrono>

namespace horopter::vision::testing {
namespace {

double Median(std::vector<double> sample) {
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

struct Contestant {
  MethodChoice choice;
  std::unique_ptr<DisparityEstimator> estimator;
  DisparityField field;
  std::vector<double> ms;
};

}  // namespace

MethodChoice MethodChoice::Parse(const std::string& text) {
  const std::size_t colon = text.find(':');
  MethodChoice choice{text.substr(0, colon), ""};
  choice.preset = colon == std::string::npos
                      ? std::string(FindDisparityMethod(choice.method).presets.front())
                      : text.substr(colon + 1);
  CreateDisparityEstimator(choice.method, choice.preset);
  return choice;
}

std::vector<MethodResult> RunMethods(const std::vector<MethodChoice>& methods,
                                     const PairWithTruth& pair,
                                     const std::optional<SearchRange>& range, int repeat) {
  std::vector<Contestant> contestants;
  for (const MethodChoice& choice : methods) {
    const bool searches = FindDisparityMethod(choice.method).horizontal_only;
    if (searches && !range) continue;
    contestants.push_back(
        {choice,
         CreateDisparityEstimator(choice.method, choice.preset, searches ? range : std::nullopt),
         {},
         {}});
  }
  for (int pass = 0; pass <= repeat; ++pass) {
    for (Contestant& c : contestants) {
      const auto start = std::chrono::steady_clock::now();
      c.field = c.estimator->Estimate(pair.left, pair.right);
      const std::chrono::duration<double, std::milli> taken =
          std::chrono::steady_clock::now() - start;
      if (pass > 0) c.ms.push_back(taken.count());
    }
  }
  std::vector<MethodResult> results;
  for (Contestant& c : contestants) {
    const FieldScores scores = ScoreDisparity({c.field.dx, c.field.dy}, {pair.dx, pair.dy});
    results.push_back({c.choice.name(), *scores.vector, Median(c.ms), c.field});
  }
  return results;
}

}  // namespace horopter::vision::testing
