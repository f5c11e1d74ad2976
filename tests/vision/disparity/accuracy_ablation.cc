// SPDX-License-Identifier: Apache-2.0
#include "accuracy_ablation.h"

#include <chrono>
#include <functional>
#include <numbers>

#include "vision/disparity/v1_closed_form.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision::testing {
namespace {

constexpr double kPriorDeg = 0.1;

EpipolarPrior PriorOf(const EyeTurn& turn) {
  const double angle = kPriorDeg * std::numbers::pi / 180;
  RelativePose pose{MotorcyclePose(turn)};
  pose.covariance.diagonal() << Eigen::Vector3d::Constant(angle * angle),
      Eigen::Vector3d::Constant(1e-6);
  const StereoCameras cameras = MotorcycleCameras();
  return {cameras.left, cameras.right, pose, {.min_depth_m = 1}};
}

}  // namespace

std::vector<Ablation> Ablations() {
  const ClosedFormConfig accurate = V1Config::Preset("accurate").closed_form;
  std::vector<Ablation> all = {{"as it is", accurate}};
  const auto without = [&](const char* change,
                           const std::function<void(ClosedFormConfig&)>& apply) {
    all.push_back({change, accurate});
    apply(all.back().config);
  };
  without("the published receptive field (f0 .25, sigma 2.25, 11x11)", [](ClosedFormConfig& c) {
    c.peak_frequency = 0.25;
    c.envelope_sigma_px = 2.25;
    c.filter_px = 11;
  });
  without("4 orientations", [](ClosedFormConfig& c) { c.orientations = 4; });
  without("8 orientations", [](ClosedFormConfig& c) { c.orientations = 8; });
  without("no competition with neighbours", [](ClosedFormConfig& c) { c.neighbour_px = {}; });
  without("no far neighbours (1 and 4 px only)", [](ClosedFormConfig& c) {
    c.neighbour_px = {1, 4, 0, 0};
  });
  without("two rounds of competition", [](ClosedFormConfig& c) { c.rounds = 2; });
  without("two rounds, least coherence .40", [](ClosedFormConfig& c) {
    c.rounds = 2;
    c.min_coherence = 0.40;
  });
  without("least coherence .34", [](ClosedFormConfig& c) { c.min_coherence = 0.34; });
  without("no steps of 2 px among the hypotheses",
          [](ClosedFormConfig& c) { c.try_steps_from = 100; });
  without("no exploration of the range at 1/2 and 1/4", [](ClosedFormConfig& c) {
    c.explore_from = 1;
    c.explore_to = 0;
  });
  without("the own hypothesis not favoured", [](ClosedFormConfig& c) { c.favour_own = 0; });
  without("scores pooled across edges", [](ClosedFormConfig& c) { c.score_pool_grey = 1e6; });
  without("products pooled across edges", [](ClosedFormConfig& c) { c.product_pool_grey = 1e6; });
  without("products pooled over 2.5 px instead of 4",
          [](ClosedFormConfig& c) { c.product_pool_px = 2.5; });
  without("no smoothing before constraints are intersected",
          [](ClosedFormConfig& c) { c.smooth_px = 0; });
  without("two intersections of constraints", [](ClosedFormConfig& c) { c.iterations = 2; });
  without("no median", [](ClosedFormConfig& c) { c.median_px = 0; });
  without("no least coherence", [](ClosedFormConfig& c) { c.min_coherence = -1; });
  without("no left-right check", [](ClosedFormConfig& c) { c.left_right_px = 0; });
  without("small segments kept", [](ClosedFormConfig& c) { c.min_segment_px = 0; });
  all.push_back({"with the eyes' pose, known to 0.1 deg, as prior", accurate, true});
  return all;
}

AblationResult RunAblation(const Ablation& ablation, const PairWithTruth& pair,
                           const EyeTurn& turn) {
  V1ClosedFormEstimator estimator(ablation.config);
  if (ablation.with_prior) estimator.SetPrior(PriorOf(turn));
  estimator.Estimate(pair.left, pair.right);  // fills buffers
  const auto start = std::chrono::steady_clock::now();
  const DisparityField field = estimator.Estimate(pair.left, pair.right);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  const FieldScore score = Score(field, pair.dx, pair.dy);
  return {score.density, score.median_error_px, score.bad2, taken.count()};
}

}  // namespace horopter::vision::testing
