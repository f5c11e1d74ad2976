// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "vision/disparity/binocular_energy.h"
#include "vision/disparity/disparity_factory.h"
#include "vision/disparity/v1_energy.h"

namespace horopter::vision {
namespace {

TEST(V1Config, PresetsHold) {
  for (const char* name : {"accurate", "dense", "fast", "realtime"}) {
    const V1Config config = V1Config::Preset(name);
    EXPECT_EQ(config.form, V1Form::kClosedForm) << name;
    EXPECT_TRUE(config.Validate().empty()) << name;
  }
  for (const char* name : {"checked", "cautious", "paper_2009", "paper_2018"}) {
    const V1Config config = V1Config::Preset(name);
    EXPECT_EQ(config.form, V1Form::kPopulation) << name;
    EXPECT_TRUE(config.Validate().empty()) << name;
  }
  EXPECT_EQ(FindDisparityMethod("v1").presets.size(), 8U) << "one is not held here";
}

TEST(V1Config, ClosedPresetsAreWhatTheirNamesSay) {
  const ClosedFormConfig accurate = V1Config::Preset("accurate").closed_form;
  const ClosedFormConfig dense = V1Config::Preset("dense").closed_form;
  const ClosedFormConfig fast = V1Config::Preset("fast").closed_form;
  const ClosedFormConfig realtime = V1Config::Preset("realtime").closed_form;
  EXPECT_FALSE(accurate.fill_in || fast.fill_in || realtime.fill_in);
  EXPECT_TRUE(dense.fill_in);
  EXPECT_LE(fast.rounds, accurate.rounds);
  EXPECT_LT(fast.iterations, accurate.iterations);
  EXPECT_GT(fast.explore_from, accurate.explore_from);
  EXPECT_EQ(fast.finest_octave, 0);
  EXPECT_EQ(realtime.finest_octave, 1);
  for (const ClosedFormConfig& checked : {accurate, dense, fast, realtime}) {
    EXPECT_GT(checked.left_right_px, 0);
    EXPECT_GT(checked.min_coherence, 0);
  }
}

/// Whichever form is not chosen is not read, and so not checked.
TEST(V1Config, OnlyTheFormThatIsChosenMustHold) {
  V1Config config = V1Config::Preset("fast");
  config.filter_px = 10;
  EXPECT_TRUE(config.Validate().empty());
  config.closed_form.filter_px = 10;
  ASSERT_EQ(config.Validate().size(), 1U);
  EXPECT_EQ(config.Validate()[0].field, "v1.closed_form.filter_px");
}

TEST(V1Config, PaperPresetIsThePublishedModelAlone) {
  const V1Config paper = V1Config::Preset("paper_2009");
  EXPECT_EQ(paper.left_right_px, 0);
  EXPECT_EQ(paper.median_px, 0);
  EXPECT_EQ(paper.iterations, 1);
  EXPECT_EQ(paper.pooling_sigma_px, 0);
  EXPECT_EQ(paper.scales, 6);
  EXPECT_EQ(paper.min_correlation, -1);
  EXPECT_FALSE(paper.soft_threshold);
}

TEST(V1Config, PaperPresetOf2018IsThePublishedModelAlone) {
  const V1Config paper = V1Config::Preset("paper_2018");
  EXPECT_EQ(paper.pyramid, PyramidStep::kHalfOctave);
  EXPECT_EQ(paper.scales, 9);
  EXPECT_EQ(paper.orientations, 9);
  EXPECT_EQ(paper.filter_px, 11);
  EXPECT_DOUBLE_EQ(paper.peak_frequency, 1 / 3.8);
  EXPECT_NEAR(paper.envelope_sigma_px,
              1.2 * std::sqrt(2 * std::log(2)) / (2 * M_PI * paper.peak_frequency / 3), 0.01);
  EXPECT_EQ(paper.phase_shifts, 11);
  EXPECT_EQ(paper.max_disparity_px, 0.76);
  EXPECT_EQ(paper.normalisation_px, 5);
  EXPECT_EQ(paper.energy_exponent, 0.18);
  EXPECT_EQ(paper.decoding, V1Decoding::kLinear);
  EXPECT_DOUBLE_EQ(paper.pooling_sigma_px, 11 / 6.0);
  EXPECT_TRUE(paper.fill_in);
  EXPECT_EQ(paper.iterations, 1);
  EXPECT_EQ(paper.median_px, 0);
  EXPECT_EQ(paper.left_right_px, 0);
  EXPECT_EQ(paper.min_correlation, -1);
  EXPECT_EQ(paper.min_segment_px, 0);
}

TEST(V1Config, UnknownPresetNamesTheKnown) {
  try {
    V1Config::Preset("quick");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"quick\""));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("checked, cautious, paper_2009, paper_2018"));
  }
}

TEST(V1Config, EveryBadFieldIsReportedAtOnce) {
  V1Config bad;
  bad.filter_px = 10;
  bad.peak_frequency = std::numeric_limits<double>::quiet_NaN();
  bad.envelope_sigma_px = 0;
  bad.max_disparity_px = -1;
  bad.response_threshold = 1;
  bad.saturation_grey = 0;
  bad.noise_grey = 0;
  bad.min_signal_to_noise = -1;
  bad.min_orientation_response = -1;
  bad.min_orientations = 9;
  bad.min_conditioning = 1;
  bad.pooling_sigma_px = -1;
  bad.scales = 0;
  bad.min_side_px = 0;
  bad.iterations = 0;
  bad.median_px = 4;
  bad.max_kept_octaves = -1;
  bad.min_correlation = 1;
  bad.left_right_px = std::numeric_limits<double>::infinity();
  bad.normalisation_px = 4;
  bad.orientations = kMaxOrientations + 1;
  bad.min_orientations = kMaxOrientations + 2;
  bad.phase_shifts = 2;
  bad.energy_exponent = 0;
  bad.readout_gain = 0;
  bad.min_pooled = 1.5;
  bad.fill = {0, -1, 0};
  EXPECT_EQ(bad.Validate().size(), 28U);
  try {
    const V1EnergyEstimator estimator(bad);
    FAIL() << "accepted";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 28U);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("v1.filter_px = 10: must be odd, 3 to 63"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("v1.left_right_px = inf"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("v1.orientations = 17: must be 2 to 16"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("v1.fill.passes = 0: must be 1 to 10"));
  }
}

TEST(V1Config, PhaseShiftsMustNotWrap) {
  V1Config config;
  config.max_disparity_px = 2;  // half a period of 0.25 cycles/px
  ASSERT_EQ(config.Validate().size(), 1U);
  EXPECT_EQ(config.Validate()[0].field, "v1.max_disparity_px");
}

}  // namespace
}  // namespace horopter::vision
