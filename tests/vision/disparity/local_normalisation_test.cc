// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/local_normalisation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

cv::Mat1f Noise(cv::Size size) {
  cv::RNG rng(3);
  cv::Mat1f image(size);
  rng.fill(image, cv::RNG::UNIFORM, 0, 255);
  return image;
}

TEST(LocalNormalisation, IsTheDistanceFromTheMeanInDeviations) {
  const cv::Mat1f image = Noise({23, 17});
  const cv::Mat1f normalised = NormaliseLocally(image, 5, 2.0);
  for (const cv::Point p : {cv::Point(11, 8), cv::Point(0, 0), cv::Point(22, 3)}) {
    double sum = 0, squares = 0;
    for (int v = -2; v <= 2; ++v) {
      for (int u = -2; u <= 2; ++u) {
        const double grey =
            image(std::clamp(p.y + v, 0, image.rows - 1), std::clamp(p.x + u, 0, image.cols - 1));
        sum += grey / 25;
        squares += grey * grey / 25;
      }
    }
    const double expected = (image(p) - sum) / std::sqrt(squares - sum * sum + 4);
    EXPECT_NEAR(normalised(p), expected, 1e-5) << p;
  }
}

TEST(LocalNormalisation, TakesOutLightAndContrast) {
  const cv::Mat1f image = Noise({40, 30});
  const cv::Mat1f other = 0.5F * image + 70.0F;
  const cv::Mat1f a = NormaliseLocally(image, 5, 0.01), b = NormaliseLocally(other, 5, 0.01);
  EXPECT_LT(cv::norm(a, b, cv::NORM_INF), 1e-4);
}

TEST(LocalNormalisation, PlainGroundIsZeroAndAFaintStepIsKeptFaint) {
  cv::Mat1f plain(20, 20, 201.3F);
  EXPECT_LT(cv::norm(NormaliseLocally(plain, 5, 0.3), cv::NORM_INF), 1e-6);
  plain(10, 10) += 0.05F;
  EXPECT_LT(cv::norm(NormaliseLocally(plain, 5, 0.3), cv::NORM_INF), 0.2);
  EXPECT_EQ(NormaliseLocally(cv::Mat1f(1, 1, 5.0F), 5, 0.3)(0, 0), 0);
}

}  // namespace
}  // namespace horopter::vision
