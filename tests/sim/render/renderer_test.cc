// SPDX-License-Identifier: Apache-2.0
#include "sim/render/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::ConfigError;
using hardware::Pose;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr Products kEverything{.rgb = true, .depth = true, .ids = true};

// Seen from the origin along +x: red in the upper left, green in the lower right.
constexpr const char* kTwoBalls = R"(
<mujoco>
  <visual><headlight active="0"/><quality shadowsize="512"/></visual>
  <worldbody>
    <light pos="0 0 3" dir=".5 0 -1" castshadow="true"/>
    <geom name="red" type="sphere" pos="2 .5 .4" size=".2" rgba="1 0 0 1"/>
    <geom name="green" type="sphere" pos="2 -.5 -.4" size=".2" rgba="0 1 0 1"/>
    <geom name="wall" type="box" pos="3 0 0" size=".1 4 4" rgba=".2 .2 .2 1"/>
  </worldbody>
</mujoco>)";

constexpr const char* kTexturedWall = R"(
<mujoco>
  <asset>
    <texture name="paint" type="cube" builtin="flat" rgb1="0 0 0" width="16" height="16"/>
    <material name="paint" texture="paint"/>
  </asset>
  <worldbody>
    <light pos="0 0 0" dir="1 0 0" directional="true" castshadow="false" ambient="1 1 1"/>
    <geom name="wall" type="box" pos="2 0 0" size=".1 4 4" material="paint"/>
  </worldbody>
</mujoco>)";

Pose LookAlongX() {
  Pose X_WC = Pose::Identity();
  X_WC.linear() = hardware::OpticalToBody();
  return X_WC;
}

CameraModel Camera(int width, int height) {
  return CameraModel::FromHorizontalFov(width, height, 1.0);
}

bool SameBits(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() && b.isContinuous() &&
         std::equal(a.datastart, a.dataend, b.datastart);
}

bool SameBits(const RenderedView& a, const RenderedView& b) {
  return SameBits(a.bgr, b.bgr) && SameBits(a.depth, b.depth) && SameBits(a.ids, b.ids);
}

cv::Point PixelOf(const CameraModel& camera, const Eigen::Vector3d& p_C) {
  const Eigen::Vector2d pixel = *camera.Project(p_C);
  return {static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))};
}

void PaintAll(World& world, mjtByte blue, mjtByte green, mjtByte red) {
  mjModel& m = world.mutable_model();
  for (int i = 0; i < m.tex_height[0] * m.tex_width[0]; ++i) {
    m.tex_rgb[3 * i] = red;
    m.tex_rgb[3 * i + 1] = green;
    m.tex_rgb[3 * i + 2] = blue;
  }
}

TEST(Renderer, ColoursAreBgrWithTheTopRowFirst) {
  const auto world = World::FromXml(kTwoBalls);
  Renderer renderer(*world, {.width = 160, .height = 120});
  const CameraModel camera = Camera(160, 120);
  const auto view = renderer.Render(LookAlongX(), camera, kEverything);
  const cv::Point red = PixelOf(camera, {-0.5, -0.4, 2});
  const cv::Point green = PixelOf(camera, {0.5, 0.4, 2});
  ASSERT_LT(red.y, 60);
  ASSERT_LT(red.x, 80);
  EXPECT_GT(view.bgr(red)[2], 3 * view.bgr(red)[1] + 20);
  EXPECT_GT(view.bgr(green)[1], 3 * view.bgr(green)[2] + 20);
  EXPECT_EQ(view.ids(red), world->Id(mjOBJ_GEOM, "red"));
  EXPECT_EQ(view.ids(green), world->Id(mjOBJ_GEOM, "green"));
  EXPECT_EQ(view.ids(0, 159), world->Id(mjOBJ_GEOM, "wall"));
}

TEST(Renderer, ManyGeomsKeepTheirIds) {
  std::string xml = "<mujoco><worldbody>";
  for (int y = 0; y < 20; ++y) {
    for (int z = 0; z < 20; ++z) {
      xml += "<geom type='box' size='.02 .02 .02' pos='1 " + std::to_string((9.5 - y) * 0.05) +
             " " + std::to_string((9.5 - z) * 0.05) + "'/>";
    }
  }
  const auto world = World::FromXml(xml + "</worldbody></mujoco>");
  Renderer renderer(*world, {.width = 200, .height = 200});
  const CameraModel camera = Camera(200, 200);
  const auto view = renderer.Render(LookAlongX(), camera, {.rgb = false, .ids = true});
  for (int y = 0; y < 20; ++y) {
    for (int z = 0; z < 20; ++z) {
      const auto pixel = PixelOf(camera, {-(9.5 - y) * 0.05, -(9.5 - z) * 0.05, 0.98});
      EXPECT_EQ(view.ids(pixel), 20 * y + z);
    }
  }
}

TEST(Renderer, MakesOnlyWhatIsAskedFor) {
  const auto world = World::FromXml(kTwoBalls);
  Renderer renderer(*world, {.width = 32, .height = 24});
  const auto all = renderer.Render(LookAlongX(), Camera(32, 24), kEverything);
  const auto rgb = renderer.Render(LookAlongX(), Camera(32, 24));
  EXPECT_TRUE(SameBits(rgb.bgr, all.bgr));
  EXPECT_TRUE(rgb.depth.empty());
  EXPECT_TRUE(rgb.ids.empty());
  const auto ids = renderer.Render(LookAlongX(), Camera(32, 24), {.rgb = false, .ids = true});
  EXPECT_TRUE(SameBits(ids.ids, all.ids));
  EXPECT_TRUE(ids.bgr.empty());
  EXPECT_TRUE(ids.depth.empty());
}

TEST(Renderer, RepeatedAndFreshRendersAreBitIdentical) {
  const auto world = World::FromXml(kTwoBalls);
  Renderer renderer(*world, {.width = 160, .height = 120});
  const auto first = renderer.Render(LookAlongX(), Camera(160, 120), kEverything);
  EXPECT_TRUE(SameBits(renderer.Render(LookAlongX(), Camera(160, 120), kEverything), first));
  Renderer fresh(*world, {.width = 160, .height = 120});
  EXPECT_TRUE(SameBits(fresh.Render(LookAlongX(), Camera(160, 120), kEverything), first));
  Renderer larger(*world, {.width = 400, .height = 333});
  EXPECT_TRUE(SameBits(larger.Render(LookAlongX(), Camera(160, 120), kEverything), first));
}

TEST(Renderer, TwoWorldsAlternatingSeeWhatEachSeesAlone) {
  const auto alone = [](const char* xml, int width, int height) {
    const auto world = World::FromXml(xml);
    Renderer renderer(*world, {.width = width, .height = height});
    return renderer.Render(LookAlongX(), Camera(width, height), kEverything);
  };
  const RenderedView balls = alone(kTwoBalls, 160, 120);
  const RenderedView wall = alone(kTexturedWall, 97, 203);

  const auto balls_world = World::FromXml(kTwoBalls);
  const auto wall_world = World::FromXml(kTexturedWall);
  Renderer balls_renderer(*balls_world, {.width = 160, .height = 120});
  Renderer wall_renderer(*wall_world, {.width = 97, .height = 203});
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(
        SameBits(balls_renderer.Render(LookAlongX(), Camera(160, 120), kEverything), balls));
    EXPECT_TRUE(SameBits(wall_renderer.Render(LookAlongX(), Camera(97, 203), kEverything), wall));
    alone(kTwoBalls, 8, 8);  // one that comes and goes disturbs neither
  }
}

TEST(Renderer, SeesOnlyVisibleGeoms) {
  const auto world = World::FromXml(R"(
      <mujoco>
        <worldbody>
          <geom type="box" pos="2 0 0" size=".1 4 4"/>
          <geom type="sphere" pos="1 .2 0" size=".1" group="3"/>
          <site type="sphere" pos="1 -.2 0" size=".1" rgba="1 0 0 1"/>
          <camera pos="1 0 .2"/>
          <body pos="1 0 -.2"><joint type="hinge"/><geom size=".1" group="4"/></body>
          <body pos="1.95 0 0"><freejoint/><geom size=".06" group="5"/></body>
        </worldbody>
      </mujoco>)");
  ASSERT_GT(world->Contacts().size(), 0u);
  Renderer renderer(*world, {.width = 64, .height = 64});
  const auto view = renderer.Render(LookAlongX(), Camera(64, 64), kEverything);
  EXPECT_EQ(cv::countNonZero(view.ids != 0), 0);
  for (const cv::Vec3b& pixel : view.bgr) EXPECT_EQ(pixel[2], pixel[0]);  // nothing red
}

TEST(Renderer, UploadsTexturesAtConstructionAndWhenTold) {
  const auto world = World::FromXml(kTexturedWall);
  PaintAll(*world, 250, 0, 0);
  Renderer renderer(*world, {.width = 16, .height = 16});
  const auto centre = [&] { return renderer.Render(LookAlongX(), Camera(16, 16)).bgr(8, 8); };
  const cv::Vec3b blue = centre();
  EXPECT_GT(blue[0], 100);
  EXPECT_EQ(blue[2], 0);
  PaintAll(*world, 0, 0, 250);
  EXPECT_EQ(centre(), blue);
  renderer.UploadTextures();
  EXPECT_EQ(centre(), cv::Vec3b(blue[2], blue[1], blue[0]));
}

TEST(Renderer, FollowsTheWorld) {
  const auto world = World::FromXml(R"(<mujoco><worldbody>
      <body name="board" pos="2 0 0"><geom type="box" size=".1 1 1"/></body>
      </worldbody></mujoco>)");
  Renderer renderer(*world, {.width = 16, .height = 16});
  Pose X_WT = Pose::Identity();
  for (const double x : {2.0, 1.0, 4.0}) {
    X_WT.translation().x() = x;
    world->PlaceBody("board", X_WT);
    const auto view = renderer.Render(LookAlongX(), Camera(16, 16), {.rgb = false, .depth = true});
    EXPECT_NEAR(view.depth(8, 8), x - 0.1, 1e-4);
  }
}

TEST(Renderer, BooksItsStages) {
  const auto world = World::FromXml(kTwoBalls);
  Renderer renderer(*world, {.width = 16, .height = 16});
  hardware::StageTimes times;
  renderer.Render(LookAlongX(), Camera(16, 16), {}, &times);
  ASSERT_EQ(times.samples().count("render"), 1u);
  ASSERT_EQ(times.samples().count("read_back"), 1u);
  EXPECT_EQ(times.samples().at("render").size(), 1u);
}

TEST(Renderer, NamesItsDriver) {
  const auto world = World::FromXml(kTwoBalls);
  EXPECT_FALSE(Renderer(*world).gl_renderer().empty());
}

TEST(Renderer, RefusesImpossibleResolutions) {
  const auto world = World::FromXml(kTwoBalls);
  EXPECT_THAT([&] { Renderer(*world, {.width = 0, .height = -4}); },
              ThrowsMessage<ConfigError>(
                  AllOf(HasSubstr("renderer.width = 0"), HasSubstr("renderer.height = -4"))));
  EXPECT_THAT([&] { Renderer(*world, {.width = 1 << 20, .height = 4}); },
              ThrowsMessage<ConfigError>(
                  AllOf(HasSubstr("renderer.width = 1048576"), HasSubstr("at most"))));
}

TEST(Renderer, RefusesBadOptions) {
  const auto world = World::FromXml(kTwoBalls);
  EXPECT_THROW(Renderer(*world, {.near_m = 0}), ConfigError);
  EXPECT_THROW(Renderer(*world, {.near_m = 2, .far_m = 1}), ConfigError);
  EXPECT_THROW(Renderer(*world, {.gl_backend = "glx"}), ConfigError);
}

TEST(Renderer, RefusesCamerasItCannotRender) {
  const auto world = World::FromXml(kTwoBalls);
  Renderer renderer(*world, {.width = 64, .height = 48});
  EXPECT_THAT([&] { renderer.Render(LookAlongX(), Camera(65, 48)); },
              ThrowsMessage<ConfigError>(HasSubstr("camera.width = 65")));
  EXPECT_THAT(
      [&] {
        renderer.Render(LookAlongX(), CameraModel({64, 48, 50, 50.1, 31.5, 23.5}));
      },
      ThrowsMessage<ConfigError>(HasSubstr("camera.fy")));
  EXPECT_THAT(
      [&] {
        renderer.Render(LookAlongX(), CameraModel({64, 48, 50, 50, 31.5, 23.5}, {.k1 = 0.1}));
      },
      ThrowsMessage<ConfigError>(HasSubstr("camera.distortion")));
  Pose lost = LookAlongX();
  lost.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { renderer.Render(lost, Camera(64, 48)); },
              ThrowsMessage<ConfigError>(HasSubstr("X_WC")));
}

}  // namespace
}  // namespace horopter::sim
