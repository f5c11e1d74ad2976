// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/tabletop_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace horopter::sim {
namespace {

TEST(TabletopConfig, DefaultsHold) {
  TabletopConfig config;
  EXPECT_TRUE(config.Validate().empty());
  config.occlusion = OcclusionConfig{};
  EXPECT_TRUE(config.Validate().empty());
}

TEST(TabletopConfig, ReportsEveryBadFieldAtOnce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TabletopConfig config;
  config.arrangement.yaw_spread_rad = -1;
  config.arrangement.gap_m = 0;
  config.arrangement.width_m = nan;
  config.arrangement.max_hidden = 1.5;
  config.clutter.count = -1;
  config.occlusion = OcclusionConfig{"rice", "rice", 1.0};
  config.light.elevation_rad = 0;
  config.light.brightness_spread = 3;
  config.light.colour_temperature_k = 100;
  config.viewpoint_W = Eigen::Vector3d(0, nan, 0);
  std::vector<std::string> fields;
  for (const auto& error : config.Validate()) fields.push_back(error.field);
  EXPECT_THAT(fields,
              testing::UnorderedElementsAre(
                  "tabletop.arrangement.yaw_spread_rad", "tabletop.arrangement.gap_m",
                  "tabletop.arrangement.width_m", "tabletop.arrangement.max_hidden",
                  "tabletop.clutter.count", "tabletop.occlusion.fraction", "tabletop.occlusion.by",
                  "tabletop.light.elevation_rad", "tabletop.light.brightness_spread",
                  "tabletop.light.colour_temperature_k", "tabletop.viewpoint_W"));
}

}  // namespace
}  // namespace horopter::sim
