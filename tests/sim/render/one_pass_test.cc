// SPDX-License-Identifier: Apache-2.0
// Our drawing against MuJoCo's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

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

}  // namespace
}  // namespace horopter::sim
