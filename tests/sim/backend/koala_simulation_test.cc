// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/koala_simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "sim/render/renderer.h"
#include "tests/sim/backend/yard.h"

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::FromSeconds;
using hardware::HeadAngles;
using hardware::StereoFrame;
using hardware::Time;
using testing::HasSubstr;

const auto kRoom = std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes" / "koala" / "room.xml";
const HeadAngles kLookAround{{}, {0.5, 0.3}, {-0.4, 0.1}};

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() && b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

bool SamePixels(const StereoFrame& a, const StereoFrame& b) {
  return SamePixels(a.left.bgr, b.left.bgr) && SamePixels(a.right.bgr, b.right.bgr);
}

KoalaSimulationConfig Unvaried() {
  KoalaSimulationConfig config = KoalaInYard();
  config.variation = {0, 0, false};
  return config;
}

/// A simulation whose devices are all active.
class Koala {
 public:
  explicit Koala(const KoalaSimulationConfig& config) : sim(config, times) {
    for (hardware::Device* device :
         std::vector<hardware::Device*>{&sim.head(), &sim.cameras(), &sim.base()}) {
      EXPECT_TRUE(device->Configure().ok());
      EXPECT_TRUE(device->Activate().ok());
    }
  }

  void Pass(double seconds) { sim.clock().SleepUntil(sim.clock().Now() + FromSeconds(seconds)); }
  StereoFrame Grab() { return sim.cameras().Grab().value(); }
  void Look(const HeadAngles& target) { EXPECT_TRUE(sim.head().Command(target).ok()); }
  void Drive(double left_m_s, double right_m_s) {
    EXPECT_TRUE(sim.base().Command({left_m_s, right_m_s}).ok());
  }

  hardware::StageTimes times;
  KoalaSimulation sim;
};

StereoFrame FirstFrame(KoalaSimulationConfig config, std::uint64_t seed) {
  config.seed = seed;
  return Koala(config).Grab();
}

/// The text of the error that building a simulation ends with.
template <typename Expected>
std::string ErrorOf(const KoalaSimulationConfig& config) {
  hardware::StageTimes times;
  try {
    const KoalaSimulation simulation(config, times);
  } catch (const Expected& error) {
    return error.what();
  }
  ADD_FAILURE() << "the simulation was built";
  return {};
}

TEST(KoalaSimulation, TimeIsZeroOnceTheRobotRestsOnItsWheels) {
  Koala koala(KoalaInYard());
  EXPECT_EQ(koala.sim.clock().Now(), Time{});
  EXPECT_EQ(koala.sim.head().Read().value().t, Time{});
  EXPECT_EQ(koala.sim.base().Read().value().t, Time{});
  EXPECT_EQ(koala.Grab().t_delivered, Time{});
  const hardware::Pose before = koala.sim.world().X_WBody("base");
  koala.Pass(0.5);
  const hardware::Pose moved = before.inverse() * koala.sim.world().X_WBody("base");
  EXPECT_LT(moved.translation().norm(), 1e-4);
  EXPECT_LT(Eigen::AngleAxisd(moved.linear()).angle(), 1e-4);
}

TEST(KoalaSimulation, StartingFrameIsTheBasesPlanarPoseAtTimeZero) {
  Koala koala(KoalaInYard());
  const hardware::Pose& X_WO = koala.sim.X_WO();
  EXPECT_EQ(X_WO.translation().z(), 0);
  EXPECT_TRUE(X_WO.linear().col(2).isApprox(Eigen::Vector3d::UnitZ()));
  const hardware::Pose X_OB = X_WO.inverse() * koala.sim.world().X_WBody("base");
  EXPECT_LT(X_OB.translation().head<2>().norm(), 1e-12);
  EXPECT_LT(X_OB.translation().norm(), 1e-3);
  EXPECT_NEAR(std::atan2(X_OB(1, 0), X_OB(0, 0)), 0, 1e-12);
}

TEST(KoalaSimulation, PlacesBodiesInTheStartingFrameWhateverTheHeading) {
  KoalaSimulationConfig config = KoalaInYard();
  hardware::Pose X_OBoard = hardware::ToPose({2, 0.3, 0.4});
  X_OBoard.translation().z() = 0.1;
  config.X_OBody["board"] = X_OBoard;
  for (const std::uint64_t seed : {1, 2}) {
    config.seed = seed;
    Koala koala(config);
    EXPECT_GT(std::abs(koala.sim.X_WO()(1, 0)), 0.001) << "the seed should turn the heading";
    const hardware::Pose X_OBody = koala.sim.X_WO().inverse() * koala.sim.world().X_WBody("board");
    EXPECT_TRUE(X_OBody.isApprox(X_OBoard, 1e-9)) << X_OBody.matrix();
    koala.Pass(0.1);
    EXPECT_TRUE(koala.sim.world().X_WBody("board").isApprox(koala.sim.X_WO() * X_OBoard, 1e-9));
  }
}

TEST(KoalaSimulation, TruthSeesAPlacedBoardAtItsDistance) {
  KoalaSimulationConfig config = Unvaried();
  config.X_OBody["board"] = hardware::ToPose({1.5, 0, 0});
  Koala koala(config);
  const int board = koala.sim.world().Id(mjOBJ_GEOM, "board");
  for (const Eye eye : hardware::kBothEyes) {
    const RenderedView view = koala.sim.RenderTruth(eye);
    EXPECT_TRUE(view.bgr.empty());
    EXPECT_EQ(view.ids(24, 32), board);
    // The optical centres are 0.05 m before the base's origin, the board's face 0.01 m before it.
    EXPECT_NEAR(view.depth(24, 32), 1.5 - 0.05 - 0.01, 1e-3);
  }
}

TEST(KoalaSimulation, BothImagesAreOfTheStateAtTheGrabWhileHeadAndBaseMove) {
  Koala koala(KoalaInYard());
  World& world = koala.sim.world();
  const hardware::CameraModel camera = koala.sim.cameras().model(Eye::kLeft);
  Renderer renderer(world, {"osmesa", camera.width(), camera.height()});
  koala.Look(kLookAround);
  koala.Drive(0.2, 0.3);
  StereoFrame last = koala.Grab();
  for (int i = 0; i < 5; ++i) {
    koala.Pass(0.05);
    const Time now = koala.sim.clock().Now();
    const std::vector<mjtNum> state(world.data().qpos, world.data().qpos + world.model().nq);
    const StereoFrame frame = koala.Grab();
    EXPECT_EQ(koala.sim.clock().Now(), now);
    EXPECT_EQ(state, std::vector<mjtNum>(world.data().qpos, world.data().qpos + world.model().nq));
    EXPECT_EQ(frame.left.t_capture, now);
    EXPECT_EQ(frame.right.t_capture, now);
    for (const Eye eye : hardware::kBothEyes) {
      const cv::Mat there = renderer.Render(world.X_WCamera(ToString(eye)), camera).bgr;
      EXPECT_TRUE(SamePixels(frame[eye].bgr, there)) << ToString(eye) << " " << i;
      EXPECT_FALSE(SamePixels(frame[eye].bgr, last[eye].bgr)) << ToString(eye) << " " << i;
    }
    last = frame;
  }
}

TEST(KoalaSimulation, GrabbingTwiceAtOneInstantGivesTheSameSceneWithFreshNoise) {
  KoalaSimulationConfig config = Unvaried();
  Koala ideal(config);
  const StereoFrame first = ideal.Grab(), second = ideal.Grab();
  EXPECT_TRUE(SamePixels(first, second));
  EXPECT_EQ(second.sequence, first.sequence + 1);
  config.profile.noise = CameraProfile::Named("webcam_vga").noise;
  Koala noisy(config);
  EXPECT_FALSE(SamePixels(noisy.Grab(), noisy.Grab()));
}

TEST(KoalaSimulation, TheSameSeedGivesTheSameBits) {
  KoalaSimulationConfig config = KoalaInYard();
  config.seed = config.head.seed = 7;
  config.profile.noise = CameraProfile::Named("webcam_vga").noise;
  config.head.encoder_noise_rad = 0.1 * kDegree;
  Koala a(config), b(config);
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(SamePixels(a.Grab(), b.Grab())) << i;
    EXPECT_EQ(ToArray(a.sim.head().Read().value().angles),
              ToArray(b.sim.head().Read().value().angles));
    const auto state_a = a.sim.base().Read().value(), state_b = b.sim.base().Read().value();
    EXPECT_EQ(state_a.left_pulses, state_b.left_pulses);
    EXPECT_EQ(state_a.right_pulses, state_b.right_pulses);
    EXPECT_EQ(state_a.proximity, state_b.proximity);
    for (Koala* koala : {&a, &b}) {
      koala->Look(kLookAround);
      koala->Drive(0.3, 0.1);
      koala->Pass(0.1);
    }
  }
}

TEST(KoalaSimulation, EachThingThatASeedVariesChangesTheImagesByItself) {
  const KoalaSimulationConfig plain = Unvaried();
  EXPECT_TRUE(SamePixels(FirstFrame(plain, 1), FirstFrame(plain, 2))) << "nothing varies";
  KoalaSimulationConfig obstacles = plain, heading = plain, textures = plain, noise = plain;
  textures.scene = kRoom;
  obstacles.variation.obstacle_shift_m = 0.15;
  obstacles.camera = hardware::CameraModel::FromHorizontalFov(320, 240, 60 * kDegree);
  heading.variation.heading_rad = 5 * kDegree;
  textures.variation.textures = true;
  noise.profile.noise = CameraProfile::Named("webcam_vga").noise;
  EXPECT_FALSE(SamePixels(FirstFrame(obstacles, 1), FirstFrame(obstacles, 2)));
  EXPECT_FALSE(SamePixels(FirstFrame(heading, 1), FirstFrame(heading, 2)));
  EXPECT_FALSE(SamePixels(FirstFrame(textures, 1), FirstFrame(textures, 2)));
  EXPECT_FALSE(SamePixels(FirstFrame(noise, 1), FirstFrame(noise, 2)));
}

TEST(KoalaSimulation, DrivesAlongItsStartingFrameAsItsEncodersSay) {
  Koala koala(KoalaInYard());
  for (int i = 0; i < 10; ++i) {
    koala.Drive(0.25, 0.25);
    koala.Pass(0.2);
  }
  const hardware::Pose X_OB = koala.sim.X_WO().inverse() * koala.sim.world().X_WBody("base");
  const hardware::BaseState state = koala.sim.base().Read().value();
  const double by_encoders_m = (state.left_pulses + state.right_pulses) / 2.0 *
                               koala.sim.base().properties().metres_per_pulse;
  EXPECT_GT(by_encoders_m, 0.4);
  EXPECT_NEAR(X_OB.translation().x(), by_encoders_m, 0.03 * by_encoders_m);
  EXPECT_NEAR(X_OB.translation().y(), 0, 0.01);
  EXPECT_EQ(state.proximity.size(), 16u);
}

TEST(KoalaSimulation, ObserversSeeEveryPhysicsStepOnceAndInOrder) {
  Koala koala(KoalaInYard());
  const Time start = koala.sim.world().now();
  std::vector<Time> seen;
  koala.sim.OnStep([&seen](const World& world) { seen.push_back(world.now()); });
  koala.Pass(0.011);  // 6 steps of 2 ms
  const Time there = koala.sim.world().now();
  koala.Grab();
  ASSERT_EQ(seen.size(), 6u);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i], start + static_cast<int>(i + 1) * koala.sim.world().step());
  }
  EXPECT_EQ(there, seen.back());
}

TEST(KoalaSimulation, BooksObserversAsTruthAndNotAsPhysics) {
  Koala koala(KoalaInYard());
  koala.Pass(0.02);
  EXPECT_EQ(koala.times.samples().count("truth"), 0u);
  koala.sim.OnStep([](const World&) {});
  koala.Pass(0.02);
  EXPECT_EQ(koala.times.samples().at("truth").size(), 1u);
  EXPECT_EQ(koala.times.samples().at("physics").size(), 2u);
}

TEST(KoalaSimulation, BooksTheTimeOfEachStage) {
  Koala koala(KoalaInYard());
  koala.Pass(0.01);
  koala.Grab();
  const auto& samples = koala.times.samples();
  EXPECT_EQ(samples.at("physics").size(), 1u);
  for (const char* per_eye : {"render", "read_back", "sensor"}) {
    EXPECT_EQ(samples.at(per_eye).size(), 2u) << per_eye;
  }
}

TEST(KoalaSimulation, RefusedCallsSayWhatToDoFirst) {
  hardware::StageTimes times;
  KoalaSimulation sim(KoalaInYard(), times);
  EXPECT_THAT(sim.head().Read().error().message, HasSubstr("Configure() it first"));
  ASSERT_TRUE(sim.base().Configure().ok());
  const auto refused = sim.base().Command({0.1, 0.1});
  EXPECT_THAT(refused.error().message, HasSubstr("inactive"));
  EXPECT_THAT(refused.error().message, HasSubstr("Activate() it first"));
}

TEST(KoalaSimulation, MissingSceneIsNamed) {
  KoalaSimulationConfig config = KoalaInYard();
  config.scene = "/nowhere/attic.xml";
  EXPECT_THAT(ErrorOf<SceneError>(config), HasSubstr("'/nowhere/attic.xml' does not exist"));
}

TEST(KoalaSimulation, UnknownBodyIsNamedWithTheNearestThatThereIs) {
  KoalaSimulationConfig config = KoalaInYard();
  config.X_OBody["bord"] = hardware::Pose::Identity();
  const std::string error = ErrorOf<SceneError>(config);
  EXPECT_THAT(error, HasSubstr("yard.xml"));
  EXPECT_THAT(error, HasSubstr("no body named 'bord'"));
  EXPECT_THAT(error, HasSubstr("did you mean 'board'?"));
}

TEST(KoalaSimulation, TheRobotItselfCannotBePlaced) {
  KoalaSimulationConfig config = KoalaInYard();
  config.X_OBody["base"] = hardware::Pose::Identity();
  EXPECT_THAT(ErrorOf<SceneError>(config), HasSubstr("body 'base' cannot be placed"));
}

TEST(KoalaSimulation, BadConfigurationsNameTheirField) {
  KoalaSimulationConfig config = KoalaInYard();
  config.head.limits[2].max_rad = 4;
  EXPECT_THAT(ErrorOf<hardware::ConfigError>(config), HasSubstr("left_pan"));
  config = KoalaInYard();
  config.gl_backend = "osmessa";
  EXPECT_THAT(ErrorOf<std::exception>(config), HasSubstr("osmessa"));
}

TEST(KoalaSimulation, SeesTheTexturedRoomDifferentlyWithEachEye) {
  KoalaSimulationConfig config = KoalaInYard();
  config.scene = kRoom;
  Koala koala(config);
  const StereoFrame frame = koala.Grab();
  EXPECT_FALSE(SamePixels(frame.left.bgr, frame.right.bgr));
  for (const Eye eye : hardware::kBothEyes) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(frame[eye].bgr, mean, deviation);
    EXPECT_GT(deviation[0], 10) << ToString(eye);
  }
}

}  // namespace
}  // namespace horopter::sim
