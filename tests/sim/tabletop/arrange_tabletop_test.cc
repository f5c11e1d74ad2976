// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/arrange_tabletop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <opencv2/core.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "hardware/types/config_error.h"
#include "sim/oracle/collision_oracle.h"
#include "sim/render/renderer.h"
#include "tests/sim/tabletop/tabletop_scene.h"

namespace horopter::sim {
namespace {

using hardware::Pose;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kDegree = M_PI / 180;

/// The geoms of a body that can touch anything.
std::vector<int> SolidGeoms(const World& world, const std::string& body) {
  std::vector<int> geoms;
  const mjModel& model = world.model();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (solid && model.geom_bodyid[geom] == world.Id(mjOBJ_BODY, body)) geoms.push_back(geom);
  }
  return geoms;
}

double Distance(const CollisionOracle& oracle, const std::vector<int>& a,
                const std::vector<int>& b) {
  double least = INFINITY;
  for (const int one : a) {
    for (const int other : b) least = std::min(least, oracle.Distance(one, other));
  }
  return least;
}

TabletopConfig Crowded() {
  TabletopConfig config;
  config.clutter.count = 5;
  return config;
}

bool SamePose(const Pose& a, const Pose& b) { return a.matrix() == b.matrix(); }

TEST(TabletopScene, HasTheObjectsOfThePaper) {
  const auto world = UnpaintedTabletop();
  EXPECT_THAT(TabletopObjects(*world), ElementsAre("sugar", "rice", "raisins", "soda_can", "cup",
                                                   "bottle", "toy_car", "tiger", "giraffe"));
  EXPECT_EQ(TabletopClutter(*world).size(), 8u);
  EXPECT_THAT(Backgrounds(*world),
              ElementsAre("bookshelf", "brick", "curtain", "plain", "posters"));
}

TEST(ArrangeTabletop, EverythingStandsUprightOnTheTableAndTouchesNothingElse) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto world = UnpaintedTabletop();
    TabletopConfig config;
    config.clutter.count = static_cast<int>(seed) % 7;
    if (seed % 2 == 0) config.occlusion = OcclusionConfig{"rice", "bottle", 0.3};
    const Tabletop tabletop = ArrangeTabletop(*world, config, seed);
    ASSERT_EQ(tabletop.X_WThing.size(), 9u + config.clutter.count);
    CollisionOracle oracle(world->model());
    oracle.Sync(world->data());
    const std::vector<int> table{world->Id(mjOBJ_GEOM, "table_top")};
    for (const auto& [name, X_WB] : tabletop.X_WThing) {
      EXPECT_LT((world->X_WBody(name).matrix() - X_WB.matrix()).norm(), 1e-9);
      EXPECT_GT(X_WB(2, 2), 1 - 1e-12) << name;
      const std::vector<int> geoms = SolidGeoms(*world, name);
      EXPECT_NEAR(Distance(oracle, geoms, table), 0, 1e-5) << name;
      EXPECT_LT(std::abs(X_WB.translation().x() - 1.0), 0.75 / 2) << name;
      EXPECT_LT(std::abs(X_WB.translation().y()), 1.1 / 2) << name;
      for (const auto& [other, X_WO] : tabletop.X_WThing) {
        if (other <= name) continue;
        EXPECT_GT(Distance(oracle, geoms, SolidGeoms(*world, other)),
                  config.arrangement.gap_m - 1e-5)
            << name << " and " << other << ", seed " << seed;
      }
    }
  }
}

TEST(ArrangeTabletop, FrontsFaceTheHeadWithinTheirSpread) {
  double most = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto world = UnpaintedTabletop();
    const Eigen::Vector3d eye = (world->X_WCamera("left_peripheral").translation() +
                                 world->X_WCamera("right_peripheral").translation()) /
                                2;
    for (const auto& [name, X_WB] : ArrangeTabletop(*world, {}, seed).X_WThing) {
      const Eigen::Vector3d p_BEye = X_WB.inverse() * eye;
      most = std::max(most, std::abs(std::atan2(p_BEye.y(), p_BEye.x())));
    }
  }
  EXPECT_LT(most, 25 * kDegree + 1e-9);
  EXPECT_GT(most, 20 * kDegree);
}

TEST(ArrangeTabletop, TheSameSeedGivesTheSameTabletopAndAnotherADifferentOne) {
  const auto a = UnpaintedTabletop(), b = UnpaintedTabletop(), c = UnpaintedTabletop();
  TabletopConfig config = Crowded();
  config.light.azimuth_spread_rad = 1;
  const Tabletop one = ArrangeTabletop(*a, config, 3), same = ArrangeTabletop(*b, config, 3),
                 other = ArrangeTabletop(*c, config, 4);
  EXPECT_EQ(one.lamp.azimuth_rad, same.lamp.azimuth_rad);
  EXPECT_NE(one.lamp.azimuth_rad, other.lamp.azimuth_rad);
  EXPECT_EQ(one.background, same.background);
  ASSERT_EQ(one.X_WThing.size(), same.X_WThing.size());
  for (const auto& [name, X_WB] : one.X_WThing) {
    EXPECT_TRUE(SamePose(X_WB, same.X_WThing.at(name))) << name;
  }
  EXPECT_FALSE(SamePose(one.X_WThing.at("sugar"), other.X_WThing.at("sugar")));
}

TEST(ArrangeTabletop, TurningOnePartOffChangesNoOther) {
  constexpr std::uint64_t kSeed = 11;
  const auto arrange = [](const TabletopConfig& config) {
    return ArrangeTabletop(*UnpaintedTabletop(), config, kSeed);
  };
  TabletopConfig all = Crowded();
  all.light.brightness_spread = 0.3;
  const Tabletop base = arrange(all);

  TabletopConfig config = all;
  config.clutter.count = 0;
  const Tabletop bare = arrange(config);
  EXPECT_EQ(bare.X_WThing.size(), 9u);
  for (const auto& [name, X_WB] : bare.X_WThing) {
    EXPECT_TRUE(SamePose(X_WB, base.X_WThing.at(name))) << name;
  }
  EXPECT_EQ(bare.background, base.background);
  EXPECT_EQ(bare.lamp.brightness, base.lamp.brightness);

  config = all;
  config.light = {};
  config.background = base.background == "brick" ? "curtain" : "brick";
  const Tabletop relit = arrange(config);
  EXPECT_EQ(relit.background, config.background);
  for (const auto& [name, X_WB] : base.X_WThing) {
    EXPECT_TRUE(SamePose(X_WB, relit.X_WThing.at(name))) << name;
  }

  config = all;
  config.arrangement.shuffle = false;
  const Tabletop as_in_file = arrange(config);
  EXPECT_EQ(as_in_file.lamp.brightness, base.lamp.brightness);
  EXPECT_EQ(as_in_file.background, base.background);
  const auto world = UnpaintedTabletop();
  for (const std::string& name : TabletopObjects(*world)) {
    EXPECT_TRUE(SamePose(world->X_WBody(name), as_in_file.X_WThing.at(name))) << name;
  }
}

TEST(ArrangeTabletop, OcclusionMovesWhatHidesAndWhatIsInTheWayAlone) {
  std::size_t moved = 0, stayed = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TabletopConfig config = Crowded();
    const Tabletop open = ArrangeTabletop(*UnpaintedTabletop(), config, seed);
    config.occlusion = OcclusionConfig{};
    const Tabletop hidden = ArrangeTabletop(*UnpaintedTabletop(), config, seed);
    EXPECT_EQ(hidden.background, open.background);
    for (const auto& [name, X_WB] : open.X_WThing) {
      ++(SamePose(X_WB, hidden.X_WThing.at(name)) ? stayed : moved);
    }
    EXPECT_FALSE(SamePose(open.X_WThing.at("bottle"), hidden.X_WThing.at("bottle")));
  }
  EXPECT_GT(stayed, 2 * moved);
}

/// Pixels of a thing in the ids that a camera at the viewpoint renders.
int PixelsOf(const World& world, const RenderedView& view, const std::string& body) {
  int pixels = 0;
  for (const int geom : view.ids) {
    pixels += geom >= 0 && world.model().geom_bodyid[geom] == world.Id(mjOBJ_BODY, body);
  }
  return pixels;
}

TEST(ArrangeTabletop, HidesTheFractionThatWasAskedForAsTheRendererSeesIt) {
  const Eigen::Vector3d eye(0.07, 0.16, 1.2);
  const std::pair<const char*, double> cases[] = {{"bottle", 0.2}, {"bottle", 0.45}, {"rice", 0.7}};
  for (const auto& [by, fraction] : cases) {
    const auto world = UnpaintedTabletop();
    TabletopConfig config = Crowded();
    config.viewpoint_W = eye;
    config.occlusion = OcclusionConfig{"sugar", by, fraction};
    const Tabletop tabletop = ArrangeTabletop(*world, config, 7);
    EXPECT_NEAR(tabletop.target_hidden.value(), fraction, 0.02);

    Renderer renderer(*world, {.width = 400, .height = 400});
    Pose X_WC = Pose::Identity();
    X_WC.translation() = eye;
    const Eigen::Vector3d ahead =
        (world->X_WBody("sugar") * Eigen::Vector3d(0, 0, 0.08) - eye).normalized();
    X_WC.linear().col(2) = ahead;
    X_WC.linear().col(0) = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
    X_WC.linear().col(1) = ahead.cross(X_WC.linear().col(0));
    const auto camera = hardware::CameraModel::FromHorizontalFov(400, 400, 20 * kDegree);
    const Products ids{.rgb = false, .depth = false, .ids = true};
    const int partly = PixelsOf(*world, renderer.Render(X_WC, camera, ids), "sugar");
    for (const auto& [name, X_WB] : tabletop.X_WThing) {
      if (name != "sugar") world->PlaceBody(name, hardware::ToPose({0, 0, 0}, -5));
    }
    const int whole = PixelsOf(*world, renderer.Render(X_WC, camera, ids), "sugar");
    EXPECT_NEAR(1 - static_cast<double>(partly) / whole, fraction, 0.025);
  }
}

TEST(ArrangeTabletop, OneBackgroundStandsOnTheFloorAndAllAreDrawn) {
  std::set<std::string> drawn;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    const auto world = UnpaintedTabletop();
    TabletopConfig config;
    config.arrangement.shuffle = false;
    const std::string chosen = ArrangeTabletop(*world, config, seed).background;
    drawn.insert(chosen);
    for (const std::string& name : Backgrounds(*world)) {
      const double z = world->X_WBody("background_" + name).translation().z();
      EXPECT_EQ(z >= 0, name == chosen) << name;
    }
  }
  EXPECT_GE(drawn.size(), 4u);
}

/// The shipped scene with free joints instead of mocap bodies, so that physics may topple things.
std::unique_ptr<World> LooseTabletop() {
  const auto read = [](const char* file) {
    std::ifstream stream(YorickScenes() / file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  };
  std::string text = read("tabletop.xml");
  for (const char* file : {"table_shell.xml", "yorick.xml", "objects.xml", "clutter.xml"}) {
    std::string part = read(file);
    if (std::string(file) == "objects.xml") {
      part = std::regex_replace(part, std::regex("<body name=\"(\\w+)\" mocap=\"true\"([^>]*)>"),
                                "<body name=\"$1\"$2><freejoint name=\"$1\"/>");
    }
    const std::string root = "<mujoco model=\"";
    const auto start = part.find('>', part.find(root)) + 1;
    const std::string inner = part.substr(start, part.rfind("</mujoco>") - start);
    const std::string include = std::string("<include file=\"") + file + "\"/>";
    text.replace(text.find(include), include.size(), inner);
  }
  auto world = World::FromXml(text);
  world->mutable_model().ntext = 0;
  return world;
}

TEST(ArrangeTabletop, ObjectsStayAtRestWhenPhysicsMayMoveThem) {
  const auto placed = UnpaintedTabletop();
  const Tabletop tabletop = ArrangeTabletop(*placed, {}, 2);
  const auto loose = LooseTabletop();
  for (const auto& [name, X_WB] : tabletop.X_WThing) {
    const int joint = loose->Id(mjOBJ_JOINT, name);
    mjtNum* q = loose->mutable_data().qpos + loose->model().jnt_qposadr[joint];
    const Eigen::Quaterniond turn(X_WB.linear());
    for (int i = 0; i < 3; ++i) q[i] = X_WB.translation()[i];
    q[3] = turn.w(), q[4] = turn.x(), q[5] = turn.y(), q[6] = turn.z();
  }
  loose->Forward();
  while (loose->now() < hardware::Time(std::chrono::milliseconds(600))) loose->Step();
  for (const auto& [name, X_WB] : tabletop.X_WThing) {
    const Pose moved = X_WB.inverse() * loose->X_WBody(name);
    EXPECT_LT(moved.translation().norm(), 2e-3) << name;
    EXPECT_LT(Eigen::AngleAxisd(moved.linear()).angle(), 1 * kDegree) << name;
  }
}

TEST(ArrangeTabletop, NamesWhatTheSceneLacks) {
  const auto world = UnpaintedTabletop();
  TabletopConfig config;
  config.clutter.count = 30;
  config.background = "jungle";
  config.occlusion = OcclusionConfig{"suger", "bottle", 0.3};
  try {
    ArrangeTabletop(*world, config, 1);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 3u);
    EXPECT_THAT(error.what(), HasSubstr("tabletop.occlusion.target = suger: the scene has sugar,"));
    EXPECT_THAT(error.what(), HasSubstr("the scene has 8 such things"));
  }
}

TEST(ArrangeTabletop, SaysWhenThereIsNoRoomAndWhenNothingCanHideSoMuch) {
  TabletopConfig tiny;
  tiny.arrangement.width_m = tiny.arrangement.depth_m = 0.25;
  EXPECT_THROW(ArrangeTabletop(*UnpaintedTabletop(), tiny, 1), SceneError);
  TabletopConfig impossible;
  impossible.occlusion = OcclusionConfig{"giraffe", "toy_car", 0.9};
  try {
    ArrangeTabletop(*UnpaintedTabletop(), impossible, 1);
    FAIL() << "expected SceneError";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'toy_car' cannot hide 90 % of 'giraffe'"));
  }
}

}  // namespace
}  // namespace horopter::sim
