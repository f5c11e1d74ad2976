// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/camera_fields.h"

#include <gtest/gtest.h>

#include <string>

#include "scenarios/format/diagnostics.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

class CameraFile : public testing::Test {
 protected:
  std::string Complaint(const std::string& yaml) const {
    const auto file = folder_.Write("camera.yaml", yaml);
    try {
      ReadCameraFile(file);
    } catch (const ScenarioError& error) {
      const std::string text = error.what();
      return text.substr(file.string().size());
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(CameraFile, ChangesAProfileByHandAndKeepsWhatItDoesNotName) {
  CameraSpec defaults;
  defaults.width = defaults.height = kRobotsOwn;
  const CameraSpec camera = ReadCameraFile(
      folder_.Write("camera.yaml", "profile: webcam_vga\nlens: {blur_px: 2}\n"), defaults);
  sim::CameraProfile expected = sim::CameraProfile::Named("webcam_vga");
  expected.lens.blur_px = 2;
  EXPECT_EQ(camera.profile, expected);
  EXPECT_EQ(camera.width, kRobotsOwn);
}

TEST_F(CameraFile, IsReadAsStrictlyAsAScenario) {
  EXPECT_EQ(Complaint("profile: ideal\nlens: {blur_px: 0.5}\n"), "");
  EXPECT_EQ(Complaint("lens: {blr_px: 1}\n"),
            ":1:8: lens: unknown key 'blr_px'; did you mean 'blur_px'?");
  EXPECT_EQ(Complaint("camera: {width: 320}\n").substr(0, 29), ":1:1: unknown key 'camera'; k");
  EXPECT_NE(Complaint("noise: {bits: 12}\n"), "");
  EXPECT_NE(Complaint("timing:\n  rate_hz: 25\n  capture_jitter_s: 0.5\n").find(":3:21:"),
            std::string::npos)
      << "what no single field shows has its place too";
}

}  // namespace
}  // namespace horopter::scenarios
