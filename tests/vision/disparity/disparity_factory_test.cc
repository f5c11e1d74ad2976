// SPDX-License-Identifier: Apache-2.0
// The contract of DisparityEstimator, over every method and preset a user can choose.
#include "vision/disparity/disparity_factory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "on_threads.h"
#include "textured_pair.h"

namespace horopter::vision {
namespace {

using testing::ScoreWarp;
using testing::ShiftedPair;
using testing::SyntheticPair;

const cv::Size kSize(160, 121);

bool SameBits(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a.ptr(y), b.ptr(y), a.cols * a.elemSize()) != 0) return false;
  }
  return true;
}

bool SameBits(const DisparityField& a, const DisparityField& b) {
  return SameBits(a.dx, b.dx) && SameBits(a.dy, b.dy) && SameBits(a.confidence, b.confidence) &&
         SameBits(a.valid, b.valid);
}

/// A method, a preset, and the range it searches where it has one.
struct Choice {
  std::string method;
  std::string preset;
  std::optional<SearchRange> range;
};

std::ostream& operator<<(std::ostream& out, const Choice& choice) {
  return out << choice.method << ":" << choice.preset;
}

std::vector<Choice> AllChoices() {
  std::vector<Choice> choices;
  for (const DisparityMethod& method : DisparityMethods()) {
    std::optional<SearchRange> range;
    if (method.horizontal_only) range = SearchRange::Covering(-16, 16);
    for (const std::string_view preset : method.presets) {
      choices.push_back({std::string(method.name), std::string(preset), range});
    }
  }
  return choices;
}

class Estimators : public ::testing::TestWithParam<Choice> {
 protected:
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right) {
    return estimator_->Estimate(left, right);
  }
  /// Methods for rectified pairs see none.
  double Vertical(double dy) const { return GetParam().range ? 0 : dy; }

  std::unique_ptr<DisparityEstimator> estimator_ =
      CreateDisparityEstimator(GetParam().method, GetParam().preset, GetParam().range);
};

INSTANTIATE_TEST_SUITE_P(AllMethods, Estimators, ::testing::ValuesIn(AllChoices()),
                         [](const auto& instance) {
                           return instance.param.method + "_" + instance.param.preset;
                         });

TEST_P(Estimators, NamesItsMethod) { EXPECT_EQ(estimator_->name(), GetParam().method); }

TEST_P(Estimators, NearerPointsHaveNegativeDx) {
  const double dy = Vertical(1.5);
  // Wide enough that borders, which some methods leave out, are a small part of it.
  const SyntheticPair pair = ShiftedPair({320, 240}, -5, dy);
  const auto score =
      ScoreWarp(Estimate(pair.left, pair.right), cv::Matx33d(1, 0, -5, 0, 1, dy, 0, 0, 1));
  EXPECT_LT(score.median_error_px, 0.25);
  EXPECT_GT(score.density, 0.7);
}

TEST_P(Estimators, FrameGivesTheFieldOfItsImages) {
  const SyntheticPair pair = ShiftedPair(kSize, 1.5, 0);
  hardware::StereoFrame frame;
  cv::merge(std::vector<cv::Mat>(3, pair.left), frame.left.bgr);
  cv::merge(std::vector<cv::Mat>(3, pair.right), frame.right.bgr);
  const DisparityField field = estimator_->Estimate(frame);
  EXPECT_GT(cv::countNonZero(field.valid), 0);
  EXPECT_TRUE(SameBits(field, Estimate(frame.left.bgr, frame.right.bgr)));
}

TEST_P(Estimators, StagesAreTimedOncePerPairAndChangeNothing) {
  const SyntheticPair pair = ShiftedPair(kSize, 1.5, 0);
  hardware::StageTimes times;
  const DisparityField timed = estimator_->Estimate(pair.left, pair.right, &times);
  EXPECT_TRUE(SameBits(timed, Estimate(pair.left, pair.right)));
  EXPECT_FALSE(times.samples().empty());
  for (const auto& [stage, samples] : times.samples()) EXPECT_EQ(samples.size(), 1U) << stage;
}

TEST_P(Estimators, InvalidIsNaNAndConfidenceInRange) {
  SyntheticPair pair = ShiftedPair(kSize, 2, 0);
  pair.left.colRange(0, 80).setTo(90);
  const DisparityField field = Estimate(pair.left, pair.right);
  ASSERT_EQ(field.valid.size(), kSize);
  int invalid = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const bool valid = field.valid(y, x) != 0;
      invalid += valid ? 0 : 1;
      EXPECT_TRUE(field.valid(y, x) == 0 || field.valid(y, x) == 255);
      EXPECT_EQ(std::isnan(field.dx(y, x)), !valid);
      EXPECT_EQ(std::isnan(field.dy(y, x)), !valid);
      EXPECT_TRUE(field.confidence(y, x) >= 0 && field.confidence(y, x) <= 1);
      if (!valid) {
        EXPECT_EQ(field.confidence(y, x), 0);
      }
    }
  }
  EXPECT_GT(invalid + (field.filled.empty() ? 0 : cv::countNonZero(field.filled)), 0);
}

/// OpenCV's loops and ours ask different libraries how many threads there are.
TEST_P(Estimators, SameBitsForAnyNumberOfThreadsAndAgain) {
  const SyntheticPair pair = ShiftedPair(kSize, 4.2, Vertical(-0.7));
  const int threads = cv::getNumThreads();
  const auto estimate_on = [&](int count) {
    return testing::OnThreads(count, [&] {
      cv::setNumThreads(count);
      return Estimate(pair.left, pair.right);
    });
  };
  const DisparityField one = estimate_on(1), two = estimate_on(2), five = estimate_on(5);
  cv::setNumThreads(threads);
  EXPECT_TRUE(SameBits(one, two));
  EXPECT_TRUE(SameBits(one, five));
}

TEST_P(Estimators, ColourlessColourEqualsGrey) {
  const SyntheticPair pair = ShiftedPair(kSize, 1.5, 0);
  cv::Mat left, right;
  cv::merge(std::vector<cv::Mat>{pair.left, pair.left, pair.left}, left);
  cv::merge(std::vector<cv::Mat>{pair.right, pair.right, pair.right}, right);
  EXPECT_TRUE(SameBits(Estimate(left, right), Estimate(pair.left, pair.right)));
}

TEST_P(Estimators, InputIsLeftAsItWas) {
  const SyntheticPair pair = ShiftedPair(kSize, 1.5, 0);
  const cv::Mat left = pair.left.clone();
  const cv::Mat right = pair.right.clone();
  Estimate(pair.left, pair.right);
  EXPECT_TRUE(SameBits(left, pair.left) && SameBits(right, pair.right));
}

TEST_P(Estimators, PlainOrTinyImagesGiveAnEmptyFieldNotAnError) {
  const cv::Mat1b plain(kSize, static_cast<unsigned char>(77));
  EXPECT_EQ(cv::countNonZero(Estimate(plain, plain).valid), 0);
  const SyntheticPair pair = ShiftedPair(kSize, 1, 0);
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(3, 5), cv::Size(2, 90), cv::Size(16, 16), cv::Size(19, 33),
        cv::Size(120, 1), cv::Size(120, 2), cv::Size(120, 7), cv::Size(60, 30)}) {
    const cv::Rect part(cv::Point(0, 0), size);
    EXPECT_EQ(Estimate(pair.left(part), pair.right(part)).valid.size(), size);
  }
}

TEST_P(Estimators, MismatchedImagesThrow) {
  EXPECT_THROW(Estimate(cv::Mat1b(8, 8), cv::Mat1b(8, 9)), std::invalid_argument);
  EXPECT_THROW(Estimate(cv::Mat1b(8, 8), cv::Mat3b(8, 8)), std::invalid_argument);
  EXPECT_THROW(Estimate(cv::Mat(), cv::Mat()), std::invalid_argument);
}

TEST(DisparityFactory, DefaultsToTheFirstPreset) {
  const SyntheticPair pair = ShiftedPair(kSize, 1.5, 0);
  for (const DisparityMethod& method : DisparityMethods()) {
    const auto first = CreateDisparityEstimator(method.name, method.presets.front());
    const auto unnamed = CreateDisparityEstimator(method.name);
    EXPECT_TRUE(
        SameBits(unnamed->Estimate(pair.left, pair.right), first->Estimate(pair.left, pair.right)))
        << method.name;
  }
}

/// What the factory says against it; "" when it takes it.
std::string Complaint(std::string_view method, std::string_view preset,
                      const std::optional<SearchRange>& range = std::nullopt) {
  try {
    CreateDisparityEstimator(method, preset, range);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DisparityFactory, UnknownMethodsListTheKnownWithTheirPresets) {
  const std::string complaint = Complaint("elas", "");
  EXPECT_THAT(complaint, ::testing::HasSubstr("unknown disparity method \"elas\": known are v1 ("));
  EXPECT_THAT(complaint, ::testing::HasSubstr("bm (block_15, block_9, block_21)"));
}

TEST(DisparityFactory, UnknownPresetsListTheKnown) {
  for (const DisparityMethod& method : DisparityMethods()) {
    const std::string complaint = Complaint(method.name, "nosuch");
    EXPECT_THAT(complaint, ::testing::HasSubstr("\"nosuch\""));
    for (const std::string_view preset : method.presets) {
      if (preset.ends_with("_unchecked")) continue;  // listed as one ending
      EXPECT_THAT(complaint, ::testing::HasSubstr(std::string(preset)));
    }
  }
  EXPECT_THAT(Complaint("dis", "slow_unchecked"), ::testing::HasSubstr("\"slow_unchecked\""));
}

TEST(DisparityFactory, OnlyMethodsForRectifiedPairsTakeARange) {
  const SearchRange range = SearchRange::Covering(-10, 40);
  for (const DisparityMethod& method : DisparityMethods()) {
    EXPECT_EQ(Complaint(method.name, "", range).empty(), method.horizontal_only) << method.name;
  }
  EXPECT_THAT(Complaint("dis", "", range), ::testing::HasSubstr("takes no search range"));
  EXPECT_THAT(Complaint("sgbm", "", SearchRange{0, 17}),
              ::testing::HasSubstr("sgbm.range.count_px = 17: must be a multiple of 16"));
}

/// The fields that a configuration's Validate() objects to.
std::vector<std::string> BadFields(const std::vector<hardware::FieldError>& errors) {
  std::vector<std::string> fields;
  for (const hardware::FieldError& error : errors) fields.push_back(error.field);
  return fields;
}

TEST(DisparityFactory, BadParametersAreAllNamed) {
  DisConfig dis;
  dis.preset = 7;
  dis.left_right_px = -1;
  dis.texture = {-1, 2};
  EXPECT_THAT(BadFields(dis.Validate()),
              ::testing::ElementsAre("dis.preset", "dis.left_right_px",
                                     "dis.texture.min_contrast_grey", "dis.texture.window_px"));
  EXPECT_THROW(CreateDisparityEstimator(dis), hardware::ConfigError);

  FarnebackConfig farneback;
  farneback.pyramid_scale = 1;
  farneback.polynomial_px = 6;
  farneback.iterations = 0;
  EXPECT_THAT(BadFields(farneback.Validate()),
              ::testing::ElementsAre("farneback.pyramid_scale", "farneback.iterations",
                                     "farneback.polynomial_px"));
  EXPECT_THROW(CreateDisparityEstimator(farneback), hardware::ConfigError);

  SgbmConfig sgbm;
  sgbm.range = {3000, 0};
  sgbm.block_px = 4;
  sgbm.large_step_penalty = sgbm.small_step_penalty;
  EXPECT_THAT(BadFields(sgbm.Validate()),
              ::testing::ElementsAre("sgbm.range.min_px", "sgbm.range.count_px", "sgbm.block_px",
                                     "sgbm.large_step_penalty"));
  EXPECT_THROW(CreateDisparityEstimator(sgbm), hardware::ConfigError);

  BmConfig bm;
  bm.block_px = 3;
  bm.uniqueness_percent = 100;
  EXPECT_THAT(BadFields(bm.Validate()),
              ::testing::ElementsAre("bm.block_px", "bm.uniqueness_percent"));
  EXPECT_THROW(CreateDisparityEstimator(bm), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::vision
