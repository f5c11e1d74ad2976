// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "real_pair.h"
#include "vision/disparity/disparity_factory.h"
#include "vision/disparity/field_score.h"

namespace horopter::vision::testing {

/// "v1:accurate": a method and one of its presets.
struct MethodChoice {
  std::string method;
  std::string preset;

  /// @throws std::invalid_argument when there is no such method or preset
  static MethodChoice Parse(const std::string& text);
  std::string name() const { return method + ":" + preset; }
};

/// What a method made of a pair.
struct MethodResult {
  std::string name;
  ErrorScore score;  ///< of the vector
  double median_ms = 0;
  DisparityField field;
};

/// Estimates and times all methods on one pair, one pass of each in turn, so that what disturbs the
/// machine disturbs all alike; a first pass of each is not counted. Methods for rectified pairs are
/// left out where there is no range.
std::vector<MethodResult> RunMethods(const std::vector<MethodChoice>& methods,
                                     const PairWithTruth& pair,
                                     const std::optional<SearchRange>& range, int repeat);

}  // namespace horopter::vision::testing
