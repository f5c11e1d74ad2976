// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/lens_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::ConfigError;
using hardware::Distortion;
using testing::HasSubstr;

CameraModel Camera(const Distortion& distortion, double fy = 300) {
  return CameraModel({320, 240, 300, fy, 155.2, 124.9}, distortion);
}

TEST(LensMap, RaysProjectBackOntoTheirPixels) {
  for (const Distortion& distortion :
       {Distortion{}, Distortion{.k1 = -0.3, .k2 = 0.1}, Distortion{.k1 = 0.25},
        Distortion{.k1 = -0.1, .p1 = 0.01, .p2 = -0.02}}) {
    const CameraModel camera = Camera(distortion, 330);
    const LensMap map(camera);
    for (int y = 0; y < 240; y += 17) {
      for (int x = 0; x < 320; x += 13) {
        const auto pixel = camera.Project(map.Ray(y, x).cast<double>());
        ASSERT_TRUE(pixel.has_value());
        EXPECT_NEAR(pixel->x(), x, 1e-4);
        EXPECT_NEAR(pixel->y(), y, 1e-4);
      }
    }
  }
}

TEST(LensMap, RefusesALensWhoseImageFolds) {
  try {
    const LensMap map(Camera({.k1 = -1.2}));
    FAIL();
  } catch (const ConfigError& e) {
    EXPECT_THAT(e.what(), HasSubstr("camera.distortion = (-1.2, 0, 0, 0, 0)"));
    EXPECT_THAT(e.what(), HasSubstr("no ray reaches the image at pixel"));
    EXPECT_THAT(e.what(), HasSubstr("less distortion or a narrower field of view"));
  }
}

TEST(LensMap, RefusesAViewNoPinholeCanShow) {
  const CameraModel camera = CameraModel::FromHorizontalFov(64, 48, 172 * M_PI / 180);
  try {
    const LensMap map(camera);
    FAIL();
  } catch (const ConfigError& e) {
    EXPECT_THAT(e.what(), HasSubstr("wider than 85 deg"));
  }
}

TEST(CoveringPinhole, SeesEveryRayAtLeastAPixelInside) {
  for (const Distortion& distortion :
       {Distortion{.k1 = -0.3, .k2 = 0.1}, Distortion{.k1 = 0.25}, Distortion{.p1 = 0.02}}) {
    for (const int limit : {4000, 330}) {
      const LensMap map(Camera(distortion, 280));
      const CameraModel pinhole = CoveringPinhole(map.camera(), map.bounds(), {limit, limit});
      EXPECT_FALSE(pinhole.distortion().any());
      EXPECT_EQ(pinhole.intrinsics().fx, pinhole.intrinsics().fy);
      EXPECT_LE(pinhole.width(), limit);
      for (int y = 0; y < 240; y += 239) {
        for (int x = 0; x < 320; ++x) {
          const auto pixel = pinhole.Project(map.Ray(y, x).cast<double>());
          EXPECT_GE(pixel->minCoeff(), 1 - 1e-3);
          EXPECT_LE(pixel->x(), pinhole.width() - 2);
          EXPECT_LE(pixel->y(), pinhole.height() - 2);
        }
      }
    }
  }
}

TEST(CoveringPinhole, KeepsThePixelGridOfACameraWithoutDistortion) {
  const CameraModel camera = Camera({});
  TanBounds bounds = LensMap(camera).bounds();
  bounds.low -= 0.1;
  const CameraModel pinhole = CoveringPinhole(camera, bounds, {4000, 4000});
  EXPECT_EQ(pinhole.intrinsics().fx, 300);
  const double shift = pinhole.intrinsics().cx - camera.intrinsics().cx;
  EXPECT_NEAR(shift, std::round(shift), 1e-9);
  EXPECT_GE(shift, 30);
}

}  // namespace
}  // namespace horopter::sim
