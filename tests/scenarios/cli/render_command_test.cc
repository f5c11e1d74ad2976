// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/format/scenes.h"
#include "sim/camera/camera_profile.h"
#include "tests/scenarios/cli/horopter_program.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RenderCommand : public testing::Test {
 protected:
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Renders small pictures. @return the set's folder
  fs::path Make(const std::string& arguments, const std::string& name) const {
    const Ran ran = Horopter("render " + arguments + " --out '" + At(name) + "'");
    EXPECT_EQ(ran.code, 0) << arguments << "\n" << ran.output;
    return folder_.path() / name;
  }

  static nlohmann::json Manifest(const fs::path& set) {
    return nlohmann::json::parse(Slurp(set / "manifest.json"));
  }

  void ExpectRefused(const std::string& arguments, const std::string& remedy) const {
    const Ran ran = Horopter("render " + arguments + " --out '" + At("refused") + "'");
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran.output;
    EXPECT_THAT(ran.output, HasSubstr(remedy)) << arguments;
    EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
    EXPECT_FALSE(fs::exists(At("refused"))) << arguments << " left a folder";
  }

  TemporaryFolder folder_;
};

TEST_F(RenderCommand, HelpListsWhatThereIs) {
  const std::string help = Horopter("render --help").output;
  for (const std::string& profile : sim::CameraProfile::Names()) {
    EXPECT_THAT(help, HasSubstr(profile));
  }
  for (const char* text :
       {"yorick/tabletop.xml: closeup, lateral, overview, portrait; before bookshelf, brick",
        "koala/room.xml: lateral, overview, plan", "osmesa", "left_tilt",
        "pixels of the frame before", "global shutter", "--walk 0.3,0,20", "walk_to: {at_s: 1"}) {
    EXPECT_THAT(help, HasSubstr(text));
  }
  EXPECT_THAT(help, testing::Not(HasSubstr("room_shell"))) << "that is no scene";
}

TEST_F(RenderCommand, OptionsThatDoNotApplyAreRefusedBeforeAnythingIsWritten) {
  ExpectRefused("koala/room.xml --clutter 3", "has no table");
  ExpectRefused("nao/workspace.xml --brightness 0.5", "name yorick/tabletop.xml");
  ExpectRefused("koala/room.xml --poses p.csv --pan 3", "--poses excludes --pan");
  ExpectRefused("koala/room.xml --poses p.csv --random 3", "excludes");
  ExpectRefused("koala/room.xml --axis left_pan=3 --tilt 3", "excludes");
  ExpectRefused("koala/empty_room.xml --goal 3,0", "--goal requires --obstacles");
  ExpectRefused("koala/empty_room.xml --obstacles 3 --blocked --clearance 0.3", "excludes");
  ExpectRefused("koala/room.xml --png16", "--png16 requires --truth");
  ExpectRefused("koala/room.xml --truth-between left:right", "--truth-between requires --truth");
  ExpectRefused("koala/room.xml --saccade pan=3 --poses p.csv", "--poses excludes --saccade");
  ExpectRefused("koala/room.xml --duration 3 --random 3", "excludes");
  ExpectRefused("koala/room.xml --motion m.yaml --saccade pan=3", "--motion excludes --saccade");
  ExpectRefused("--again set --pan 3", "--again excludes --pan");
  ExpectRefused("koala/room.xml --profile ideal --camera-file c.yaml", "excludes");
}

TEST_F(RenderCommand, ValuesThatDoNotHoldAreRefusedBeforeAnythingIsWritten) {
  ExpectRefused("", "or --again MANIFEST");
  ExpectRefused("koala/rom.xml", "did you mean 'koala/room.xml'?");
  ExpectRefused("koala/koala.xml", "is only a part that scenes include");
  ExpectRefused("koala/room.xml --robot nao", "has no camera 'left_eye'");
  ExpectRefused("koala/room.xml --view nosuch", "known: lateral, overview, plan");
  ExpectRefused("koala/room.xml --camera fovea", "eyes");
  ExpectRefused("koala/room.xml --profile webcam", "webcam_vga");
  ExpectRefused("koala/room.xml --size 3x3", "from 16 to 4096");
  ExpectRefused("koala/room.xml --pan 3:9", "--random N");
  ExpectRefused("koala/empty_room.xml --obstacles 2.9", "whole numbers");
  ExpectRefused("koala/room.xml --obstacles 2", "koala/empty_room.xml");
  ExpectRefused("koala/empty_room.xml --obstacles 2 --goal 3", "X,Y");
  ExpectRefused("koala/room.xml --axis left_pna=3", "did you mean 'left_pan'?");
  ExpectRefused("koala/room.xml --axis neck_pan=3", "has no such axis");
  ExpectRefused("koala/room.xml --body obstacle_1=1,2", "X,Y,Z");
  ExpectRefused("koala/room.xml --body obstacle_9=1,2,3", "did you mean 'obstacle_");
  ExpectRefused("nao/workspace.xml --pan 87 --tilt 29", "tilts from -19.0 to 11.6 deg");
  ExpectRefused("koala/room.xml --saccade left_pna=3", "did you mean 'left_pan'?");
  ExpectRefused("koala/room.xml --saccade neck_pan=3", "has no such axis");
  ExpectRefused("koala/room.xml --saccade pan=3,pan=4", "stands twice");
  ExpectRefused("koala/room.xml --saccade pan=3@2", "the motion ends at 1 s");
  ExpectRefused("koala/room.xml --saccade pan=3@", "@SECONDS");
  ExpectRefused("yorick/tabletop.xml --saccade pan=95", "is beyond this head");
  ExpectRefused("yorick/tabletop.xml --walk 1,0,0", "cannot walk: robot nao can");
  ExpectRefused("nao/workspace.xml --walk 1,0", "X,Y,TURN");
  ExpectRefused("nao/workspace.xml --drive 0.1,0", "has no wheels");
  ExpectRefused("koala/room.xml --drive 1,0", "at most");
  ExpectRefused("koala/room.xml --rate 10", "--duration as well");
  ExpectRefused("koala/room.xml --duration -1", "above 0");
  ExpectRefused("nao/workspace.xml --duration 1 --camera eyes --camera tele", "other lenses");
  ExpectRefused("yorick/tabletop.xml --background bric", "did you mean 'brick'?");
  ExpectRefused("yorick/tabletop.xml --truth --truth-between foveal_left:left", "two of foveal");
  const fs::path poses = folder_.Write("p.csv", "pan_deg\nfar\n");
  ExpectRefused("koala/room.xml --poses '" + poses.string() + "'", "p.csv:2: 'far' is no number");
  const fs::path camera = folder_.Write("c.yaml", "lens: {blr_px: 1}\n");
  ExpectRefused("koala/room.xml --camera-file '" + camera.string() + "'", "c.yaml:1:8");
}

TEST_F(RenderCommand, AManifestMakesTheSameDataSetAgain) {
  const std::string camera =
      folder_.Write("c.yaml", "width: 64\nheight: 48\nprofile: webcam_vga\nlens: {blur_px: 1}\n")
          .string();
  const fs::path first =
      Make("koala/room.xml --seed 5 --random 2 --truth --view plan --camera-file '" + camera +
               "' --body obstacle_1=1.1,0.1,0,20",
           "first");
  fs::remove(camera);
  const fs::path second = Make("--again '" + (first / "manifest.json").string() + "'", "second");
  for (const char* file :
       {"manifest.json", "index.csv", "plan.png", "000000/SHA256SUMS", "000001/SHA256SUMS"}) {
    EXPECT_FALSE(Slurp(first / file).empty()) << file;
    EXPECT_EQ(Slurp(first / file), Slurp(second / file)) << file;
  }
  const nlohmann::json manifest = Manifest(first);
  EXPECT_THAT(manifest.at("command"), HasSubstr("render koala/room.xml --seed 5 --random 2"));
  EXPECT_EQ(manifest.at("scene"), "koala/room.xml");
  EXPECT_EQ(manifest.at("gl_backend"), "osmesa");
  EXPECT_EQ(manifest.at("request").at("camera").at("lens").at("blur_px"), 1);
}

TEST_F(RenderCommand, SetsThatCannotBeMadeAgainAsTheyWereExitWithOne) {
  const fs::path first = Make("koala/room.xml --size 32x24", "first");
  nlohmann::json manifest = Manifest(first);
  EXPECT_TRUE(manifest.at("seed").is_null());
  manifest["images"]["000000/left.png"] = std::string(64, '0');
  manifest["versions"]["mujoco"] = "9.9";
  const auto forged = folder_.Write("forged.json", manifest.dump());
  const Ran ran = Horopter("render --again '" + forged.string() + "' --out '" + At("again") + "'");
  EXPECT_EQ(ran.code, 1) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("1 of 2 images are not those of"));
  EXPECT_THAT(ran.output, HasSubstr("mujoco was 9.9"));
  const auto none = folder_.Write("none.json", "{}");
  ExpectRefused("--again '" + none.string() + "'", "is no manifest of a data set");
}

// The images alone are not the set: truth and tables count as well.
TEST_F(RenderCommand, AgainNamesTheFirstFileThatDiffers) {
  const fs::path first =
      Make("koala/room.xml --size 32x24 --truth --drive 0.2,0 --rate 20 --duration 0.1", "first");
  int count = 0;
  const auto again = [&](const fs::path& set) {
    const Ran ran = Horopter("render --again '" + set.string() + "' --out '" +
                             At(std::to_string(++count)) + "'");
    EXPECT_EQ(ran.code, 1) << ran.output;
    EXPECT_THAT(ran.output, testing::Not(HasSubstr("images are not those"))) << ran.output;
    return ran.output;
  };
  const auto alter = [&](const std::string& name, const std::string& file, const std::string& from,
                         const std::string& to) {
    const fs::path set = folder_.path() / name;
    fs::copy(first, set, fs::copy_options::recursive);
    std::string text = Slurp(set / file);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << file;
    folder_.Write(name + "/" + file, text.replace(at, from.size(), to));
    return set;
  };
  const std::string sums = Slurp(first / "000001" / "SHA256SUMS");
  const std::string depth = sums.substr(sums.find("  left_depth.pfm") - 8, 24);
  EXPECT_THAT(again(alter("truth", "000001/SHA256SUMS", depth, "00000000  left_depth.pfm")),
              HasSubstr("000001/left_depth.pfm is not that of"));
  for (const std::string table : {"trajectory.csv", "capture.csv", "index.csv"}) {
    const fs::path set = alter("of_" + table, table, "\n0", "\n9");
    EXPECT_THAT(again(set), HasSubstr(table + " is not that of")) << table;
  }
  const std::string mjcf = Manifest(first).at("scene_sha256").at("mjcf");
  EXPECT_THAT(again(alter("scene", "manifest.json", mjcf, std::string(64, '0'))),
              HasSubstr("the scene is another, though of the same files"));
}

TEST_F(RenderCommand, ProgressIsForTerminalsOnly) {
  const Ran ran =
      Horopter("render koala/room.xml --size 32x24 --random 2 --out '" + At("set") + "'");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_THAT(ran.output, testing::Not(HasSubstr("\r")));
}

TEST_F(RenderCommand, FaultsComeFromAFile) {
  const std::string faults =
      folder_.Write("f.yaml", "faults:\n  - dark_eye: {eye: left}\n").string();
  const fs::path set =
      Make("nao/workspace.xml --size 32x24 --duration 0.05 --faults '" + faults + "'", "set");
  EXPECT_EQ(Manifest(set).at("request").at("faults").at(0).at("dark_eye").at("eye"), "left");
  ExpectRefused("nao/workspace.xml --faults '" + faults + "'", "are a motion's");
  const auto bad = folder_.Write("bad.yaml", "faults:\n  - dark_eye: {eye: middle}\n");
  ExpectRefused("nao/workspace.xml --duration 1 --faults '" + bad.string() + "'", "bad.yaml:2:");
}

TEST_F(RenderCommand, AgainComparesTruthByTheManifestAloneToo) {
  const fs::path first = Make("koala/room.xml --size 32x24 --truth", "first");
  nlohmann::json manifest = Manifest(first);
  for (const char* file : {"000000/SHA256SUMS", "index.csv", "legend.csv"}) {
    EXPECT_EQ(manifest.at("files").at(file).get<std::string>().size(), 64u) << file;
  }
  const auto whole = folder_.Write("whole.json", manifest.dump());
  Make("--again '" + whole.string() + "'", "same");
  manifest["files"]["000000/SHA256SUMS"] = std::string(64, '0');
  const auto forged = folder_.Write("forged.json", manifest.dump());
  const Ran ran = Horopter("render --again '" + forged.string() + "' --out '" + At("again") + "'");
  EXPECT_EQ(ran.code, 1) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("000000/SHA256SUMS is not that of"));
}

TEST_F(RenderCommand, AMotionIsFilmedAndFilmedAgain) {
  const fs::path first = Make(
      "koala/room.xml --size 32x24 --tilt 5 --saccade pan=8,tilt=5@0.1 --drive 0.2,0 --rate 20 "
      "--duration 0.3",
      "first");
  const nlohmann::json manifest = Manifest(first);
  EXPECT_EQ(manifest.at("request").at("camera").at("timing").at("rate_hz"), 20);
  EXPECT_EQ(manifest.at("request").at("motion").at("commands").size(), 2u);
  EXPECT_GE(manifest.at("frames"), 6);
  EXPECT_THAT(Slurp(first / "index.csv"), HasSubstr("\n5,000005,"));
  const fs::path second = Make("--again '" + first.string() + "'", "second");
  for (const char* file : {"manifest.json", "trajectory.csv", "000005/SHA256SUMS"}) {
    EXPECT_EQ(Slurp(first / file), Slurp(second / file)) << file;
  }
}

TEST_F(RenderCommand, AgainSaysThatTheSceneHasChangedSince) {
  const fs::path scenes = folder_.path() / "scenes";
  fs::copy(ScenesDir(), scenes, fs::copy_options::recursive);
  setenv("HOROPTER_SCENES_DIR", scenes.c_str(), 1);
  const fs::path first = Make("koala/room.xml --size 32x24", "first");
  const fs::path shell = scenes / "koala" / "room_shell.xml";
  std::string text = Slurp(shell);
  const std::size_t light = text.find("<light ");
  ASSERT_NE(light, std::string::npos);
  folder_.Write("scenes/koala/room_shell.xml", text.insert(light, "<light pos='0 0 2'/>"));
  const Ran ran = Horopter("render --again '" + first.string() + "' --out '" + At("again") + "'");
  unsetenv("HOROPTER_SCENES_DIR");
  EXPECT_EQ(ran.code, 1) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("was made: koala/room_shell.xml\n"));
  EXPECT_THAT(ran.output, HasSubstr("; the scene is another: koala/room_shell.xml"));
}

TEST_F(RenderCommand, GeneratedRoomIsInTheSet) {
  const fs::path set =
      Make("koala/empty_room.xml --obstacles 3 --goal 2.5,0 --clearance 0.3 --size 32x24", "room");
  const auto room = nlohmann::json::parse(Slurp(set / "room.json"));
  EXPECT_EQ(room.at("obstacles").size(), 3u);
  EXPECT_GE(room.at("clearance_m"), 0.3);
  EXPECT_NEAR(room.at("path_m").back().at(0), 2.5, 1e-9);
  EXPECT_THAT(Slurp(set / "room.xml"), HasSubstr("<mujoco"));
  EXPECT_EQ(Manifest(set).at("seed"), 0) << "a generated room has a seed";
}

TEST_F(RenderCommand, EyesTurnEachOnItsOwn) {
  const fs::path set =
      Make("koala/room.xml --axis left_pan=-5 --axis right_tilt=12 --size 32x24", "axes");
  EXPECT_THAT(Slurp(set / "index.csv"), HasSubstr("\n0,000000,0.000000000,0,0,-5,0,0,12"));
}

}  // namespace
}  // namespace horopter::scenarios
