// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/film.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "hardware/types/config_error.h"
#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/state_tables.h"
#include "scenarios/render/manifest.h"
#include "scenarios/render/render_dataset.h"
#include "scenarios/render/request_checks.h"
#include "tests/scenarios/format/corpus.h"
#include "tests/scenarios/render/same_parts.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

MotionCommand Saccade(double at_s, double pan_deg, double tilt_deg, double vergence_deg = 0) {
  SaccadeCommand saccade;
  saccade.gaze_deg = {pan_deg, tilt_deg, vergence_deg};
  return {at_s, saccade};
}

/// A table that a film wrote, by the names of its columns.
class Table {
 public:
  explicit Table(const fs::path& file)
      : text_(Slurp(file)), header_(text_.substr(0, text_.find('\n'))) {
    csv_.emplace(text_, header_, file.string());
  }

  std::size_t rows() const { return csv_->rows(); }
  double operator()(std::size_t row, const std::string& column) const {
    const std::size_t at = ("," + header_ + ",").find("," + column + ",");
    EXPECT_NE(at, std::string::npos) << column;
    return csv_->Number(row, static_cast<std::size_t>(std::count(
                                 header_.begin(), header_.begin() + static_cast<long>(at), ',')));
  }

 private:
  std::string text_;
  std::string header_;
  std::optional<CsvTable> csv_;
};

class FilmTest : public testing::Test {
 protected:
  static RenderRequest Request(const std::string& robot, const std::string& scene,
                               const std::string& profile, double rate_hz) {
    RenderRequest request;
    request.scene = robot + "/" + scene;
    request.robot = robot;
    request.camera.width = 96;
    request.camera.height = 72;
    request.camera.profile = sim::CameraProfile::Named(profile);
    request.camera.profile.timing.rate_hz = rate_hz;
    request.poses = {"", {"pan_deg"}, {{0}}};
    request.motion.emplace();
    return request;
  }

  fs::path Make(const RenderRequest& request, const std::string& name = "set") const {
    const RenderOutput output{folder_.path() / name, "horopter render", {{"horopter", "0"}}};
    EXPECT_TRUE(RenderDataset(request, output));
    return output.folder;
  }

  TemporaryFolder folder_;
};

TEST_F(FilmTest, TheSameFilmTwiceIsTheSameToTheLastBit) {
  RenderRequest request = Request("koala", "room.xml", "webcam_vga", 30);
  request.camera.profile.timing.drop_probability = 0.2;
  request.camera.profile.timing.repeat_probability = 0.2;
  request.seed = 4;
  request.truth = true;
  request.motion->duration_s = 0.4;
  request.motion->commands = {{0, DriveCommand{0.3, 30}}, Saccade(0.1, 15, 5, 3)};
  const fs::path first = Make(request, "first");
  const DatasetManifest manifest = ReadManifest(first);
  const fs::path second = Make(manifest.request, "second");
  EXPECT_EQ(WhatDiffers(manifest, ReadManifest(second)), "");
  const Table index(first / "index.csv");
  ASSERT_GT(index.rows(), 5u);
  for (std::size_t i = 0; i < index.rows(); ++i) {
    const std::string sums = fmt::format("{:06}/SHA256SUMS", i);
    EXPECT_FALSE(Slurp(first / sums).empty());
    EXPECT_EQ(Slurp(first / sums), Slurp(second / sums)) << i;
  }
  for (const char* file : {"manifest.json", "index.csv", "capture.csv", "trajectory.csv"}) {
    EXPECT_FALSE(Slurp(first / file).empty()) << file;
    EXPECT_EQ(Slurp(first / file), Slurp(second / file)) << file;
  }
}

TEST_F(FilmTest, ASaccadeIsAsFastAsTheAxesAndNoFaster) {
  RenderRequest request = Request("yorick", "tabletop.xml", "ideal", 50);
  request.pairs = {"foveal"};
  request.motion->duration_s = 0.3;
  request.motion->commands = {Saccade(0.05, 40, 10, 8)};
  const Table path(Make(request) / "trajectory.csv");
  const hardware::HeadLimits limits = RobotOf(request).head_limits;
  ASSERT_EQ(path.rows(), 301u);  // one more than there are steps of 1 ms
  for (const int axis : {0, 1, 2, 4}) {
    const auto i = static_cast<std::size_t>(axis);
    const std::string name = std::string(hardware::kHeadAxisNames[i]) + "_deg";
    const double limit = limits[i].max_speed_rad_s * 180 / M_PI;
    double fastest = 0;
    for (std::size_t row = 1; row < path.rows(); ++row) {
      const double step_s = path(row, "t_s") - path(row - 1, "t_s");
      fastest = std::max(fastest, std::abs(path(row, name) - path(row - 1, name)) / step_s);
    }
    // The joint follows its set point through a servo, which overshoots the speed a little.
    EXPECT_LT(fastest, 1.02 * limit) << name;
    EXPECT_GT(fastest, axis == 0 ? 0.98 * limit : 50) << name;
  }
  EXPECT_NEAR(path(50, "neck_pan_deg"), 0, 0.01) << "it is told at 0.05 s";
  EXPECT_NEAR(path(300, "neck_pan_deg"), 40, 0.01);
  EXPECT_NEAR(path(300, "neck_tilt_deg"), 10, 0.01);
  EXPECT_NEAR(path(300, "right_pan_deg") - path(300, "left_pan_deg"), 8, 0.01);
}

// What a film shows of an instant is what a still view of that instant's angles shows.
TEST_F(FilmTest, AFrameIsTheSightOfItsCaptureNotOfItsDelivery) {
  RenderRequest request = Request("yorick", "tabletop.xml", "ideal", 100);
  request.camera.profile.timing.latency_s = 0.03;
  request.pairs = {"peripheral"};
  request.motion->duration_s = 0.15;
  request.motion->commands = {Saccade(0.02, 20, 15)};
  const fs::path film = Make(request, "film");
  const Table index(film / "index.csv"), capture(film / "capture.csv");
  RenderRequest still = request;
  still.motion.reset();
  still.poses = {"", {"neck_pan_deg", "neck_tilt_deg", "left_pan_deg", "right_pan_deg"}, {}};
  for (std::size_t i = 0; i < index.rows(); ++i) {
    EXPECT_EQ(index(i, "t_s"), capture(i, "left_t_s"));
    EXPECT_NEAR(capture(i, "t_delivered_s") - capture(i, "left_t_s"), 0.03, 1e-9);
    auto& row = still.poses.rows.emplace_back();
    for (const std::string& column : still.poses.columns) {
      const double beyond = column == "left_pan_deg" ? std::max(0.0, index(i, column)) : 0;
      const double short_of = column == "right_pan_deg" ? std::min(0.0, index(i, column)) : 0;
      row.push_back(index(i, column) - beyond - short_of);  // a servo swings past its range's end
    }
  }
  const fs::path stills = Make(still, "stills");
  int moving = 0;
  for (std::size_t i = 0; i < index.rows(); ++i) {
    const std::string image = fmt::format("{:06}/left.png", i);
    const cv::Mat3b seen = cv::imread((film / image).string());
    const cv::Mat3b expected = cv::imread((stills / image).string());
    cv::Mat difference;
    cv::absdiff(seen, expected, difference);
    const int off = cv::countNonZero(difference.reshape(1) > 8);
    EXPECT_LT(off, difference.rows * difference.cols * 3 / 200) << i;
    moving += index(i, "neck_pan_deg") > 0.5 && index(i, "neck_pan_deg") < 19.5;
  }
  EXPECT_GE(moving, 3);
}

TEST_F(FilmTest, TruthLeadsToTheSameSurfaceThoughTheEyesLookAtDifferentTimes) {
  RenderRequest request = Request("koala", "room.xml", "ideal", 20);
  request.camera.profile.timing.latency_s = 0.02;
  request.camera.profile.timing.skew_s = 0.03;
  request.truth = true;
  request.motion->duration_s = 0.3;
  request.motion->commands = {Saccade(0, 20, 5, 3)};
  const fs::path frame = Make(request) / "000003";
  const DisplacementMaps field = ReadFlo(frame / "left_disparity.flo");
  const auto picture = [&](const char* name) {
    return cv::imread((frame / name).string(), cv::IMREAD_UNCHANGED);
  };
  const cv::Mat left = picture("left_parts.png"), right = picture("right_parts.png");
  const cv::Mat seen = picture("left_visibility.png");
  ExpectSameParts(left, right, field, seen);
}

// Truth is of one instant, though rows are not; the tables say which, and when the rows are.
TEST_F(FilmTest, TheInstantOfTruthAndTheTimesOfRowsAreSaid) {
  RenderRequest request = Request("koala", "room.xml", "webcam_vga", 30);
  request.camera.profile.timing.skew_s = 0.01;
  request.motion->duration_s = 0.1;
  const fs::path set = Make(request);
  EXPECT_THAT(nlohmann::json::parse(Slurp(set / "manifest.json"))
                  .at("conventions")
                  .at("truth_instant")
                  .get<std::string>(),
              testing::HasSubstr("middle of the whole image's exposure"));
  const double readout_s = request.camera.profile.shutter.readout_s;
  ASSERT_GT(readout_s, 0.02);
  const Table capture(set / "capture.csv");
  for (std::size_t i = 0; i < capture.rows(); ++i) {
    for (const std::string eye : {"left", "right"}) {
      const double first = capture(i, eye + "_first_row_t_s");
      const double last = capture(i, eye + "_last_row_t_s");
      EXPECT_NEAR(last - first, readout_s, 2e-9);
      EXPECT_NEAR((first + last) / 2, capture(i, eye + "_t_s"), 2e-9);
      EXPECT_LE(last, capture(i, "t_delivered_s"));
    }
    EXPECT_NEAR(capture(i, "right_t_s") - capture(i, "left_t_s"), 0.01, 1e-9);
  }
}

TEST_F(FilmTest, AGlobalShutterTakesAllRowsAtOnce) {
  RenderRequest request = Request("koala", "room.xml", "ideal", 30);
  request.camera.profile.shutter.readout_s = 0.03;  // without a meaning for this shutter
  request.motion->duration_s = 0.05;
  const Table capture(Make(request) / "capture.csv");
  EXPECT_EQ(capture(0, "left_first_row_t_s"), capture(0, "left_last_row_t_s"));
}

TEST_F(FilmTest, AsManyFramesComeAsAreExpected) {
  for (const double latency_s : {0.0, 0.013, 0.05}) {
    for (const double duration_s : {0.2, 0.1999, 0.21}) {
      RenderRequest request = Request("koala", "room.xml", "ideal", 20);
      request.camera.profile.timing.latency_s = latency_s;
      request.motion->duration_s = duration_s;
      int expected = 0, came = 0;
      RenderHooks hooks;
      hooks.progress = [&expected](int, int all) { expected = all; };
      hooks.frame = [&came](const DatasetFrame&) { ++came; };
      const std::string name = fmt::format("{}_{}", latency_s, duration_s);
      ASSERT_TRUE(RenderDataset(request, {folder_.path() / name, "", {}}, hooks));
      EXPECT_EQ(came, expected) << name;
    }
  }
}

TEST_F(FilmTest, ASaccadeKeepsWhatItLeavesOut) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 10);
  request.poses = {"", {"pan_deg", "tilt_deg"}, {{0, 12}}};
  request.motion->duration_s = 0.8;
  SaccadeCommand pan;
  pan.gaze_deg[0] = 30;
  request.motion->commands = {{0.1, pan}};
  const Table path(Make(request) / "trajectory.csv");
  EXPECT_NEAR(path(path.rows() - 1, "neck_pan_deg"), 30, 0.2);
  EXPECT_NEAR(path(path.rows() - 1, "neck_tilt_deg"), 12, 0.2);
}

std::vector<FaultSpec> One(const FaultKind& kind, double from_s) {
  FaultSpec fault;
  fault.kind = kind;
  fault.from_s = from_s;
  return {fault};
}

double MeanGrey(const fs::path& image) {
  const cv::Scalar mean = cv::mean(cv::imread(image.string()));
  return (mean[0] + mean[1] + mean[2]) / 3;
}

TEST_F(FilmTest, OneEyeGoesDarkOnEveryHead) {
  for (const auto& [robot, scene] :
       {std::pair{"nao", "workspace.xml"}, {"yorick", "tabletop.xml"}, {"koala", "room.xml"}}) {
    RenderRequest request = Request(robot, scene, "ideal", 20);
    request.motion->duration_s = 0.3;
    request.faults = One(DarkEyeFault{"right", 0}, 0.1);
    const fs::path set = Make(request, robot);
    EXPECT_EQ(ReadManifest(set).request.faults.at(0).kind, request.faults[0].kind);
    const std::vector<std::string> pairs = std::string(robot) == "yorick"
                                               ? std::vector<std::string>{"peripheral_", "foveal_"}
                                               : std::vector<std::string>{""};
    for (const std::string& pair : pairs) {
      const std::string left = pair + "left.png", right = pair + "right.png";
      EXPECT_GT(MeanGrey(set / "000000" / right), 20) << robot << pair;
      EXPECT_GT(MeanGrey(set / "000005" / left), 20) << robot << pair;
      EXPECT_EQ(MeanGrey(set / "000005" / right), 0) << robot << pair;
    }
  }
}

TEST_F(FilmTest, AnEyesZeroIsOffOnYorickForBothItsPairs) {
  RenderRequest request = Request("yorick", "tabletop.xml", "ideal", 20);
  request.motion->duration_s = 0.3;
  const fs::path sound = Make(request, "sound");
  request.faults = One(ZeroOffFault{"left", -3, 0}, 0);
  const fs::path faulty = Make(request, "faulty");
  const Table path(faulty / "trajectory.csv");
  EXPECT_NEAR(path(path.rows() - 1, "left_pan_deg"), -3, 0.01);
  EXPECT_NEAR(path(path.rows() - 1, "right_pan_deg"), 0, 0.01);
  for (const std::string pair : {"peripheral_", "foveal_"}) {
    const auto same = [&](const char* eye) {
      const std::string image = "000005/" + pair + eye + ".png";
      return Slurp(sound / image) == Slurp(faulty / image);
    };
    EXPECT_FALSE(same("left")) << pair;
    EXPECT_TRUE(same("right")) << pair;
  }
}

TEST_F(FilmTest, NaosEyesDoNotTurnButMaySitCrooked) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 20);
  request.truth = true;
  request.motion->duration_s = 0.15;
  request.faults = One(ZeroOffFault{"left", 3, 0}, 0);
  try {
    Make(request, "zero_off");
    ADD_FAILURE() << "an eye that does not turn has no zero";
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("robot nao has no axis left_pan"));
  }
  const fs::path sound = [&] {
    RenderRequest without = request;
    without.faults.clear();
    return Make(without, "sound");
  }();
  request.faults = One(MisalignedEyeFault{"left", 4, 0}, 0);
  const fs::path faulty = Make(request, "crooked");
  for (const char* file : {"left.png", "left_depth.pfm"}) {
    EXPECT_NE(Slurp(sound / "000002" / file), Slurp(faulty / "000002" / file)) << file;
  }
  EXPECT_EQ(Slurp(sound / "000002" / "right_depth.pfm"),
            Slurp(faulty / "000002" / "right_depth.pfm"));
}

TEST_F(FilmTest, ASwappedPairAndAWrongBaselineReachTheFilesOfYorick) {
  RenderRequest request = Request("yorick", "tabletop.xml", "ideal", 20);
  request.motion->duration_s = 0.1;
  const fs::path sound = Make(request, "sound");
  request.faults = One(SwappedPairFault{}, 0);
  const fs::path swapped = Make(request, "swapped");
  request.faults = One(WrongBaselineFault{0.05}, 0);
  const fs::path apart = Make(request, "apart");
  for (const std::string pair : {"peripheral_", "foveal_"}) {
    const std::string left = "000001/" + pair + "left.png", right = "000001/" + pair + "right.png";
    EXPECT_EQ(Slurp(sound / left), Slurp(swapped / right)) << pair;
    EXPECT_EQ(Slurp(sound / right), Slurp(swapped / left)) << pair;
    EXPECT_NE(Slurp(sound / left), Slurp(apart / left)) << pair;
    EXPECT_NE(Slurp(sound / right), Slurp(apart / right)) << pair;
  }
}

TEST_F(FilmTest, WalkingCarriesTheTorsoThereAndSwaysIt) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 10);
  request.motion->duration_s = 2.2;
  request.motion->commands = {{0.1, WalkToCommand{0.1, 0, 0}}};
  const fs::path set = Make(request);
  EXPECT_TRUE(fs::exists(set / "000000" / "left.png")) << "one pair, though there are two lenses";
  const Table path(set / "trajectory.csv");
  EXPECT_NEAR(path(0, "base_x_m"), 0, 0.002);
  EXPECT_NEAR(path(path.rows() - 1, "base_x_m"), 0.1, 0.02);
  double leftmost = 0, rightmost = 0;
  for (std::size_t row = 0; row < path.rows(); ++row) {
    leftmost = std::max(leftmost, path(row, "base_y_m"));
    rightmost = std::min(rightmost, path(row, "base_y_m"));
  }
  EXPECT_GT(leftmost - rightmost, 0.01) << "sway";
  const auto torso = [&](const std::string& frame) {
    for (const sim::BodyPose& body : DecodePoses(Slurp(set / frame / "poses.csv"), "poses.csv")) {
      if (body.body == "base") return body.X_WB.translation().eval();
    }
    return Eigen::Vector3d(Eigen::Vector3d::Zero());
  };
  EXPECT_NEAR((torso("000020") - torso("000000")).head<2>().norm(), 0.1, 0.025);
}

TEST_F(FilmTest, BothPairsOfYorickAreFilmedWithTruthBetweenThem) {
  RenderRequest request = Request("yorick", "tabletop.xml", "ideal", 20);
  request.truth = true;
  request.between = {"peripheral_left:foveal_left"};
  request.motion->duration_s = 0.15;
  request.motion->commands = {Saccade(0, 5, 3)};
  const fs::path frame = Make(request) / "000002";
  for (const char* file :
       {"peripheral_left.png", "peripheral_right.png", "foveal_left.png", "foveal_right.png",
        "peripheral_left_disparity.flo", "foveal_left_disparity.flo"}) {
    EXPECT_TRUE(fs::exists(frame / file)) << file;
  }
  const DisplacementMaps field = ReadFlo(frame / "peripheral_left_to_foveal_left_disparity.flo");
  const cv::Mat seen = cv::imread(
      (frame / "peripheral_left_to_foveal_left_visibility.png").string(), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(field.dx.size(), seen.size());
  EXPECT_GT(cv::countNonZero(seen == 255), 50) << "the fovea lies within the periphery";
}

TEST_F(FilmTest, AWalkAtAVelocityGoesAsFarAsItSays) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 5);
  request.motion->duration_s = 3;
  request.motion->commands = {{0, WalkCommand{0.06, 0, 0}}};
  const fs::path set = Make(request);
  const Table path(set / "trajectory.csv");
  const double last_s = path(path.rows() - 1, "base_x_m") - path(path.rows() - 501, "base_x_m");
  const double t_s = path(path.rows() - 1, "t_s") - path(path.rows() - 501, "t_s");
  EXPECT_NEAR(last_s / t_s, 0.06, 0.006);
  const auto outcome = nlohmann::json::parse(Slurp(set / "manifest.json")).at("motion_outcome");
  EXPECT_EQ(outcome.at(0).at("command"), "walk");
  EXPECT_EQ(outcome.at(0).at("reached"), true);
}

TEST_F(FilmTest, TheKoalaDrivesAtTheSpeedItIsTold) {
  RenderRequest request = Request("koala", "room.xml", "ideal", 5);
  request.motion->duration_s = 1.5;
  request.motion->commands = {{0, DriveCommand{0.2, 0}}};
  const fs::path set = Make(request);
  const Table path(set / "trajectory.csv");
  const std::size_t last = path.rows() - 1, before = path.rows() / 2;
  EXPECT_NEAR((path(last, "base_x_m") - path(before, "base_x_m")) /
                  (path(last, "t_s") - path(before, "t_s")),
              0.2, 0.01);
  EXPECT_NEAR(path(last, "base_yaw_deg"), 0, 0.5);
  const auto outcome = nlohmann::json::parse(Slurp(set / "manifest.json")).at("motion_outcome");
  EXPECT_EQ(outcome.at(0).at("reached"), true);
  EXPECT_NEAR(outcome.at(0).at("end_pose").at("x_m"), path(last, "base_x_m"), 1e-6);
}

TEST_F(FilmTest, AWalkThatDoesNotArriveIsSaid) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 5);
  request.motion->duration_s = 1;
  request.motion->commands = {{0, WalkToCommand{1, 0, 0}}};
  std::string note;
  RenderHooks hooks;
  hooks.note = [&note](const std::string& line) { note = line; };
  const fs::path set = folder_.path() / "set";
  ASSERT_TRUE(RenderDataset(request, {set, "", {}}, hooks));
  EXPECT_THAT(note, testing::HasSubstr("walk_to at 0 s: the target was not reached"));
  const auto outcome = nlohmann::json::parse(Slurp(set / "manifest.json")).at("motion_outcome");
  EXPECT_EQ(outcome.at(0).at("reached"), false);
}

TEST(MotionWatch, ABaseThatStandsWhileToldToDriveIsStalled) {
  const MotionCommand drive{0, DriveCommand{0.2, 0}};
  for (const double speed : {0.2, 0.0}) {
    MotionWatch watch;
    watch.Told(drive, {});
    for (int i = 1; i <= 200; ++i) watch.Step(i * 0.01, {i * 0.01 * speed, 0, 0});
    const auto outcomes = watch.Outcomes({2 * speed, 0, 0});
    ASSERT_EQ(outcomes.size(), 1u);
    EXPECT_EQ(outcomes[0].reached, speed > 0);
    EXPECT_EQ(WhatWasNotReached(outcomes).empty(), speed > 0);
  }
}

TEST_F(FilmTest, TablesHaveNeitherNoiseNorNegativeZeros) {
  RenderRequest request = Request("nao", "workspace.xml", "ideal", 20);
  request.motion->duration_s = 0.2;
  request.motion->commands = {Saccade(0, 5, 0)};
  const fs::path set = Make(request);
  for (const char* file : {"index.csv", "trajectory.csv"}) {
    std::string text = Slurp(set / file);
    std::replace(text.begin(), text.end(), '\n', ',');
    EXPECT_THAT(text, testing::Not(testing::ContainsRegex("e-1[0-9]"))) << file;
    EXPECT_THAT(text, testing::Not(testing::ContainsRegex(",-0(\\.0*)?,"))) << file;
  }
}

TEST_F(FilmTest, InterruptedItSaysSoAndKeepsItsTables) {
  RenderRequest request = Request("koala", "room.xml", "ideal", 25);
  request.motion->commands = {{0, DriveCommand{0.2, 0}}};
  int asked = 0;
  RenderHooks hooks;
  hooks.interrupted = [&asked] { return ++asked > 2; };
  const RenderOutput output{folder_.path() / "set", "horopter render", {}};
  EXPECT_FALSE(RenderDataset(request, output, hooks));
  EXPECT_EQ(Table(output.folder / "index.csv").rows(), 2u);
  EXPECT_EQ(Table(output.folder / "capture.csv").rows(), 2u);
  EXPECT_GT(Table(output.folder / "trajectory.csv").rows(), 15u);
  EXPECT_THAT(Slurp(output.folder / "manifest.json"), testing::HasSubstr("\"complete\": false"));
}

}  // namespace
}  // namespace horopter::scenarios
