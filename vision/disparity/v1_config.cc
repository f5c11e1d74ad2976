// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_config.h"

#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/binocular_energy.h"
#include "vision/disparity/gabor_bank.h"

namespace horopter::vision {

std::vector<hardware::FieldError> V1Config::Validate() const {
  if (form == V1Form::kClosedForm) return closed_form.Validate();
  hardware::FieldChecker c("v1.");
  c.Require(normalisation_px == 0 ||
                (normalisation_px % 2 == 1 && normalisation_px >= 3 && normalisation_px <= 63),
            "normalisation_px", normalisation_px, "must be 0, or odd and 3 to 63");
  c.Require(orientations >= 2 && orientations <= kMaxOrientations, "orientations", orientations,
            "must be 2 to 16");
  c.Require(filter_px % 2 == 1 && filter_px >= 3 && filter_px <= 63, "filter_px", filter_px,
            "must be odd, 3 to 63");
  c.Require(peak_frequency > 0 && peak_frequency < 0.5, "peak_frequency", peak_frequency,
            "must be between 0 and 0.5 cycles/px");
  c.Positive("envelope_sigma_px", envelope_sigma_px);
  c.Require(phase_shifts >= 3 && phase_shifts <= kMaxPhaseShifts, "phase_shifts", phase_shifts,
            "must be 3 to 15");
  c.Require(max_disparity_px > 0 && max_disparity_px * peak_frequency < 0.5, "max_disparity_px",
            max_disparity_px, "must be positive and less than half a period of peak_frequency");
  c.Require(energy_exponent >= 0.05 && energy_exponent <= 2, "energy_exponent", energy_exponent,
            "must be 0.05 to 2");
  c.Require(readout_gain > 0 && readout_gain <= 10, "readout_gain", readout_gain,
            "must be above 0 and at most 10");
  c.Require(min_pooled > 0 && min_pooled <= 1, "min_pooled", min_pooled,
            "must be above 0 and at most 1");
  c.Require(response_threshold >= 0 && response_threshold < 1, "response_threshold",
            response_threshold, "must be in [0, 1)");
  c.Positive("saturation_grey", saturation_grey);
  c.Positive("noise_grey", noise_grey);
  c.Positive("min_signal_to_noise", min_signal_to_noise);
  c.NotNegative("min_orientation_response", min_orientation_response);
  c.Require(min_orientations >= 2 && min_orientations <= orientations, "min_orientations",
            min_orientations, "must be 2 to orientations");
  c.Require(min_conditioning > 0 && min_conditioning < 1, "min_conditioning", min_conditioning,
            "must be between 0 and 1");
  c.Require(pooling_sigma_px >= 0 && pooling_sigma_px <= 10, "pooling_sigma_px", pooling_sigma_px,
            "must be in [0, 10]");
  c.Require(scales >= 1 && scales <= 12, "scales", scales, "must be 1 to 12");
  c.Require(min_side_px >= 1, "min_side_px", min_side_px, "must be at least 1");
  c.Require(iterations >= 1 && iterations <= 100, "iterations", iterations, "must be 1 to 100");
  c.Require(median_px == 0 || median_px == 3 || median_px == 5, "median_px", median_px,
            "must be 0, 3 or 5");
  c.Require(max_kept_octaves >= 0 && max_kept_octaves <= 12, "max_kept_octaves", max_kept_octaves,
            "must be 0 to 12");
  c.Require(min_correlation >= -1 && min_correlation < 1, "min_correlation", min_correlation,
            "must be in [-1, 1)");
  c.NotNegative("left_right_px", left_right_px);
  c.Require(border_px >= 0, "border_px", border_px, "must not be negative");
  c.Require(min_segment_px >= 0, "min_segment_px", min_segment_px, "must not be negative");
  c.NotNegative("segment_step_px", segment_step_px);
  c.Positive("fill.reach_px", fill.reach_px);
  c.Positive("fill.colour_grey", fill.colour_grey);
  c.Require(fill.passes >= 1 && fill.passes <= 10, "fill.passes", fill.passes, "must be 1 to 10");
  return c.Take();
}

V1Config V1Config::Preset(std::string_view name) {
  V1Config config;
  if (name == "checked") return config;
  if (name == "accurate" || name == "dense" || name == "fast" || name == "realtime") {
    config.form = V1Form::kClosedForm;
    ClosedFormConfig& c = config.closed_form;
    c.fill_in = name == "dense";
    if (name == "accurate" || name == "dense") return config;
    c.explore_from = 2;
    c.iterations = 2;
    c.neighbour_px = {1, 6, 24, 0};
    c.try_steps_from = 1;
    // The coherence is measured before the refinements, and fewer neighbours find less of it.
    c.min_coherence = 0.25;
    if (name == "fast") return config;
    c.finest_octave = 1;
    c.min_coherence = 0.4;
    return config;
  }
  if (name == "cautious") {
    config.noise_grey = 2;
    config.max_kept_octaves = 0;
    config.border_px = 16;
    return config;
  }
  if (name == "paper_2009") {
    config.soft_threshold = false;
    config.noise_grey = 0.3;  // of rounding to 8 bits
    config.energy_weights = false;
    config.pooling_sigma_px = 0;
    config.iterations = 1;
    config.median_px = 0;
    config.max_kept_octaves = 12;  // all, however many scales
    config.min_correlation = -1;
    config.left_right_px = 0;
    config.min_segment_px = 0;
    return config;
  }
  if (name == "paper_2018") {
    config = Preset("paper_2009");
    config.normalisation_px = 5;
    config.orientations = 9;
    config.peak_frequency = 1 / 3.8;
    config.envelope_sigma_px = 2.56;
    config.phase_shifts = 11;
    config.max_disparity_px = 0.76;
    config.energy_exponent = 0.18;
    config.decoding = V1Decoding::kLinear;
    config.readout_gain = 1.3;
    config.min_pooled = 1;
    config.min_signal_to_noise = 0.05;  // only plain ground is without texture: noise has it
    config.pooling_sigma_px = 11 / 6.0;
    config.pyramid = PyramidStep::kHalfOctave;
    config.scales = 9;
    config.fill_in = true;
    config.fill.reach_px = 2.5;
    config.fill.colour_grey = 3 * 256 / 3;  // a third of the range, in each of three channels
    return config;
  }
  throw std::invalid_argument(
      "unknown v1 preset \"" + std::string(name) +
      "\": known are accurate, dense, fast, realtime, checked, cautious, paper_2009, "
      "paper_2018");
}

}  // namespace horopter::vision
