// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vision/disparity/bm_estimator.h"
#include "vision/disparity/dis_estimator.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/farneback_estimator.h"
#include "vision/disparity/search_range.h"
#include "vision/disparity/sgbm_estimator.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// A disparity method as a user chooses it.
struct DisparityMethod {
  std::string_view name;
  std::vector<std::string_view> presets;  ///< the first is the default, also chosen by ""
  bool horizontal_only = false;           ///< for rectified pairs: dy is 0, and a range is searched
  std::string_view summary;               ///< one line, for lists
};

/// Every method:
///
/// | method | presets |
/// |---|---|
/// | "v1"  | V1Config |
/// | "dis" | DisConfig |
/// | "farneback" | FarnebackConfig |
/// | "sgbm" | SgbmConfig |
/// | "bm" | BmConfig |
const std::vector<DisparityMethod>& DisparityMethods();

/// @throws std::invalid_argument that lists the known methods with their presets.
const DisparityMethod& FindDisparityMethod(std::string_view name);

/// The disparity method of that name.
/// @param range that is searched; only methods for rectified pairs have one
/// @throws std::invalid_argument naming the known methods, or the method's known presets, or
///         refusing the range; ConfigError when the range does not hold
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(
    std::string_view method, std::string_view preset = "",
    const std::optional<SearchRange>& range = std::nullopt);

/// The same with parameters of the caller's own.
/// @throws ConfigError naming every bad field.
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const V1Config& config);
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const DisConfig& config);
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const FarnebackConfig& config);
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const SgbmConfig& config);
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const BmConfig& config);

}  // namespace horopter::vision
