// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
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

}  // namespace
}  // namespace horopter::scenarios
