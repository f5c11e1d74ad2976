// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/backend.h"
#include "scenarios/runner/run_process.h"
#include "vision/reconstruction/equation_two.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr double kRadians = M_PI / 180;
constexpr double kBaseline_m = 0.08;
constexpr double kBoard_m = 1.0;  ///< from the eyes

/// Fixates the middle of the chessboard, with encoders and sensor that add nothing.
constexpr const char* kFixate = R"(
scene: koala/chessboard_room.xml
time_limit_s: 10
variation: {heading_deg: 0}
bodies:
  board: {position_m: [1.05, 0.0, 0.30], yaw_deg: 180}
camera: {width: 320, height: 240, profile: ideal}
head: {encoder_step_deg: 0}
vision: {rate_hz: 4, latency_s: 0.2}
steps:
  - fixate: {x_m: 1.05, y_m: 0.0, z_m: 0.30, hold_s: 0.5}
expect:
  - fixation.error_deg.p95 <= 0.5 deg
)";

Scenario Fixate(std::vector<FaultSpec> faults = {}) {
  Scenario scenario = ParseScenarioText(kFixate, "fixate.yaml", {ScenesDir()});
  scenario.faults = std::move(faults);
  return scenario;
}

fs::path Folder(const std::string& name) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / "horopter_faults" / info->name() / name;
}

RunSummary Play(const Scenario& scenario, const std::string& name) {
  RunProcess process(scenario, Folder(name), std::nullopt);
  while (process.Poll()) {
  }
  return process.Finish().summary;
}

/// What equation (2) makes of the board, in the mean over its squares, when the eyes stand as
/// `true_left`, `true_right` and it is told that they stand as the commands say.
double PredictedDepthError(const vision::PaperEye& true_left, const vision::PaperEye& true_right) {
  const double converge = std::atan2(kBaseline_m / 2, kBoard_m);
  const auto left = vision::EyeFromAngles({-converge, 0}, hardware::Eye::kLeft, kBaseline_m);
  const auto right = vision::EyeFromAngles({converge, 0}, hardware::Eye::kRight, kBaseline_m);
  const auto image = [](const vision::PaperEye& eye, const Eigen::Vector3d& F) -> Eigen::Vector2d {
    const Eigen::Vector3d d = F - eye.centre;
    return Eigen::Vector2d(eye.right.dot(d), eye.up.dot(d)) / eye.forward.dot(d);
  };
  double sum = 0;
  int points = 0;
  for (double y = -0.175; y < 0.18; y += 0.01) {
    for (double z = -0.135; z < 0.14; z += 0.01, ++points) {
      const Eigen::Vector3d F = vision::PaperToBody().transpose() * Eigen::Vector3d(kBoard_m, y, z);
      const Eigen::Vector3d estimated = vision::SolveNormalEquations(
          vision::MakeEquationTwo(left, image(true_left, F), right, image(true_right, F)));
      sum +=
          left.forward.dot(estimated - left.centre) - true_left.forward.dot(F - true_left.centre);
    }
  }
  return sum / points;
}

vision::PaperEye Eye(hardware::Eye eye, double off_pan_rad, double baseline_m = kBaseline_m) {
  const double converge = std::atan2(kBaseline_m / 2, kBoard_m);
  const double pan = eye == hardware::Eye::kLeft ? -converge : converge;
  return vision::EyeFromAngles({pan + off_pan_rad, 0}, eye, baseline_m);
}

double BoardError(const RunSummary& run) { return run.metrics.at("board.depth_error.mean"); }

TEST(Faults, AZeroThatIsOffCostsTheDepthThatEquationTwoPredicts) {
  EXPECT_LT(BoardError(Play(Fixate(), "sound")), 0.005);
  for (const double off_deg : {0.3, -0.4}) {
    const RunSummary run =
        Play(Fixate({{{}, ZeroOffFault{"left", off_deg, 0}}}), off_deg > 0 ? "left" : "right");
    const double predicted = PredictedDepthError(Eye(hardware::Eye::kLeft, off_deg * kRadians),
                                                 Eye(hardware::Eye::kRight, 0));
    EXPECT_GT(std::abs(predicted), 0.05) << "worth measuring";
    EXPECT_NEAR(BoardError(run), std::abs(predicted), 0.1 * std::abs(predicted)) << off_deg;
    EXPECT_NEAR(run.metrics.at("fixation.error_deg.p95"), std::abs(off_deg), 0.05);
  }
}

TEST(Faults, AWrongBaselineCostsTheDepthThatEquationTwoPredicts) {
  const double true_baseline_m = kBaseline_m - 0.006;
  const RunSummary run = Play(Fixate({{{}, WrongBaselineFault{-0.006}}}), "run");
  const double predicted = PredictedDepthError(Eye(hardware::Eye::kLeft, 0, true_baseline_m),
                                               Eye(hardware::Eye::kRight, 0, true_baseline_m));
  EXPECT_GT(std::abs(predicted), 0.05);
  EXPECT_NEAR(BoardError(run), std::abs(predicted), 0.1 * std::abs(predicted));
}

TEST(Faults, TwoDegreesOffFailTheShippedFixation) {
  Scenario scenario = ParseScenario(
      fs::path(HOROPTER_SOURCE_DIR) / "scenarios/koala/fixate_chessboard.yaml", {ScenesDir()});
  scenario.steps.resize(1);
  scenario.faults = {{{}, ZeroOffFault{"left", 2, 0}}};
  const RunSummary run = Play(scenario, "run");
  EXPECT_EQ(run.outcome, Outcome::kFailed);
  ASSERT_EQ(run.expectations[0].metric, "fixation.error_deg.p95");
  EXPECT_EQ(run.expectations[0].outcome, ExpectationOutcome::kFailed);
  EXPECT_NEAR(run.expectations[0].value.value(), 2, 0.1);
}

TEST(Faults, ThatNeverBeginChangeNothing) {
  const double never_s = 3000;
  const RunSummary sound = Play(Fixate(), "sound");
  const RunSummary later = Play(Fixate({{{}, BacklashFault{"left_pan", 1}, never_s},
                                        {{}, EncoderNoiseFault{"right_pan", 1}, never_s},
                                        {{}, WrongBaselineFault{0.02}, never_s},
                                        {{}, MisalignedEyeFault{"left", 1, 1}, never_s},
                                        {{}, DarkEyeFault{"left", 0}, never_s},
                                        {{}, FrozenFramesFault{"right"}, never_s},
                                        {{}, LostFramesFault{"left", 0.5}, never_s},
                                        {{}, SwappedPairFault{}, never_s}}),
                                "later");
  EXPECT_EQ(sound.image_hash, later.image_hash);
  EXPECT_EQ(sound.decision_hash, later.decision_hash);
  EXPECT_EQ(sound.metrics, later.metrics);
}

TEST(Faults, AreNamedInTheSummaryAndInTheResolvedScenario) {
  const Scenario scenario = Fixate({{{}, SwappedPairFault{}, 0.1}});
  const RunSummary run = Play(scenario, "run");
  EXPECT_THAT(run.faults, testing::ElementsAre("swapped_pair: from_s 0.1, until_s 3600"));
  std::ostringstream text;
  text << std::ifstream(Folder("run") / "summary.json").rdbuf();
  EXPECT_THAT(text.str(), testing::HasSubstr("swapped_pair: from_s 0.1"));
  const Scenario resolved = ParseScenario(Folder("run") / "scenario.yaml", {ScenesDir()});
  ASSERT_EQ(resolved.faults.size(), 1u);
  EXPECT_EQ(resolved.faults[0].from_s, 0.1);
  EXPECT_NE(run.image_hash, Play(Fixate(), "sound").image_hash);
}

/// The devices of a scenario with faults, as the stack gets them.
class Robot {
 public:
  explicit Robot(std::vector<FaultSpec> faults, double rate_hz = 0) {
    Scenario scenario = Fixate(std::move(faults));
    scenario.camera.profile.timing.rate_hz = rate_hz;
    backend_ = CreateBackend(scenario, LoadRobotDescription(RobotFile(ScenesDir(), scenario.robot)),
                             times_);
    for (hardware::Device* device : {static_cast<hardware::Device*>(&backend_->head()),
                                     static_cast<hardware::Device*>(&backend_->cameras())}) {
      EXPECT_TRUE(device->Configure().ok());
      EXPECT_TRUE(device->Activate().ok());
    }
  }

  void Wait(double seconds) {
    backend_->clock().SleepUntil(backend_->clock().Now() + hardware::FromSeconds(seconds));
  }
  /// Pans both eyes and waits for them.
  void Pan(double pan_deg) {
    hardware::HeadAngles target;
    target.left.pan_rad = target.right.pan_rad = pan_deg * kRadians;
    EXPECT_TRUE(backend_->head().Command(target).ok());
    Wait(0.6);
  }
  hardware::StereoFrame Look() { return backend_->cameras().Grab().value(); }
  hardware::HeadAngles Angles() { return backend_->head().Read().value().angles; }
  double focal_px() { return backend_->cameras().model(hardware::Eye::kLeft).intrinsics().fx; }

 private:
  hardware::StageTimes times_;
  std::unique_ptr<Backend> backend_;
};

bool SamePixels(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0; }

/// By how much the middle of `before` has moved in `after` [px].
cv::Point MovedBy(const cv::Mat& before, const cv::Mat& after) {
  const cv::Rect middle(110, 80, 100, 80);
  cv::Mat match;
  cv::matchTemplate(after, before(middle), match, cv::TM_CCOEFF_NORMED);
  cv::Point best;
  cv::minMaxLoc(match, nullptr, nullptr, nullptr, &best);
  return best - middle.tl();
}

TEST(FaultEffects, ASwappedPairGivesEachEyeTheOthersImage) {
  const hardware::StereoFrame sound = Robot({}).Look();
  const hardware::StereoFrame swapped = Robot({{{}, SwappedPairFault{}}}).Look();
  EXPECT_FALSE(SamePixels(sound.left.bgr, sound.right.bgr));
  EXPECT_TRUE(SamePixels(swapped.left.bgr, sound.right.bgr));
  EXPECT_TRUE(SamePixels(swapped.right.bgr, sound.left.bgr));
}

TEST(FaultEffects, ADarkEyeIsDarkerByItsShare) {
  const hardware::StereoFrame sound = Robot({}).Look();
  const hardware::StereoFrame dark = Robot({{{}, DarkEyeFault{"left", 0.25}}}).Look();
  EXPECT_NEAR(cv::mean(dark.left.bgr)[1], 0.25 * cv::mean(sound.left.bgr)[1], 0.6);
  EXPECT_TRUE(SamePixels(dark.right.bgr, sound.right.bgr));
}

TEST(FaultEffects, AFrozenEyeShowsItsLastImageWithTheTimeOfNow) {
  Robot robot({{{}, FrozenFramesFault{"left"}, 0.05}});
  const hardware::StereoFrame before = robot.Look();
  robot.Pan(8);
  const hardware::StereoFrame after = robot.Look();
  EXPECT_TRUE(SamePixels(after.left.bgr, before.left.bgr));
  EXPECT_FALSE(SamePixels(after.right.bgr, before.right.bgr));
  EXPECT_EQ(after.left.t_capture, after.right.t_capture);
}

TEST(FaultEffects, ALostFrameIsAsOldAsTheCamerasLast) {
  Robot robot({{{}, LostFramesFault{"left", 0.5}}}, 30);
  const auto period = hardware::FromSeconds(1 / 30.0);
  int lost = 0, stale = 0;
  for (int i = 0; i < 20; ++i) {  // 2.5 Hz, as vision would
    robot.Wait(0.4);
    const hardware::StereoFrame frame = robot.Look();
    const auto age = frame.right.t_capture - frame.left.t_capture;
    lost += age.count() > 0;
    stale += age > 8 * period;
  }
  EXPECT_GE(lost, 4);
  EXPECT_LE(lost, 16);
  EXPECT_LE(stale, 1) << "eight in a row are lost once in 256 times";
}

TEST(FaultEffects, AMisalignedEyeSeesTheSceneHigher) {
  constexpr double kPitch_deg = 3;
  Robot sound({}), pitched({{{}, MisalignedEyeFault{"left", kPitch_deg, 0}}});
  const hardware::StereoFrame before = sound.Look(), after = pitched.Look();
  const cv::Point moved = MovedBy(before.left.bgr, after.left.bgr);
  EXPECT_NEAR(moved.y, -sound.focal_px() * std::tan(kPitch_deg * kRadians), 1.5);
  EXPECT_NEAR(moved.x, 0, 1);
  EXPECT_TRUE(SamePixels(after.right.bgr, before.right.bgr));
}

TEST(FaultEffects, AStuckAxisStaysWhereItIsAndItsEncoderSaysSo) {
  Robot robot({{{}, StuckAxisFault{"left_pan"}}});
  const hardware::StereoFrame before = robot.Look();
  robot.Pan(6);
  EXPECT_NEAR(robot.Angles().left.pan_rad, 0, 0.05 * kRadians);
  EXPECT_NEAR(robot.Angles().right.pan_rad, 6 * kRadians, 0.05 * kRadians);
  EXPECT_EQ(MovedBy(before.left.bgr, robot.Look().left.bgr), cv::Point(0, 0));
  EXPECT_GT(MovedBy(before.right.bgr, robot.Look().right.bgr).x, 10);
}

TEST(FaultEffects, BacklashLeavesTheEyeBehindAnEncoderThatIsRight) {
  constexpr double kWidth_deg = 3;
  Robot sound({}), worn({{{}, BacklashFault{"left_pan", kWidth_deg}}});
  for (Robot* robot : {&sound, &worn}) robot->Pan(6);
  for (Robot* robot : {&sound, &worn}) robot->Pan(0);
  EXPECT_NEAR(worn.Angles().left.pan_rad, sound.Angles().left.pan_rad, 0.05 * kRadians);
  // It came from the left and stays half the play behind: what it sees lies further right.
  const cv::Point moved = MovedBy(sound.Look().left.bgr, worn.Look().left.bgr);
  EXPECT_NEAR(moved.x, sound.focal_px() * std::tan(kWidth_deg / 2 * kRadians), 1.5);
  EXPECT_NEAR(moved.y, 0, 1);
}

}  // namespace
}  // namespace horopter::scenarios
