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

TEST(LensMap, PixelsPerPixelIsTheAreaOfTheUndistortedImage) {
  EXPECT_NEAR(LensMap(Camera({})).PixelsPerPixel(), 1, 1e-4);
  EXPECT_NEAR(LensMap(Camera({}, 250)).PixelsPerPixel(), 300.0 / 250, 1e-4) << "of 300 x 300";
  // By Green's theorem: around the border alone.
  const LensMap map(Camera({.k1 = -0.3, .k2 = 0.1}));
  double twice = 0;
  const auto along = [&](int y0, int x0, int y1, int x1) {
    const Eigen::Vector3f a = map.Ray(y0, x0), b = map.Ray(y1, x1);
    twice += a.x() * b.y() - a.y() * b.x();
  };
  for (int x = 0; x < 319; ++x) along(0, x, 0, x + 1), along(239, x + 1, 239, x);
  for (int y = 0; y < 239; ++y) along(y, 319, y + 1, 319), along(y + 1, 0, y, 0);
  const double area = 300 * 300 * twice / 2 / (319 * 239);
  EXPECT_GT(area, 1.1);
  EXPECT_NEAR(map.PixelsPerPixel(), area, 1e-3);
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

TEST(CoveringPinhole, IsAsMuchCoarserAsItsScaleSays) {
  const LensMap map(Camera({.k1 = -0.2}));
  const CameraModel fine = CoveringPinhole(map.camera(), map.bounds(), {4000, 4000});
  const CameraModel coarse = CoveringPinhole(map.camera(), map.bounds(), {4000, 4000}, 0.8);
  EXPECT_DOUBLE_EQ(coarse.intrinsics().fx, 0.8 * fine.intrinsics().fx);
  EXPECT_NEAR(coarse.width(), 0.8 * fine.width(), 2);
  EXPECT_GE(coarse.Project(map.Ray(0, 0).cast<double>())->minCoeff(), 1 - 1e-3);
  EXPECT_LE(coarse.Project(map.Ray(239, 319).cast<double>())->x(), coarse.width() - 2);
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
