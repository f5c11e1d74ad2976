// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/closed_form_config.h"

#include "hardware/types/field_checker.h"

namespace horopter::vision {

std::vector<hardware::FieldError> ClosedFormConfig::Validate() const {
  hardware::FieldChecker c("v1.closed_form.");
  c.Require(orientations >= 4 && orientations <= 8 && orientations % 2 == 0, "orientations",
            orientations, "must be 4, 6 or 8");
  c.Require(filter_px % 2 == 1 && filter_px >= 3 && filter_px <= 63, "filter_px", filter_px,
            "must be odd, 3 to 63");
  c.Require(peak_frequency > 0 && peak_frequency < 0.5, "peak_frequency", peak_frequency,
            "must be between 0 and 0.5 cycles/px");
  c.Positive("envelope_sigma_px", envelope_sigma_px);
  c.Positive("saturation_grey", saturation_grey);
  c.Require(search_octave >= 0 && search_octave <= 8, "search_octave", search_octave,
            "must be 0 to 8");
  c.Require(search_x_px >= 1 && search_x_px <= 2000, "search_x_px", search_x_px,
            "must be 1 to 2000");
  c.Require(search_y_px >= 0 && search_y_px <= 2000, "search_y_px", search_y_px,
            "must be 0 to 2000");
  c.Require(explore_from >= 0, "explore_from", explore_from, "must not be negative");
  for (const int distance : neighbour_px) {
    c.Require(distance >= 0 && distance <= 1000, "neighbour_px", distance, "must be 0 to 1000");
  }
  c.Require(rounds >= 1 && rounds <= 10, "rounds", rounds, "must be 1 to 10");
  c.Require(favour_own >= 0 && favour_own < 0.5, "favour_own", favour_own, "must be in [0, 0.5)");
  c.Require(finest_octave >= 0 && finest_octave <= search_octave, "finest_octave", finest_octave,
            "must be 0 to search_octave");
  c.Positive("max_noise_to_texture", max_noise_to_texture);
  c.Positive("score_pool_px", score_pool_px);
  c.Positive("score_pool_grey", score_pool_grey);
  c.Positive("product_pool_px", product_pool_px);
  c.Positive("product_pool_grey", product_pool_grey);
  c.Require(iterations >= rounds && iterations <= 100, "iterations", iterations,
            "must be rounds to 100");
  c.Require(smooth_px >= 0 && smooth_px <= 16, "smooth_px", smooth_px, "must be 0 to 16");
  c.Positive("smooth_step_px", smooth_step_px);
  c.Require(ridge > 0 && ridge < 1, "ridge", ridge, "must be between 0 and 1");
  c.Positive("max_step_px", max_step_px);
  c.Require(median_px == 0 || median_px == 3 || median_px == 5, "median_px", median_px,
            "must be 0, 3 or 5");
  c.Require(min_coherence >= -1 && min_coherence < 1, "min_coherence", min_coherence,
            "must be in [-1, 1)");
  c.NotNegative("left_right_px", left_right_px);
  c.Require(try_steps_from >= 0, "try_steps_from", try_steps_from, "must not be negative");
  c.Require(min_segment_px >= 0, "min_segment_px", min_segment_px, "must not be negative");
  c.NotNegative("segment_step_px", segment_step_px);
  return c.Take();
}

}  // namespace horopter::vision
