// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/nao_simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/sim/backend/nao_yard.h"

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::Pose;

void Activate(hardware::Device& device) {
  ASSERT_TRUE(device.Configure().ok());
  ASSERT_TRUE(device.Activate().ok());
}

void Pass(NaoSimulation& nao, double seconds) {
  nao.clock().SleepUntil(nao.clock().Now() + hardware::FromSeconds(seconds));
}

void WalkTo(NaoSimulation& nao, const hardware::Pose2& target) {
  ASSERT_TRUE(nao.humanoid().MoveTo(target).ok());
  for (int i = 0; i < 400 && nao.humanoid().Read()->walking; ++i) Pass(nao, 0.1);
  ASSERT_FALSE(nao.humanoid().Read()->walking);
}

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(NaoSimulation, StartsAtRestAtTimeZeroInItsOwnFrame) {
  hardware::StageTimes times;
  NaoSimulation nao(NaoInYard(), times);
  EXPECT_EQ(nao.clock().Now(), hardware::Time{});
  EXPECT_LT(nao.X_WO().translation().norm(), 2e-3);
  const Pose before = nao.world().X_WCamera("left_eye");
  Pass(nao, 1);
  EXPECT_LT((nao.world().X_WCamera("left_eye").translation() - before.translation()).norm(), 1e-3);
}

TEST(NaoSimulation, PlacesBodiesInTheStartingFrameAndSeesThemWhereTheyAre) {
  NaoSimulationConfig config = NaoInYard();
  config.variation.heading_rad = 0.08;
  Pose X_OBoard = Pose::Identity();
  X_OBoard.translation() << 1.5, 0, 0.5;
  config.X_OBody["board"] = X_OBoard;
  hardware::StageTimes times;
  NaoSimulation nao(config, times);
  EXPECT_NE(hardware::ToPose2(nao.X_WO()).heading_rad, 0);
  EXPECT_TRUE(nao.world().X_WBody("board").isApprox(nao.X_WO() * X_OBoard, 1e-9));
  for (const Eye eye : hardware::kBothEyes) {
    const RenderedView view = nao.RenderTruth(eye);
    EXPECT_EQ(view.ids(24, 32), nao.world().Id(mjOBJ_GEOM, "board"));
    EXPECT_NEAR(view.depth(24, 32), 1.5 - 0.01 - 0.08, 0.01);
  }
}

TEST(NaoSimulation, BothEyesShowOneInstantSixtyMillimetresApart) {
  hardware::StageTimes times;
  NaoSimulation nao(NaoInYard(), times);
  const Pose X_ClCr =
      nao.world().X_WCamera("left_eye").inverse() * nao.world().X_WCamera("right_eye");
  EXPECT_LT((X_ClCr.translation() - Eigen::Vector3d(0.06, 0, 0)).norm(), 1e-9);
  EXPECT_TRUE(X_ClCr.linear().isIdentity(1e-9));
  Activate(nao.cameras());
  const auto frame = nao.cameras().Grab();
  ASSERT_TRUE(frame.ok());
  EXPECT_EQ(frame->left.t_capture, frame->right.t_capture);
  EXPECT_FALSE(SamePixels(frame->left.bgr, frame->right.bgr));
}

TEST(NaoSimulation, WalksToATargetInItsWorld) {
  hardware::StageTimes times;
  NaoSimulation nao(NaoInYard(), times);
  Activate(nao.humanoid());
  WalkTo(nao, {0.3, 0.1, 0.6});
  Pass(nao, 0.5);
  const hardware::Pose2 moved =
      hardware::ToPose2(nao.X_WO().inverse() * nao.world().X_WBody("base"));
  EXPECT_NEAR(moved.x_m, 0.3, 0.006);
  EXPECT_NEAR(moved.y_m, 0.1, 0.006);
  EXPECT_NEAR(moved.heading_rad, 0.6, 0.02);
}

TEST(NaoSimulation, HeadTurnsWhileItWalksAndTheImageSways) {
  hardware::StageTimes times;
  NaoSimulation nao(NaoInYard(), times);
  Activate(nao.humanoid());
  Activate(nao.head());
  ASSERT_TRUE(nao.humanoid().Move({0.05, 0, 0}).ok());
  ASSERT_TRUE(nao.head().Command({{0.4, -0.1}, {}, {}}).ok());
  double leftmost = 0, rightmost = 0;
  nao.OnStep([&](const World& world) {
    const double y = world.X_WBody("head").translation().y();
    leftmost = std::max(leftmost, y);
    rightmost = std::min(rightmost, y);
  });
  Pass(nao, 3);
  EXPECT_NEAR(nao.head().Read()->angles.neck.pan_rad, 0.4, 0.01);
  EXPECT_NEAR(nao.head().Read()->angles.neck.tilt_rad, -0.1, 0.01);
  EXPECT_GT(leftmost, 0.02);
  EXPECT_LT(rightmost, -0.02);
}

TEST(NaoSimulation, AFallenRobotRefusesToWalk) {
  hardware::StageTimes times;
  NaoSimulation nao(NaoInYard(), times);
  Activate(nao.humanoid());
  mjtNum* force = nao.world().mutable_data().xfrc_applied + 6 * nao.world().Id(mjOBJ_BODY, "torso");
  force[0] = -60;
  Pass(nao, 0.5);
  force[0] = 0;
  Pass(nao, 1.5);
  const auto refused = nao.humanoid().Move({0.05, 0, 0});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, hardware::ErrorCode::kUnavailable);
  EXPECT_FALSE(nao.humanoid().Read()->walking);
  EXPECT_TRUE(nao.humanoid().Stop().ok());
}

TEST(NaoSimulation, SameSeedSameBitsAnotherSeedSlipsOtherwise) {
  const auto run = [](std::uint64_t seed) {
    NaoSimulationConfig config = NaoInYard();
    config.gait = {};
    config.seed = seed;
    hardware::StageTimes times;
    NaoSimulation nao(config, times);
    Activate(nao.humanoid());
    Activate(nao.cameras());
    WalkTo(nao, {0.15, 0, 0.2});
    return std::pair{nao.plant().TruePose(), nao.cameras().Grab()->left.bgr};
  };
  const auto a = run(3), b = run(3), c = run(4);
  EXPECT_EQ(a.first.x_m, b.first.x_m);
  EXPECT_EQ(a.first.heading_rad, b.first.heading_rad);
  EXPECT_TRUE(SamePixels(a.second, b.second));
  EXPECT_NE(a.first.x_m, c.first.x_m);
}

TEST(NaoSimulation, TheNarrowConfigurationMagnifies) {
  NaoSimulationConfig config = NaoInYard();
  Pose X_OBoard = Pose::Identity();
  X_OBoard.translation() << 2, 0, 0.5;
  config.X_OBody["board"] = X_OBoard;
  const auto pixels = [&config](NaoLens lens) {
    config.camera = NaoCamera(lens, 128, 96);
    hardware::StageTimes times;
    NaoSimulation nao(config, times);
    const cv::Mat1i ids = nao.RenderTruth(Eye::kLeft).ids;
    const int board = nao.world().Id(mjOBJ_GEOM, "board");
    int columns = 0;
    for (int x = 0; x < ids.cols; ++x) columns += ids(48, x) == board;
    return columns;
  };
  const double depth_m = 2 - 0.01 - 0.08;
  EXPECT_NEAR(pixels(NaoLens::kWide), 561 * 128 / 640.0 * 0.8 / depth_m, 1.5);
  EXPECT_NEAR(pixels(NaoLens::kNarrow), 1250 * 128 / 640.0 * 0.8 / depth_m, 1.5);
}

}  // namespace
}  // namespace horopter::sim
