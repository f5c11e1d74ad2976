// SPDX-License-Identifier: Apache-2.0
// What the methods for rectified pairs have in common beyond the contract of every method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "real_pair.h"
#include "textured_pair.h"
#include "vision/disparity/disparity_factory.h"

namespace horopter::vision {
namespace {

using testing::ShiftedPair;
using testing::SyntheticPair;

TEST(SearchRange, CoversWhatIsAskedInMultiplesOfSixteen) {
  EXPECT_EQ(SearchRange::Covering(0, 16).count_px, 16);
  EXPECT_EQ(SearchRange::Covering(-3, 30).count_px, 48);
  EXPECT_EQ(SearchRange::Covering(5, 2).count_px, 16);
  EXPECT_TRUE(SearchRange::Covering(-3, 30).Validate().empty());
}

class RectifiedMethods : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, RectifiedMethods, ::testing::Values("sgbm", "bm"));

TEST_P(RectifiedMethods, DisparityOfEitherSignHasNoVerticalPart) {
  const cv::Size size(200, 90);
  for (const double dx : {-20.0, 12.0}) {
    const SyntheticPair pair = ShiftedPair(size, dx, 0);
    const auto estimator = CreateDisparityEstimator(GetParam(), "", SearchRange::Covering(-32, 32));
    const DisparityField field = estimator->Estimate(pair.left, pair.right);
    ASSERT_GT(cv::countNonZero(field.valid), 5000);
    EXPECT_EQ(cv::norm(field.dy, cv::Mat1f::zeros(size), cv::NORM_INF, field.valid), 0);
    EXPECT_NEAR(cv::mean(field.dx, field.valid)[0], dx, 0.1);
  }
}

TEST_P(RectifiedMethods, ImagesNarrowerThanTheRangeGiveAnEmptyField) {
  const SyntheticPair pair = ShiftedPair({130, 90}, -5, 0);
  const DisparityField field =
      CreateDisparityEstimator(GetParam())->Estimate(pair.left, pair.right);
  EXPECT_EQ(cv::countNonZero(field.valid), 0);
  EXPECT_EQ(field.dx.size(), cv::Size(130, 90));
}

// What OpenCV's samples reach on this pair, with the parameters of their own.
TEST(RectifiedMotorcycle, PeersAreAsGoodAsTheyAreElsewhere) {
  const auto folder = testing::DataFolder();
  if (!folder) GTEST_SKIP() << testing::kDataRemedy;
  const testing::PairWithTruth pair = testing::RectifiedPair(*folder, "motorcycle");
  const auto score = [&](const char* method) {
    const auto estimator = CreateDisparityEstimator(method, "", SearchRange::Covering(0, 64));
    return testing::Score(estimator->Estimate(pair.left, pair.right), pair.dx, pair.dy);
  };
  const testing::FieldScore sgbm = score("sgbm"), bm = score("bm");
  EXPECT_GE(sgbm.density, 0.84);
  EXPECT_LE(sgbm.median_error_px, 0.18);
  EXPECT_LE(sgbm.bad2, 0.06);
  EXPECT_GE(bm.density, 0.73);
  EXPECT_LE(bm.median_error_px, 0.17);
  EXPECT_LE(bm.bad2, 0.07);
}

TEST(SgbmEstimator, RefusesWhatWouldNotFitIntoMemory) {
  const cv::Mat1b large = cv::Mat1b::zeros(4320, 7680);
  for (const char* preset : {"hh", "hh4"}) {
    const auto estimator = CreateDisparityEstimator("sgbm", preset);
    try {
      estimator->Estimate(large, large);
      FAIL() << preset;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("16986 MB for 7680x4320: choose 3way"));
    }
  }
}

}  // namespace
}  // namespace horopter::vision
