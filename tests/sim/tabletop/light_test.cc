// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/tabletop/light_colour.h"
#include "sim/tabletop/set_light.h"
#include "tests/sim/tabletop/tabletop_scene.h"

namespace horopter::sim {
namespace {

TEST(LightColour, DaylightIsWhite) {
  EXPECT_LT((LightColour(6500) - Eigen::Vector3d::Ones()).norm(), 1e-12);
}

TEST(LightColour, EveryColourIsAsBright) {
  for (double k = kLowestColourTemperature_k; k <= kHighestColourTemperature_k; k += 100) {
    const Eigen::Vector3d linear = LightColour(k).array().pow(2.2).matrix();
    EXPECT_NEAR(linear.dot(Eigen::Vector3d(0.2126, 0.7152, 0.0722)), 1, 1e-12) << k;
  }
}

TEST(LightColour, GoesFromRedToBlueAsTheTemperatureRises) {
  double last = 0;
  for (double k = kLowestColourTemperature_k; k <= kHighestColourTemperature_k; k += 50) {
    const Eigen::Vector3d rgb = LightColour(k);
    EXPECT_GE(rgb.z() / rgb.x(), last - 2e-3) << k;  // the fits meet within this
    last = rgb.z() / rgb.x();
  }
  EXPECT_GT(LightColour(3000).x(), LightColour(3000).y());
  EXPECT_GT(LightColour(3000).y(), LightColour(3000).z());
  EXPECT_GT(LightColour(12000).z(), LightColour(12000).x());
}

TEST(SetLamp, StandsWhereItIsToldAndScalesAllLights) {
  const auto world = UnpaintedTabletop(), before = UnpaintedTabletop();
  const Eigen::Vector3d centre(1, 0, 0.72);
  SetLamp(*world, {.azimuth_rad = M_PI / 2, .elevation_rad = M_PI / 4, .brightness = 0.5}, centre);
  world->Forward();
  const int lamp = world->Id(mjOBJ_LIGHT, "lamp");
  const Eigen::Map<const Eigen::Vector3d> direction(world->data().light_xdir + 3 * lamp);
  const Eigen::Map<const Eigen::Vector3d> position(world->data().light_xpos + 3 * lamp);
  EXPECT_LT((direction - Eigen::Vector3d(0, -std::sqrt(0.5), -std::sqrt(0.5))).norm(), 1e-6);
  EXPECT_LT((position - centre).cross(direction).norm(), 1e-6);
  EXPECT_GT(position.z(), 2);
  for (int i = 0; i < 3 * world->model().nlight; ++i) {
    EXPECT_NEAR(world->model().light_diffuse[i], 0.5 * before->model().light_diffuse[i], 1e-6);
    EXPECT_NEAR(world->model().light_ambient[i], 0.5 * before->model().light_ambient[i], 1e-6);
  }
}

TEST(DrawLamp, StaysWithinItsSpreadsAndUsesThem) {
  LightConfig config;
  config.azimuth_spread_rad = 1;
  config.brightness_spread = 0.4;
  config.colour_temperature_spread_k = 2500;
  double most = 0;
  std::set<double> colours;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const LampState lamp = DrawLamp(config, seed);
    most = std::max(most, std::abs(lamp.azimuth_rad - config.azimuth_rad));
    EXPECT_LE(most, 1);
    EXPECT_EQ(lamp.elevation_rad, config.elevation_rad);
    EXPECT_GE(lamp.brightness, 0.6);
    EXPECT_LE(lamp.brightness, 1.4);
    colours.insert(lamp.colour_temperature_k);
  }
  EXPECT_GT(most, 0.9);
  EXPECT_LT(*colours.begin(), 4300);
  EXPECT_GT(*colours.rbegin(), 8700);
}

TEST(DrawLamp, TurningOneSpreadOffChangesNoOtherDraw) {
  LightConfig all;
  all.azimuth_spread_rad = all.elevation_spread_rad = 0.3;
  all.brightness_spread = 0.2;
  all.colour_temperature_spread_k = 1000;
  LightConfig still = all;
  still.azimuth_spread_rad = 0;
  const LampState a = DrawLamp(all, 9), b = DrawLamp(still, 9);
  EXPECT_NE(a.azimuth_rad, b.azimuth_rad);
  EXPECT_EQ(a.elevation_rad, b.elevation_rad);
  EXPECT_EQ(a.brightness, b.brightness);
  EXPECT_EQ(a.colour_temperature_k, b.colour_temperature_k);
}

}  // namespace
}  // namespace horopter::sim
