// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_dataset.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <utility>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/state_tables.h"
#include "scenarios/render/contact_sheet.h"
#include "scenarios/render/manifest.h"
#include "tests/scenarios/format/corpus.h"
#include "tests/scenarios/render/same_parts.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string Text(const fs::path& file) { return Slurp(file); }

class RenderDatasetTest : public testing::Test {
 protected:
  static RenderRequest Request(const std::string& robot, const std::string& scene) {
    RenderRequest request;
    request.scene = robot + "/" + scene;
    request.robot = robot;
    request.camera.width = 96;
    request.camera.height = 72;
    request.poses = Gazes({{0, 0, 0}});
    return request;
  }

  static PoseTable Gazes(std::vector<std::vector<double>> rows) {
    return {"", {"pan_deg", "tilt_deg", "vergence_deg"}, std::move(rows)};
  }

  RenderOutput Output(const std::string& name = "set") const {
    return {folder_.path() / name, "horopter render", {{"horopter", "0"}}};
  }

  /// Makes the data set; its folder.
  fs::path Make(const RenderRequest& request, const std::string& name = "set") const {
    const RenderOutput output = Output(name);
    EXPECT_TRUE(RenderDataset(request, output));
    return output.folder;
  }

  static cv::Mat Picture(const fs::path& file) {
    return cv::imread(file.string(), cv::IMREAD_UNCHANGED);
  }

  TemporaryFolder folder_;
};

TEST_F(RenderDatasetTest, DisparityLeadsToTheSameSurfaceInTheOtherEye) {
  RenderRequest request = Request("koala", "room.xml");
  request.poses = Gazes({{0, 5, 3}, {8, 2, 4}});
  request.truth = true;
  const fs::path set = Make(request);
  const fs::path frame = set / "000001";
  const DisplacementMaps field = ReadFlo(frame / "left_disparity.flo");
  const cv::Mat left = Picture(frame / "left_parts.png");
  const cv::Mat right = Picture(frame / "right_parts.png");
  const cv::Mat seen = Picture(frame / "left_visibility.png");
  int same = 0, all = 0;
  for (int v = 0; v < left.rows; ++v) {
    for (int u = 0; u < left.cols; ++u) {
      if (seen.at<uchar>(v, u) != 255) continue;
      const int x = static_cast<int>(std::lround(u + field.dx(v, u)));
      const int y = static_cast<int>(std::lround(v + field.dy(v, u)));
      if (x < 0 || y < 0 || x >= right.cols || y >= right.rows) continue;
      ++all;
      same += right.at<std::uint16_t>(y, x) == left.at<std::uint16_t>(v, u) ? 1 : 0;
    }
  }
  EXPECT_GT(all, left.rows * left.cols / 2);
  EXPECT_GT(same, all * 95 / 100);  // the rest are pixels whose match lies on an edge
  EXPECT_TRUE(fs::exists(frame / "left_flow_previous_to_this.flo"));
  EXPECT_NE(Text(set / "manifest.json").find("\"complete\": true"), std::string::npos);
}

TEST_F(RenderDatasetTest, FlowLiesOnThePixelsOfTheFrameBefore) {
  RenderRequest request = Request("koala", "room.xml");
  request.poses = Gazes({{0, 5, 0}, {6, 5, 0}});
  request.truth = true;
  const fs::path set = Make(request);
  const DisplacementMaps flow = ReadFlo(set / "000001" / "left_flow_previous_to_this.flo");
  const cv::Mat before = Picture(set / "000000" / "left_parts.png");
  const cv::Mat after = Picture(set / "000001" / "left_parts.png");
  const cv::Mat seen = Picture(set / "000001" / "left_flow_previous_to_this_visibility.png");
  ExpectSameParts(before, after, flow, seen);
}

TEST_F(RenderDatasetTest, EveryPairOfAHeadIsInItUnderItsName) {
  const fs::path set = Make(Request("yorick", "tabletop.xml"));
  for (const char* name : {"peripheral_left.png", "peripheral_right.png", "foveal_left.png"}) {
    EXPECT_TRUE(fs::exists(set / "000000" / name)) << name;
  }
}

TEST_F(RenderDatasetTest, DisparityBetweenPairsLeadsToTheSameSurfaceBothWays) {
  RenderRequest request = Request("yorick", "tabletop.xml");
  request.truth = true;
  request.between = {"peripheral_left:foveal_right"};
  request.poses = Gazes({{0, 20, 10}});
  const fs::path frame = Make(request) / "000000";
  const auto same_surface = [&](const std::string& from, const std::string& to) {
    const std::string stem = from + "_to_" + to;
    const DisplacementMaps field = ReadFlo(frame / (stem + "_disparity.flo"));
    const cv::Mat seen = Picture(frame / (stem + "_visibility.png"));
    const cv::Mat1f here = ReadPfm(frame / (from + "_depth.pfm"));
    const cv::Mat first = Picture(frame / (from + "_parts.png"));
    const cv::Mat second = Picture(frame / (to + "_parts.png"));
    int same = 0, all = 0;
    for (int v = 0; v < here.rows; ++v) {
      for (int u = 0; u < here.cols; ++u) {
        if (seen.at<uchar>(v, u) != 255) continue;
        const int x = static_cast<int>(std::lround(u + field.dx(v, u)));
        const int y = static_cast<int>(std::lround(v + field.dy(v, u)));
        if (x < 0 || y < 0 || x >= second.cols || y >= second.rows) continue;
        ++all;
        same += second.at<std::uint16_t>(y, x) == first.at<std::uint16_t>(v, u) ? 1 : 0;
      }
    }
    EXPECT_GT(all, 20) << stem;
    EXPECT_GT(same, all * 9 / 10) << stem;
    return std::pair{cv::countNonZero(seen == 64), all};
  };
  const auto [outside, inside] = same_surface("peripheral_left", "foveal_right");
  EXPECT_GT(outside, 10 * inside) << "most of the wide view is outside the narrow one";
  const auto [lost, found] = same_surface("foveal_right", "peripheral_left");
  EXPECT_LT(lost, found);
}

TEST_F(RenderDatasetTest, SameSeedSameBytesAnotherSeedAnotherScene) {
  RenderRequest request = Request("nao", "workspace.xml");
  request.pairs = {"eyes"};
  request.camera.profile = sim::CameraProfile::Named("webcam_vga");
  const auto play = [&](const char* name, std::uint64_t seed) {
    request.seed = seed;
    return Text(Make(request, name) / "000000" / "left.png");
  };
  const std::string first = play("a", 3);
  EXPECT_EQ(first, play("b", 3));
  EXPECT_NE(first, play("c", 4));
}

TEST_F(RenderDatasetTest, ManifestMakesTheSameBytesAgain) {
  RenderRequest request = Request("koala", "empty_room.xml");
  request.room.emplace().goal_m = {2.5, 0.2};
  request.room->spec.max_obstacles = 5;
  request.seed = 7;
  request.truth = true;
  request.camera.profile = sim::CameraProfile::Named("webcam_vga");
  request.camera.profile.noise.read_noise_dn = 2.5;
  request.poses = Gazes({{1.0 / 3, 5, 3}, {-8, 2, 4}});
  const fs::path first = Make(request, "first");
  const DatasetManifest manifest = ReadManifest(first);
  const fs::path second = Make(manifest.request, "second");
  for (const char* file : {"000000/SHA256SUMS", "000001/SHA256SUMS", "manifest.json", "room.json",
                           "room.xml", "index.csv", "legend.csv"}) {
    EXPECT_FALSE(Text(first / file).empty()) << file;
    EXPECT_EQ(Text(first / file), Text(second / file)) << file;
  }
  EXPECT_EQ(WhatDiffers(manifest, ReadManifest(second)), "");
  request.camera.profile.noise.read_noise_dn = 2.4;
  const fs::path other = Make(request, "other");
  EXPECT_THAT(WhatDiffers(manifest, ReadManifest(other)),
              testing::StartsWith("4 of 4 images are not those of " + manifest.name));
}

TEST_F(RenderDatasetTest, ManifestSaysWhatStillViewsLeaveOutOfTheProfile) {
  RenderRequest request = Request("koala", "room.xml");
  const auto left_out = [&](const char* profile) {
    request.camera.profile = sim::CameraProfile::Named(profile);
    const auto manifest = nlohmann::json::parse(Text(Make(request, profile) / "manifest.json"));
    return manifest.at("left_out_of_profile");
  };
  EXPECT_TRUE(left_out("vga_noise").empty());
  const nlohmann::json sony = left_out("sony_xc999");
  for (const char* part : {"exposure.time_s", "shutter", "timing"}) {
    EXPECT_TRUE(sony.contains(part)) << part;
  }
}

TEST_F(RenderDatasetTest, CalibrationSetOfTwentyPairsWithTheBoardMovedAndTilted) {
  std::string csv =
      "pan_deg,tilt_deg,board.x_m,board.y_m,board.z_m,board.yaw_deg,board.pitch_deg,"
      "board.roll_deg\n";
  for (int i = 0; i < 20; ++i) {
    csv += fmt::format("0,0,{},{},0.5,{},{},{}\n", 0.7 + 0.01 * i, 0.01 * (i % 5 - 2),
                       180 + 3 * (i % 7 - 3), 4 * (i % 4 - 2), 5 * (i % 3 - 1));
  }
  RenderRequest request = Request("nao", "workspace.xml");
  request.pairs = {"eyes"};
  request.truth = true;
  request.poses = DecodePoseTable(csv, "board.csv");
  const fs::path set = Make(request);
  std::set<std::string> images;
  for (int i = 0; i < 20; ++i) {
    const fs::path frame = set / fmt::format("{:06}", i);
    images.insert(Text(frame / "left.png"));
    const auto bodies = DecodePoses(Text(frame / "poses.csv"), "poses.csv");
    const auto board = std::find_if(bodies.begin(), bodies.end(),
                                    [](const sim::BodyPose& b) { return b.body == "board"; });
    ASSERT_NE(board, bodies.end());
    const BodyPlacement asked{{0.7 + 0.01 * i, 0.01 * (i % 5 - 2), 0.5},
                              180.0 + 3 * (i % 7 - 3),
                              4.0 * (i % 4 - 2),
                              5.0 * (i % 3 - 1)};
    EXPECT_TRUE(board->X_WB.isApprox(asked.X_OBody(), 1e-9)) << i;
  }
  EXPECT_EQ(images.size(), 20u);
}

TEST_F(RenderDatasetTest, WhatDoesNotHoldLeavesNothing) {
  const auto refused = [this](const RenderRequest& request, const std::string& why) {
    const RenderOutput output = Output("refused");
    try {
      RenderDataset(request, output);
      ADD_FAILURE() << why;
    } catch (const std::exception& error) {
      EXPECT_THAT(error.what(), HasSubstr(why));
    }
    EXPECT_FALSE(fs::exists(output.folder)) << why;
  };
  RenderRequest request = Request("yorick", "tabletop.xml");
  request.poses = Gazes({{0, 0, 0}, {120, 0, 0}});
  refused(request, "beyond this head");
  request = Request("yorick", "tabletop.xml");
  request.poses.columns = {"base.x_m", "base.y_m", "base.z_m"};
  refused(request, "base: is the robot");
  request.poses.columns = {"neck.x_m", "neck.y_m", "neck.z_m"};
  refused(request, "'neck' cannot be placed");
  request = Request("koala", "room.xml");
  request.views = {"overview", "nosuch"};
  refused(request, "--view = nosuch");
  request = Request("koala", "room.xml");
  request.table.emplace().clutter = 3;
  refused(request, "has no table");
  request = Request("koala", "koala.xml");
  refused(request, "is only a part");
  request = Request("yorick", "tabletop.xml");
  request.between = {"peripheral_left:foveal_left"};
  refused(request, "needs --truth");
}

TEST_F(RenderDatasetTest, InterruptedSetSaysThatItIsIncomplete) {
  RenderRequest request = Request("koala", "room.xml");
  request.poses = Gazes({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  int asked = 0;
  RenderHooks hooks;
  hooks.interrupted = [&asked] { return ++asked > 1; };
  const RenderOutput output = Output();
  EXPECT_FALSE(RenderDataset(request, output, hooks));
  EXPECT_TRUE(fs::exists(output.folder / "000000" / "left.png"));
  EXPECT_FALSE(fs::exists(output.folder / "000001"));
  EXPECT_THAT(Text(output.folder / "manifest.json"), HasSubstr("\"complete\": false"));
}

TEST(ContactSheet, ASpreadHoldsTheFirstAndTheLastFrame) {
  DatasetFrame frame;
  const DatasetEye eye{
      {hardware::Pose::Identity(), hardware::CameraModel::FromHorizontalFov(32, 24, 1)},
      cv::Mat3b(24, 32, cv::Vec3b::all(0)),
      {},
      {},
      {}};
  frame.pairs.push_back({"", eye, eye});
  std::vector<int> taken;
  ContactSheet sheet(4);
  for (int i = 0; i < 31; ++i) {
    const int rows = sheet.picture().rows;
    sheet.AddSpread(frame, i, 31);
    if (sheet.picture().rows > rows) taken.push_back(i);
  }
  EXPECT_EQ(taken, (std::vector<int>{0, 10, 20, 30}));
}

TEST_F(RenderDatasetTest, ContactSheetHasARowPerFrame) {
  RenderRequest request = Request("koala", "room.xml");
  request.poses = Gazes({{0, 0, 0}, {5, 0, 2}});
  request.truth = true;
  ContactSheet sheet;
  RenderHooks hooks;
  hooks.frame = [&sheet](const DatasetFrame& frame) { sheet.Add(frame); };
  ASSERT_TRUE(RenderDataset(request, Output(), hooks));
  EXPECT_EQ(sheet.picture().rows, 2 * 240);
  EXPECT_GT(sheet.picture().cols, 4 * 280);
}

}  // namespace
}  // namespace horopter::scenarios
