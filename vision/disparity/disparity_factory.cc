// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/disparity_factory.h"

#include <stdexcept>
#include <string>

#include "vision/disparity/v1_energy.h"

namespace horopter::vision {

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(std::string_view method,
                                                             std::string_view preset) {
  if (method == "v1") {
    return CreateDisparityEstimator(V1Config::Preset(preset.empty() ? "checked" : preset));
  }
  if (method == "dis") {
    return CreateDisparityEstimator(DisConfig::Preset(preset.empty() ? "medium" : preset));
  }
  throw std::invalid_argument("unknown disparity method \"" + std::string(method) +
                              "\": known are dis, v1");
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const V1Config& config) {
  return std::make_unique<V1EnergyEstimator>(config);
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const DisConfig& config) {
  return std::make_unique<DisEstimator>(config);
}

}  // namespace horopter::vision
