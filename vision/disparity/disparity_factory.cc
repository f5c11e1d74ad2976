// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/disparity_factory.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "vision/disparity/v1_closed_form.h"
#include "vision/disparity/v1_energy.h"

namespace horopter::vision {
namespace {

template <typename Config>
Config WithRange(Config config, const std::optional<SearchRange>& range) {
  config.range = range.value_or(config.range);
  return config;
}

/// "dis (medium, fast), v1 (accurate)"
std::string KnownMethods() {
  std::string text;
  for (const DisparityMethod& method : DisparityMethods()) {
    text += (text.empty() ? "" : ", ") + std::string(method.name) + " (";
    for (const std::string_view preset : method.presets) {
      text += (preset == method.presets.front() ? "" : ", ") + std::string(preset);
    }
    text += ")";
  }
  return text;
}

}  // namespace

const std::vector<DisparityMethod>& DisparityMethods() {
  static const std::vector<DisparityMethod> methods = {
      {"v1",
       {"accurate", "dense", "fast", "realtime", "checked", "cautious", "paper_2009", "paper_2018"},
       false,
       "binocular energy model of V1"},
      {"dis",
       {"medium", "fast", "ultrafast", "medium_unchecked", "fast_unchecked", "ultrafast_unchecked"},
       false,
       "OpenCV's dense inverse search"},
      {"farneback",
       {"standard", "fast", "gaussian"},
       false,
       "OpenCV's flow by polynomial expansion"},
      {"sgbm",
       {"3way", "sgbm", "hh", "hh4", "3way_colour"},
       true,
       "OpenCV's semi-global matching, rectified pairs only"},
      {"bm",
       {"block_15", "block_9", "block_21"},
       true,
       "OpenCV's block matching, rectified pairs only"}};
  return methods;
}

const DisparityMethod& FindDisparityMethod(std::string_view name) {
  const auto& methods = DisparityMethods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [name](const DisparityMethod& m) { return m.name == name; });
  if (found == methods.end()) {
    throw std::invalid_argument("unknown disparity method \"" + std::string(name) +
                                "\": known are " + KnownMethods());
  }
  return *found;
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(
    std::string_view method, std::string_view preset, const std::optional<SearchRange>& range) {
  const DisparityMethod& chosen = FindDisparityMethod(method);
  if (preset.empty()) preset = chosen.presets.front();
  if (range && !chosen.horizontal_only) {
    throw std::invalid_argument("disparity method \"" + std::string(method) +
                                "\" takes no search range: it finds the range itself");
  }
  if (method == "v1") return CreateDisparityEstimator(V1Config::Preset(preset));
  if (method == "dis") return CreateDisparityEstimator(DisConfig::Preset(preset));
  if (method == "farneback") return CreateDisparityEstimator(FarnebackConfig::Preset(preset));
  if (method == "sgbm") {
    return CreateDisparityEstimator(WithRange(SgbmConfig::Preset(preset), range));
  }
  return CreateDisparityEstimator(WithRange(BmConfig::Preset(preset), range));
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const V1Config& config) {
  if (config.form == V1Form::kClosedForm) {
    return std::make_unique<V1ClosedFormEstimator>(config.closed_form);
  }
  return std::make_unique<V1EnergyEstimator>(config);
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const DisConfig& config) {
  return std::make_unique<DisEstimator>(config);
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const FarnebackConfig& config) {
  return std::make_unique<FarnebackEstimator>(config);
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const SgbmConfig& config) {
  return std::make_unique<SgbmEstimator>(config);
}

std::unique_ptr<DisparityEstimator> CreateDisparityEstimator(const BmConfig& config) {
  return std::make_unique<BmEstimator>(config);
}

}  // namespace horopter::vision
