// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/yorick_simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "control/kinematics/head_kinematics.h"
#include "control/kinematics/look_at.h"
#include "tests/sim/backend/yorick.h"

namespace horopter::sim {
namespace {

using control::ForPair;
using control::LookAt;
using hardware::Eye;
using hardware::FromSeconds;
using hardware::HeadAngles;
using hardware::HeadGeometry;
using hardware::Pose;
using testing::HasSubstr;

constexpr double kDegree = M_PI / 180;
constexpr YorickPair kPairs[] = {YorickPair::kPeripheral, YorickPair::kFoveal};
const auto kTabletop = std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes/yorick/tabletop.xml";

const char* Name(YorickPair pair) { return pair == YorickPair::kFoveal ? "foveal" : "peripheral"; }

HeadGeometry GeometryOf(YorickPair pair) {
  if (pair == YorickPair::kFoveal) return YorickFovealGeometry();
  return ForPair(YorickFovealGeometry(), {.above_m = 0.034, .ahead_m = -0.015});
}

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

YorickSimulationConfig AtFullSize() {
  YorickSimulationConfig config = YorickAtTable();
  config.peripheral = YorickSimulationConfig{}.peripheral;
  config.foveal = YorickSimulationConfig{}.foveal;
  return config;
}

/// A simulation whose devices are all active.
class Yorick {
 public:
  explicit Yorick(const YorickSimulationConfig& config) : sim(config, times) {
    for (hardware::Device* device : std::vector<hardware::Device*>{
             &sim.head(), &sim.cameras(kPairs[0]), &sim.cameras(kPairs[1])}) {
      EXPECT_TRUE(device->Configure().ok());
      EXPECT_TRUE(device->Activate().ok());
    }
  }

  void Pass(double seconds) { sim.clock().SleepUntil(sim.clock().Now() + FromSeconds(seconds)); }
  void Look(const HeadAngles& target) { EXPECT_TRUE(sim.head().Command(target).ok()); }
  void LookAtRest(const HeadAngles& target) {
    Look(target);
    Pass(0.6);
  }
  hardware::StereoFrame Grab(YorickPair pair) { return sim.cameras(pair).Grab().value(); }

  hardware::StageTimes times;
  YorickSimulation sim;
};

/// Speeds of the four joints, by axis.
hardware::HeadAxisArray JointSpeeds(const World& world) {
  hardware::HeadAxisArray speeds{};
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    const int joint = mj_name2id(&world.model(), mjOBJ_JOINT, hardware::kHeadAxisNames[i].data());
    if (joint >= 0) speeds[i] = world.data().qvel[world.model().jnt_dofadr[joint]];
  }
  return speeds;
}

TEST(YorickSimulation, CamerasAreWhereTheKinematicsSayAtAnyAngles) {
  World world(YorickAtTable().scene);
  std::mt19937_64 random(3);
  const hardware::HeadLimits limits = YorickLimits();
  for (int draw = 0; draw < 200; ++draw) {
    hardware::HeadAxisArray angles{};
    for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
      if (!limits[i].exists()) continue;
      angles[i] =
          std::uniform_real_distribution<double>(limits[i].min_rad, limits[i].max_rad)(random);
      const int joint = world.Id(mjOBJ_JOINT, hardware::kHeadAxisNames[i]);
      world.mutable_data().qpos[world.model().jnt_qposadr[joint]] = angles[i];
    }
    world.Forward();
    for (const YorickPair pair : kPairs) {
      for (const Eye eye : hardware::kBothEyes) {
        const Pose expected = control::EyePose(GeometryOf(pair), hardware::FromArray(angles), eye);
        const Pose actual = world.X_WCamera(YorickSimulation::CameraName(pair, eye));
        EXPECT_LT((actual.matrix() - expected.matrix()).norm(), 1e-9) << Name(pair);
      }
    }
  }
}

TEST(YorickSimulation, FieldsOfViewAreThoseOfThePaperAndTheScene) {
  const YorickSimulationConfig config;
  EXPECT_NEAR(config.peripheral.horizontal_fov_rad(), 60 * kDegree, 1e-12);
  EXPECT_NEAR(config.foveal.horizontal_fov_rad(), 14 * kDegree, 1e-12);
  const World world(YorickAtTable().scene);
  for (const YorickPair pair : kPairs) {
    const hardware::CameraModel& model =
        pair == YorickPair::kFoveal ? config.foveal : config.peripheral;
    EXPECT_EQ(model.width(), 768);
    EXPECT_EQ(model.height(), 576);
    for (const Eye eye : hardware::kBothEyes) {
      const int camera = world.Id(mjOBJ_CAMERA, YorickSimulation::CameraName(pair, eye));
      EXPECT_NEAR(world.model().cam_fovy[camera] * kDegree, model.vertical_fov_rad(), 1e-5);
    }
  }
}

TEST(YorickSimulation, ABoardOfKnownSizeFillsTheShareOfTheFieldThatItShould) {
  Yorick yorick(AtFullSize());
  World& world = yorick.sim.world();
  constexpr double kWidth_m = 0.4, kHalfThickness_m = 0.01, kDistance_m = 2.1;
  for (const YorickPair pair : kPairs) {
    for (const Eye eye : hardware::kBothEyes) {
      const Eigen::Vector3d p_WC =
          world.X_WCamera(YorickSimulation::CameraName(pair, eye)).translation();
      world.PlaceBody("board",
                      hardware::ToPose({p_WC.x() + kDistance_m + kHalfThickness_m, p_WC.y(), 0},
                                       p_WC.z() - 0.15));
      const RenderedView view = yorick.sim.RenderTruth(pair, eye);
      const cv::Mat middle_row = view.ids.row(288) == world.Id(mjOBJ_GEOM, "board");
      const double focal_px = cv::countNonZero(middle_row) * kDistance_m / kWidth_m;
      const double fov = 2 * std::atan(768 / 2.0 / focal_px);
      const double expected = (pair == YorickPair::kFoveal ? 14 : 60) * kDegree;
      EXPECT_NEAR(fov, expected, 0.01 * expected) << Name(pair) << " " << ToString(eye);
    }
  }
}

TEST(YorickSimulation, FixationBringsAnObjectToTheMiddleOfBothImagesOfEitherPair) {
  YorickSimulationConfig config = AtFullSize();
  Yorick yorick(config);
  World& world = yorick.sim.world();
  double worst_px = 0;
  for (const Eigen::Vector3d& target :
       {Eigen::Vector3d(1.0, 0.0, 0.80), {0.8, 0.35, 0.76}, {1.3, -0.5, 0.9}, {0.9, -0.1, 1.1}}) {
    for (const YorickPair pair : kPairs) {
      const auto fixation = LookAt(GeometryOf(pair), YorickLimits(), target);
      ASSERT_TRUE(fixation.reachable()) << fixation.why;
      yorick.LookAtRest(fixation.angles);
      const auto& model = yorick.sim.camera_model(pair);
      const Eigen::Vector2d middle((model.width() - 1) / 2.0, (model.height() - 1) / 2.0);
      for (const Eye eye : hardware::kBothEyes) {
        const Pose X_WC = world.X_WCamera(YorickSimulation::CameraName(pair, eye));
        const auto pixel = model.Project(X_WC.inverse() * target);
        ASSERT_TRUE(pixel.has_value());
        worst_px = std::max(worst_px, (*pixel - middle).norm());
        EXPECT_LT((*pixel - middle).norm(), 0.05) << Name(pair) << " " << ToString(eye);
      }
    }
  }
  RecordProperty("worst_px", std::to_string(worst_px));
}

/// The same, measured in the images: the middle of a ball's outline.
TEST(YorickSimulation, ImagesShowTheFixatedBallInTheirMiddle) {
  Yorick yorick(AtFullSize());
  World& world = yorick.sim.world();
  for (const YorickPair pair : kPairs) {
    const std::string ball = pair == YorickPair::kFoveal ? "ball" : "large_ball";
    for (const Eigen::Vector3d& target :
         {Eigen::Vector3d(1.05, 0.02, 1.05), {0.95, 0.4, 0.95}, {1.2, -0.35, 1.2}}) {
      Pose X_WBall = Pose::Identity();
      X_WBall.translation() = target;
      world.PlaceBody(ball, X_WBall);
      yorick.LookAtRest(LookAt(GeometryOf(pair), YorickLimits(), target).angles);
      for (const Eye eye : hardware::kBothEyes) {
        const RenderedView view = yorick.sim.RenderTruth(pair, eye);
        const cv::Mat mask = view.ids == world.Id(mjOBJ_GEOM, ball);
        const cv::Moments m = cv::moments(mask, true);
        const Eigen::Vector2d middle(m.m10 / m.m00, m.m01 / m.m00);
        EXPECT_LT((middle - Eigen::Vector2d(383.5, 287.5)).norm(), 0.05)
            << Name(pair) << " " << ToString(eye) << ": " << middle.transpose() << ", radius "
            << std::sqrt(m.m00 / M_PI);
      }
    }
    world.PlaceBody(ball, hardware::ToPose({-3, 0, 0}));
  }
}

TEST(YorickSimulation, ASaccadeReachesTheLimitsOfEveryAxisAndKeepsThem) {
  Yorick yorick(YorickAtTable());
  const hardware::HeadLimits limits = YorickLimits();
  yorick.LookAtRest({{-80 * kDegree, -35 * kDegree}, {-44 * kDegree, 0}, {1 * kDegree, 0}});
  hardware::HeadAxisArray fastest{}, hardest{};
  hardware::HeadAxisArray last{};
  yorick.sim.OnStep([&](const World& world) {
    const hardware::HeadAxisArray speeds = JointSpeeds(world);
    const double dt = hardware::ToSeconds(world.step());
    for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
      fastest[i] = std::max(fastest[i], std::abs(speeds[i]));
      hardest[i] = std::max(hardest[i], std::abs(speeds[i] - last[i]) / dt);
    }
    last = speeds;
  });
  const HeadAngles target{{80 * kDegree, 35 * kDegree}, {-1 * kDegree, 0}, {44 * kDegree, 0}};
  yorick.Look(target);
  yorick.Pass(0.6);
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    if (!limits[i].exists()) continue;
    EXPECT_GT(fastest[i], 0.97 * limits[i].max_speed_rad_s) << hardware::kHeadAxisNames[i];
    EXPECT_LT(fastest[i], 1.03 * limits[i].max_speed_rad_s) << hardware::kHeadAxisNames[i];
    EXPECT_GT(hardest[i], 0.8 * limits[i].max_acceleration_rad_s2) << hardware::kHeadAxisNames[i];
    EXPECT_LT(hardest[i], 1.2 * limits[i].max_acceleration_rad_s2) << hardware::kHeadAxisNames[i];
  }
  const auto reached = hardware::ToArray(yorick.sim.head().Read().value().angles);
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    EXPECT_NEAR(reached[i], hardware::ToArray(target)[i], 0.006 * kDegree);
  }
}

TEST(YorickSimulation, ASaccadeTakesTheTimeThatItsLimitsNeed) {
  Yorick yorick(YorickAtTable());
  // 10 deg with the vergences: 10/540 s plus one ramp of 540/38000 s = 32.7 ms.
  yorick.LookAtRest({{}, {-5 * kDegree, 0}, {5 * kDegree, 0}});
  yorick.Look({{}, {-15 * kDegree, 0}, {15 * kDegree, 0}});
  yorick.Pass(0.028);
  EXPECT_GT(yorick.sim.head().Read().value().angles.left.pan_rad, -14.8 * kDegree);
  yorick.Pass(0.012);
  EXPECT_NEAR(yorick.sim.head().Read().value().angles.left.pan_rad, -15 * kDegree, 0.1 * kDegree);
}

TEST(YorickSimulation, BothPairsShowTheInstantOfTheGrabWhileTheHeadMoves) {
  Yorick yorick(YorickAtTable());
  yorick.LookAtRest({{0, 0.3}, {}, {}});
  yorick.Look({{0.5, 0.5}, {-0.15, 0}, {0.15, 0}});
  hardware::StereoFrame last[2] = {yorick.Grab(kPairs[0]), yorick.Grab(kPairs[1])};
  for (int i = 0; i < 3; ++i) {
    yorick.Pass(0.02);
    for (int pair = 0; pair < 2; ++pair) {
      const hardware::StereoFrame frame = yorick.Grab(kPairs[pair]);
      EXPECT_EQ(frame.left.t_capture, yorick.sim.clock().Now());
      EXPECT_EQ(frame.right.t_capture, yorick.sim.clock().Now());
      EXPECT_FALSE(SamePixels(frame.left.bgr, last[pair].left.bgr)) << Name(kPairs[pair]);
      last[pair] = frame;
    }
  }
}

TEST(YorickSimulation, EveryCameraHasNoiseOfItsOwn) {
  YorickSimulationConfig config = YorickAtTable();
  config.foveal = config.peripheral;
  config.profile.noise.read_noise_dn = 4;
  Yorick noisy(config);
  config.profile.noise.read_noise_dn = 0;
  Yorick clean(config);
  std::vector<cv::Mat> noises;
  for (const YorickPair pair : kPairs) {
    const hardware::StereoFrame seen = noisy.Grab(pair), ideal = clean.Grab(pair);
    for (const Eye eye : hardware::kBothEyes) {
      cv::Mat noise;
      cv::subtract(seen[eye].bgr, ideal[eye].bgr, noise, cv::noArray(), CV_16S);
      EXPECT_GT(cv::norm(noise, cv::NORM_INF), 4);
      for (const cv::Mat& other : noises) EXPECT_FALSE(SamePixels(noise, other));
      noises.push_back(noise);
    }
  }
}

TEST(YorickSimulation, PlacesBodiesInTheBaseFrame) {
  YorickSimulationConfig config = YorickAtTable();
  config.X_BBody["board"] = hardware::ToPose({1.2, 0.3, 0.4}, 0.9);
  Yorick yorick(config);
  const Pose X_BBoard = yorick.sim.X_WB().inverse() * yorick.sim.world().X_WBody("board");
  EXPECT_TRUE(X_BBoard.isApprox(config.X_BBody.at("board"), 1e-12));
  config.X_BBody["bord"] = Pose::Identity();
  hardware::StageTimes times;
  try {
    YorickSimulation sim(config, times);
    FAIL() << "expected SceneError";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'board'?"));
  }
}

TEST(YorickSimulation, TheSameSeedGivesTheSameTabletopToTheBit) {
  YorickSimulationConfig config = YorickAtTable();
  config.scene = kTabletop;
  config.tabletop = TabletopConfig{};
  config.tabletop->clutter.count = 2;
  config.profile.noise.read_noise_dn = 1.5;
  config.seed = 5;
  Yorick a(config), b(config);
  const HeadAngles down{{0, 0.4}, {-0.15, 0}, {0.15, 0}};
  for (Yorick* yorick : {&a, &b}) yorick->LookAtRest(down);
  for (const YorickPair pair : kPairs) {
    const hardware::StereoFrame one = a.Grab(pair), other = b.Grab(pair);
    EXPECT_TRUE(SamePixels(one.left.bgr, other.left.bgr));
    EXPECT_TRUE(SamePixels(one.right.bgr, other.right.bgr));
    EXPECT_FALSE(SamePixels(one.left.bgr, one.right.bgr));
    cv::Scalar mean, deviation;
    cv::meanStdDev(one.left.bgr, mean, deviation);
    EXPECT_GT(deviation[0], 8) << "something is to be seen";
  }
  EXPECT_EQ(a.sim.tabletop()->background, b.sim.tabletop()->background);
}

}  // namespace
}  // namespace horopter::sim
