// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "vision/disparity/dis_estimator.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// The disparity method of that name, as a user chooses it:
///
/// | method | presets (the first is the default, also chosen by "") |
/// |---|---|
/// | "v1"  | "checked", "cautious", "paper_2009" (V1Config) |
/// | "dis" | "medium", "fast", "ultrafast" (DisConfig) |
///
/// @throws std::invalid_argument naming the known methods, or the method's known presets.
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(std::string_view method,
                                                             std::string_view preset = "");

/// The same with parameters of the caller's own.
/// @throws ConfigError naming every bad field.
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const V1Config& config);
std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const DisConfig& config);

}  // namespace horopter::vision
