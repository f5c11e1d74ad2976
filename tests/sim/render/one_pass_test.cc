// SPDX-License-Identifier: Apache-2.0
// Our drawing against MuJoCo's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "bench_scene.h"
#include "fixed_views.h"
#include "peer.h"

namespace horopter::sim {
namespace {

constexpr Products kEverything{.rgb = true, .depth = true, .ids = true};

/// Channels by how far they lie apart.
struct Difference {
  int channels = 0;
  int any = 0;       // differ at all
  int over_two = 0;  // by more than two grey levels
  int worst = 0;
};

Difference Compare(const cv::Mat3b& a, const cv::Mat3b& b) {
  Difference d;
  d.channels = static_cast<int>(a.total()) * 3;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int apart = std::abs(a(y, x)[c] - b(y, x)[c]);
        d.any += apart > 0;
        d.over_two += apart > 2;
        d.worst = std::max(d.worst, apart);
      }
    }
  }
  return d;
}

bool SameBits(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && testing::Hash(a, 1) == testing::Hash(b, 1);
}

/// Of all channels: rounding falls the other way here and there, and so does a shadow's edge.
constexpr double kRounding = 0.0002;
/// A plane seen from behind has opacity 0.3, which is 76.5 / 255: its rounding is anybody's guess.
constexpr int kThroughFadingPlane = 4;

void ExpectSameColours(const cv::Mat3b& ours, const cv::Mat3b& mujoco, int view) {
  const Difference d = Compare(ours, mujoco);
  const double allowed = view == kThroughFadingPlane ? 0.3 : kRounding;
  EXPECT_LE(d.any, d.channels * allowed) << "worst by " << d.worst;
  EXPECT_LE(d.over_two, d.channels * kRounding) << d.any << " differ, worst by " << d.worst;
}

/// Depth of a 24-bit buffer, through floats on both sides: a few of its steps apart.
void ExpectSameDepth(const cv::Mat1f& ours, const cv::Mat1f& peer, double near_m) {
  constexpr double kSteps = 4.0 / (1 << 24);
  double worst = 0;
  for (int y = 0; y < ours.rows; ++y) {
    for (int x = 0; x < ours.cols; ++x) {
      ASSERT_EQ(std::isinf(ours(y, x)), std::isinf(peer(y, x))) << x << ", " << y;
      if (std::isinf(ours(y, x))) continue;
      worst = std::max(worst, std::abs(1.0 / ours(y, x) - 1.0 / peer(y, x)) * near_m);
    }
  }
  EXPECT_LE(worst, kSteps);
}

void ExpectAgreesWithPeer(World& world, const RendererOptions& options) {
  Renderer ours(world, options);
  testing::Peer peer(world, options);
  int i = 0;
  for (const PosedCamera& view : testing::FixedViews()) {
    SCOPED_TRACE(::testing::Message() << "view " << i);
    const auto a = ours.Render(view.X_WC, view.camera, kEverything);
    const auto b = peer.Render(view, {.rgb = false, .depth = true, .ids = true});
    const auto coloured = peer.Render(view, {});
    ExpectSameColours(a.bgr, coloured.bgr, i);
    ExpectSameDepth(a.depth, b.depth, options.near_m);
    EXPECT_EQ(cv::countNonZero(a.ids != b.ids), 0);
    if (::testing::Test::HasFailure()) {
      const auto folder = std::filesystem::path(::testing::TempDir());
      cv::imwrite(folder / ("ours_" + std::to_string(i) + ".png"), a.bgr);
      cv::imwrite(folder / ("mujoco_" + std::to_string(i) + ".png"), coloured.bgr);
    }
    ++i;
  }
}

TEST(OnePass, DrawsWhatMujocoDraws) {
  const auto world = World::FromXml(testing::kShowroomXml);
  ExpectAgreesWithPeer(*world, {.width = 320, .height = 240});
}

TEST(OnePass, DrawsWhatMujocoDrawsWithoutShadows) {
  const auto world = World::FromXml(testing::kShowroomXml);
  ExpectAgreesWithPeer(*world, {.width = 320, .height = 240, .shadows = false});
}

class ShippedScene : public ::testing::TestWithParam<testing::BenchSceneName> {};

// Of a view's 921600 channels 3 to 322 differ, 0 to 6 by more than two grey levels: a rounding
// falls the other way, or the edge of a shadow takes the next pixel. The bounds are 1.4 and 3 times
// that.
TEST_P(ShippedScene, IsDrawnAsMujocoDrawsIt) {
  constexpr double kAny = 5e-4, kOverTwo = 2e-5;
  testing::BenchScene scene(GetParam());
  Renderer ours(scene.world(), {});
  testing::Peer peer(scene.world(), {});
  for (int frame = 0; frame < 3; ++frame, scene.Next()) {
    for (const PosedCamera& view : scene.Pair()) {
      SCOPED_TRACE(::testing::Message() << "frame " << frame);
      const auto a = ours.Render(view.X_WC, view.camera, kEverything);
      const auto b = peer.Render(view, {.rgb = false, .depth = true, .ids = true});
      const Difference d = Compare(a.bgr, peer.Render(view, {}).bgr);
      EXPECT_LE(d.any, d.channels * kAny) << "worst by " << d.worst;
      EXPECT_LE(d.over_two, d.channels * kOverTwo) << "worst by " << d.worst;
      EXPECT_EQ(cv::countNonZero(a.ids != b.ids), 0);
      ExpectSameDepth(a.depth, b.depth, RendererOptions().near_m);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OnePass, ShippedScene, ::testing::ValuesIn(testing::BenchScenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(OnePass, LeavesReflectionsToMujoco) {
  const auto world = World::FromXml(R"(
      <mujoco>
        <asset><material name="mirror" reflectance=".5" rgba=".5 .5 .6 1"/></asset>
        <worldbody>
          <light pos="1 0 3" dir="0 0 -1"/>
          <geom type="plane" size="3 3 .1" material="mirror"/>
          <geom type="box" size=".2 .2 .2" pos="2 0 .5" rgba="1 0 0 1"/>
        </worldbody>
      </mujoco>)");
  Renderer ours(*world, {.width = 320, .height = 240});
  Renderer mujoco(*world, {.width = 320, .height = 240, .shading = Shading::kMujoco});
  const PosedCamera view = testing::FixedViews().front();
  const auto a = ours.Render(view.X_WC, view.camera, kEverything);
  EXPECT_TRUE(SameBits(a.bgr, mujoco.Render(view.X_WC, view.camera).bgr));
  EXPECT_GT(cv::countNonZero(a.ids == 1), 0);
  EXPECT_GT(cv::countNonZero(a.ids == 0), 0);
}

TEST(OnePass, NumbersMoreGeomsThanAByteHolds) {
  std::string xml = "<mujoco><worldbody>";
  for (int i = 0; i < 700; ++i) {
    xml += "<geom type='box' size='.02 .01 .01' pos='1 " + std::to_string((17 - i % 35) * 0.03) +
           " " + std::to_string((10 - i / 35) * 0.03 + 0.5) + "'/>";
  }
  const auto world = World::FromXml(xml + "</worldbody></mujoco>");
  Renderer ours(*world, {.width = 320, .height = 240});
  testing::Peer peer(*world, {.width = 320, .height = 240});
  const PosedCamera view = testing::FixedViews().front();
  const auto a = ours.Render(view.X_WC, view.camera, kEverything);
  const auto b = peer.Render(view, {.rgb = false, .depth = false, .ids = true});
  EXPECT_EQ(cv::countNonZero(a.ids != b.ids), 0);
  EXPECT_GT(cv::countNonZero(a.ids > 255), 100);
}

/// The camera that takes four samples where `camera` takes one.
PosedCamera Finer(const PosedCamera& view) {
  const hardware::Intrinsics& in = view.camera.intrinsics();
  return {view.X_WC, hardware::CameraModel({2 * in.width, 2 * in.height, 2 * in.fx, 2 * in.fy,
                                            2 * in.cx + 0.5, 2 * in.cy + 0.5})};
}

TEST(Supersampling, IsTheMeanOfFourSamplesAndLeavesDepthAndIdsAlone) {
  const auto world = World::FromXml(testing::kShowroomXml);
  Renderer fine(*world, {.width = 320, .height = 240, .supersample = true});
  Renderer usual(*world, {.width = 320, .height = 240});
  Renderer large(*world, {.width = 640, .height = 480});
  const PosedCamera view = testing::FixedViews().front();
  const auto a = fine.Render(view.X_WC, view.camera, kEverything);
  const auto b = usual.Render(view.X_WC, view.camera, kEverything);
  const PosedCamera finer = Finer(view);
  const cv::Mat3b samples = large.Render(finer.X_WC, finer.camera).bgr;
  EXPECT_TRUE(SameBits(a.depth, b.depth));
  EXPECT_TRUE(SameBits(a.ids, b.ids));
  int off = 0;
  for (int y = 0; y < a.bgr.rows; ++y) {
    for (int x = 0; x < a.bgr.cols; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int sum = samples(2 * y, 2 * x)[c] + samples(2 * y, 2 * x + 1)[c] +
                        samples(2 * y + 1, 2 * x)[c] + samples(2 * y + 1, 2 * x + 1)[c];
        off += std::abs(4 * a.bgr(y, x)[c] - sum) > 2;
      }
    }
  }
  // The frustum's sides are rounded to float from another focal length.
  EXPECT_LE(off, a.bgr.total() * 3 / 1000);
}

}  // namespace
}  // namespace horopter::sim
