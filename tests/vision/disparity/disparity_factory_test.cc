// SPDX-License-Identifier: Apache-2.0
// The contract of DisparityEstimator, over every method and preset a user can choose.
#include "vision/disparity/disparity_factory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <utility>

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

using Choice = std::pair<const char*, const char*>;

class Estimators : public ::testing::TestWithParam<Choice> {
 protected:
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right) {
    return estimator_->Estimate(left, right);
  }
  std::unique_ptr<DisparityEstimator> estimator_ =
      CreateDisparityEstimator(GetParam().first, GetParam().second);
};

INSTANTIATE_TEST_SUITE_P(AllMethods, Estimators,
                         ::testing::Values(Choice("v1", "checked"), Choice("v1", "paper_2009"),
                                           Choice("dis", "medium"), Choice("dis", "fast"),
                                           Choice("dis", "ultrafast")),
                         [](const auto& instance) {
                           return std::string(instance.param.first) + "_" + instance.param.second;
                         });

TEST_P(Estimators, NamesItsMethod) { EXPECT_EQ(estimator_->name(), GetParam().first); }

TEST_P(Estimators, NearerPointsHaveNegativeDx) {
  const SyntheticPair pair = ShiftedPair(kSize, -5, 1.5);
  const auto score =
      ScoreWarp(Estimate(pair.left, pair.right), cv::Matx33d(1, 0, -5, 0, 1, 1.5, 0, 0, 1));
  EXPECT_LT(score.median_error_px, 0.25);
  EXPECT_GT(score.density, 0.7);
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
  EXPECT_GT(invalid, 0);
}

TEST_P(Estimators, SameBitsForAnyNumberOfThreadsAndAgain) {
  const SyntheticPair pair = ShiftedPair(kSize, 4.2, -0.7);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const DisparityField one = Estimate(pair.left, pair.right);
  cv::setNumThreads(2);
  const DisparityField two = Estimate(pair.left, pair.right);
  cv::setNumThreads(5);
  const DisparityField five = Estimate(pair.left, pair.right);
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
       {cv::Size(1, 1), cv::Size(3, 5), cv::Size(2, 90), cv::Size(16, 16), cv::Size(19, 33)}) {
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
  EXPECT_TRUE(SameBits(CreateDisparityEstimator("v1")->Estimate(pair.left, pair.right),
                       CreateDisparityEstimator("v1", "checked")->Estimate(pair.left, pair.right)));
}

TEST(DisparityFactory, UnknownNamesListTheKnown) {
  const auto complaint = [](const char* method, const char* preset) -> std::string {
    try {
      CreateDisparityEstimator(method, preset);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint("sgbm", ""), "unknown disparity method \"sgbm\": known are dis, v1");
  EXPECT_THAT(complaint("v1", "best"), ::testing::HasSubstr("checked, cautious, paper_2009"));
  EXPECT_THAT(complaint("dis", "slow"), ::testing::HasSubstr("medium, fast, ultrafast"));
}

TEST(DisparityFactory, BadParametersAreAllNamed) {
  DisConfig config;
  config.preset = 7;
  config.left_right_px = -1;
  config.min_contrast_grey = -1;
  config.contrast_window_px = 2;
  try {
    CreateDisparityEstimator(config);
    FAIL() << "accepted";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 4U);
  }
}

}  // namespace
}  // namespace horopter::vision
