// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>

#include "hardware/types/config_error.h"
#include "sim/textures/paint.h"
#include "sim/textures/solid_shapes.h"

namespace horopter::sim {
namespace {

constexpr Side kSides[] = {Side::kFront, Side::kBack, Side::kLeft,
                           Side::kRight, Side::kTop,  Side::kBottom};

/// A side of a box of 0.2 x 0.2 x 0.3 m.
Surface SideOf(Side side) {
  const bool end = side == Side::kTop || side == Side::kBottom;
  return {0.2, end ? 0.2 : 0.3, side, end ? 0.3 : 0.2};
}

TextureRecipe Recipe(const std::string& text) { return ParseTextureRecipe("thing", text); }

TEST(SolidShapes, EverySideIsWhereItsNameSays) {
  const cv::Vec3d middles[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int i = 0; i < 6; ++i) {
    const Surface s = SideOf(kSides[i]);
    EXPECT_LT(cv::norm(UnitBoxPoint(s, s.width_m / 2, s.height_m / 2) - middles[i]), 1e-12) << i;
  }
  // Upright, and not mirrored: what is right as seen from outside.
  EXPECT_LT(cv::norm(UnitBoxPoint(SideOf(Side::kFront), 0.2, 0) - cv::Vec3d(1, 1, 1)), 1e-12);
  EXPECT_LT(cv::norm(UnitBoxPoint(SideOf(Side::kLeft), 0.2, 0) - cv::Vec3d(-1, 1, 1)), 1e-12);
  EXPECT_LT(cv::norm(UnitBoxPoint(SideOf(Side::kBack), 0.2, 0) - cv::Vec3d(-1, -1, 1)), 1e-12);
  EXPECT_LT(cv::norm(UnitBoxPoint(SideOf(Side::kTop), 0.2, 0) - cv::Vec3d(1, 1, 1)), 1e-12);
}

TEST(SolidShapes, TheCylindersWallAndLidsAreSeenAlongRaysFromItsCentre) {
  const CylinderPoint front = OnCylinder(SideOf(Side::kFront), 0.1, 0.15);
  EXPECT_NEAR(front.angle_rad, 0, 1e-12);
  EXPECT_NEAR(front.down, 0.5, 1e-12);
  EXPECT_EQ(front.radius, 1);
  const CylinderPoint left = OnCylinder(SideOf(Side::kLeft), 0.1, 0.075);
  EXPECT_NEAR(left.angle_rad, M_PI / 2, 1e-12);
  EXPECT_NEAR(left.down, 0.25, 1e-12);
  const CylinderPoint lid = OnCylinder(SideOf(Side::kTop), 0.15, 0.1);
  EXPECT_EQ(lid.down, 0);
  EXPECT_NEAR(lid.radius, 0.5, 1e-12);
  EXPECT_NEAR(SizeOfCylinder(SideOf(Side::kTop)).radius_m, 0.1, 1e-12);
  EXPECT_NEAR(SizeOfCylinder(SideOf(Side::kTop)).height_m, 0.3, 1e-12);
  EXPECT_NEAR(SizeOfCylinder({2 * M_PI * 0.1, 0.3}).radius_m, 0.1, 1e-12);
}

constexpr int kRows = 200;

/// In how many of 200 rows the colour jumps where the front of a box meets its left side (which,
/// as seen from outside, lies to the right), beyond those rows where it jumps as much within the
/// front.
int SeamRows(const std::string& front_text, const std::string& left_text) {
  const cv::Mat front = Paint(Recipe(front_text), SideOf(Side::kFront), 1, kRows, kRows);
  const cv::Mat left = Paint(Recipe(left_text), SideOf(Side::kLeft), 1, kRows, kRows);
  int jumps = 0;
  for (int row = 0; row < kRows; ++row) {
    const auto apart = [row](const cv::Mat& a, int ca, const cv::Mat& b, int cb) {
      return cv::norm(a.at<cv::Vec3b>(row, ca), b.at<cv::Vec3b>(row, cb)) > 60;
    };
    jumps += apart(front, kRows - 1, left, 0) - apart(front, kRows - 3, front, kRows - 2);
  }
  return jumps;
}

TEST(HouseholdPainters, CoatsAndLabelsHaveNoSeamsBetweenTheSidesOfTheirBox) {
  for (const std::string kind : {"tiger", "giraffe", "label", "crockery"}) {
    const std::string one = kind + ",size_m=0.2x0.2x0.3,print=1";
    EXPECT_LT(SeamRows(one, one), kRows / 10) << kind;
    int most = 0;
    for (const char* print : {"2", "3", "4", "5"}) {
      most = std::max(most, SeamRows(one, kind + ",size_m=0.2x0.2x0.3,print=" + print));
    }
    EXPECT_GT(most, kRows / 10) << kind << ": sides of two prints do not fit";
  }
}

TEST(HouseholdPainters, AThingWithAPrintLooksTheSameInEveryRun) {
  for (const std::string kind : {"package", "label", "crockery", "tiger", "giraffe"}) {
    const TextureRecipe known = Recipe(kind + ",size_m=0.2x0.3,print=4");
    const TextureRecipe other = Recipe(kind + ",size_m=0.2x0.3,print=5");
    const auto paint = [](const TextureRecipe& recipe, std::uint64_t seed) {
      return Paint(recipe, SideOf(Side::kFront), seed, 64, 96);
    };
    EXPECT_EQ(cv::norm(paint(known, 1), paint(known, 2), cv::NORM_INF), 0) << kind;
    EXPECT_GT(cv::norm(paint(known, 1), paint(other, 1), cv::NORM_INF), 60) << kind;
  }
}

TEST(HouseholdPainters, APackageHasTwoMainPanelsAndTwoOthers) {
  const TextureRecipe recipe = Recipe("package,size_m=0.2x0.2x0.3,print=2,word=RICE,motif=1");
  const auto paint = [&](Side side) { return Paint(recipe, SideOf(side), 1, 64, 96); };
  EXPECT_EQ(cv::norm(paint(Side::kFront), paint(Side::kBack), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(paint(Side::kFront), paint(Side::kLeft), cv::NORM_INF), 100);
  EXPECT_GT(cv::norm(paint(Side::kLeft), paint(Side::kRight), cv::NORM_INF), 100);
}

TEST(HouseholdPainters, ColoursAreThoseOfTheRecipe) {
  const auto mean = [](const std::string& text) {
    return cv::mean(Paint(Recipe(text), {0.2, 0.3}, 1, 64, 96));
  };
  const cv::Scalar red = mean("label,size_m=0.2x0.3,hue_deg=0,accent_deg=0,print=1");
  const cv::Scalar blue = mean("label,size_m=0.2x0.3,hue_deg=240,accent_deg=240,print=1");
  EXPECT_GT(red[2], 1.4 * red[0]);
  EXPECT_GT(blue[0], 1.4 * blue[2]);
}

TEST(HouseholdPainters, WordsAreCheckedAndPrinted) {
  EXPECT_EQ(Recipe("package,size_m=1x1,word=CAFE 12").words.at("word"), "CAFE 12");
  for (const std::string bad : {"", "sugar", "ABCDEFGHIJKLM", "A_B"}) {
    try {
      Recipe("package,size_m=1x1,word=" + bad);
      FAIL() << "accepted '" << bad << "'";
    } catch (const hardware::ConfigError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("texture:thing.word"));
    }
  }
  EXPECT_GT(cv::norm(Paint(Recipe("package,size_m=1x1,print=1,word=SUGAR"), {1, 1}, 1, 64, 64),
                     Paint(Recipe("package,size_m=1x1,print=1,word=SALT"), {1, 1}, 1, 64, 64),
                     cv::NORM_INF),
            60);
}

}  // namespace
}  // namespace horopter::sim
