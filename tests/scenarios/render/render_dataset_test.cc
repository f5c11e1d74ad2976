// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_dataset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/render/contact_sheet.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
const fs::path kScenes = HOROPTER_SOURCE_DIR "/scenes";

class RenderDatasetTest : public testing::Test {
 protected:
  RenderRequest Request(const std::string& robot, const std::string& scene) {
    RenderRequest request;
    request.setup.scene = kScenes / robot / scene;
    request.robot = LoadRobotDescription(kScenes / robot / "robot.yaml");
    request.size = cv::Size(96, 72);
    request.gazes = {Gaze{}};
    request.out = folder_.path() / robot;
    return request;
  }

  static std::string Text(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
};

TEST_F(RenderDatasetTest, DisparityLeadsToTheSameSurfaceInTheOtherEye) {
  RenderRequest request = Request("koala", "room.xml");
  request.gazes = {{0, 5, 3}, {8, 2, 4}};
  request.truth = true;
  ASSERT_TRUE(RenderDataset(request));

  const fs::path frame = request.out / "000001";
  const DisplacementMaps field = ReadFlo(frame / "left_disparity.flo");
  const cv::Mat left = cv::imread((frame / "left_parts.png").string(), cv::IMREAD_UNCHANGED);
  const cv::Mat right = cv::imread((frame / "right_parts.png").string(), cv::IMREAD_UNCHANGED);
  const cv::Mat seen = cv::imread((frame / "left_visibility.png").string(), cv::IMREAD_UNCHANGED);
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
  EXPECT_TRUE(fs::exists(frame / "left_flow.flo"));
  EXPECT_NE(Text(request.out / "manifest.json").find("\"complete\": true"), std::string::npos);
}

TEST_F(RenderDatasetTest, EveryPairOfAHeadIsInItUnderItsName) {
  RenderRequest request = Request("yorick", "tabletop.xml");
  ASSERT_TRUE(RenderDataset(request));
  for (const char* name : {"peripheral_left.png", "peripheral_right.png", "foveal_left.png"}) {
    EXPECT_TRUE(fs::exists(request.out / "000000" / name)) << name;
  }
}

TEST_F(RenderDatasetTest, SameSeedSameBytesAnotherSeedAnotherScene) {
  RenderRequest request = Request("nao", "workspace.xml");
  request.pairs = {"eyes"};
  request.profile = sim::CameraProfile::Named("webcam_vga");
  const auto play = [&](const char* name, std::uint64_t seed) {
    request.setup.seed = seed;
    request.out = folder_.path() / name;
    EXPECT_TRUE(RenderDataset(request));
    return Text(request.out / "000000" / "left.png");
  };
  const std::string first = play("a", 3);
  EXPECT_EQ(first, play("b", 3));
  EXPECT_NE(first, play("c", 4));
}

TEST_F(RenderDatasetTest, GazeBeyondTheHeadLeavesNothing) {
  RenderRequest request = Request("yorick", "tabletop.xml");
  request.gazes = {Gaze{}, {120, 0, 0}};
  EXPECT_THROW(RenderDataset(request), hardware::ConfigError);
  EXPECT_FALSE(fs::exists(request.out));
}

TEST_F(RenderDatasetTest, InterruptedSetSaysThatItIsIncomplete) {
  RenderRequest request = Request("koala", "room.xml");
  request.gazes = {Gaze{}, Gaze{}, Gaze{}};
  int asked = 0;
  RenderHooks hooks;
  hooks.interrupted = [&asked] { return ++asked > 1; };
  EXPECT_FALSE(RenderDataset(request, hooks));
  EXPECT_TRUE(fs::exists(request.out / "000000" / "left.png"));
  EXPECT_FALSE(fs::exists(request.out / "000001"));
  EXPECT_NE(Text(request.out / "manifest.json").find("\"complete\": false"), std::string::npos);
}

TEST_F(RenderDatasetTest, ContactSheetHasARowPerFrame) {
  RenderRequest request = Request("koala", "room.xml");
  request.gazes = {Gaze{}, {5, 0, 2}};
  request.truth = true;
  ContactSheet sheet;
  RenderHooks hooks;
  hooks.frame = [&sheet](const DatasetFrame& frame) { sheet.Add(frame); };
  ASSERT_TRUE(RenderDataset(request, hooks));
  EXPECT_EQ(sheet.picture().rows, 2 * 240);
  EXPECT_GT(sheet.picture().cols, 4 * 280);
}

}  // namespace
}  // namespace horopter::scenarios
