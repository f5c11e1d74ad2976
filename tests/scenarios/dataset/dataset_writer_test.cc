// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/dataset_writer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "scenarios/dataset/camera_yaml.h"
#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/dataset/state_tables.h"
#include "scenarios/results/files.h"
#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of this test's own that goes when it ends.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "horopter-dataset-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    folder_ = name;
  }
  ~Scratch() { fs::remove_all(folder_); }
  fs::path operator/(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

/// Two boxes seen by a verged pair.
class Studio {
 public:
  Studio()
      : world_(sim::World::FromXml(R"(
            <mujoco><worldbody>
              <geom name="wall" type="box" pos="2.1 0 0" size=".1 2 2"/>
              <body name="crate" pos="1 .1 0"><freejoint/>
                <geom name="lid" type="box" size=".1 .1 .1"/></body>
            </worldbody></mujoco>)")),
        shapes_(std::make_shared<sim::SceneShapes>(world_->model())) {}

  sim::SceneLegend legend() const { return sim::SceneLegend(world_->model()); }

  sim::EyeView View(double y) const {
    hardware::Pose X = hardware::Pose::Identity();
    X.translation().y() = y;
    X.linear() = hardware::OpticalToBody();
    return {X, hardware::CameraModel::FromHorizontalFov(24, 18, 1)};
  }

  DatasetPair Pair(const std::string& name) const {
    const sim::SceneSnapshot now(shapes_, world_->data());
    const auto eye = [&](double y, double other_y) {
      DatasetEye seen{View(y), cv::Mat(18, 24, CV_8UC3, cv::Scalar(10, 20, 30)), {}, {}, {}};
      seen.truth = sim::CaptureEyeTruth(now, seen.view);
      seen.to_other_eye = sim::TrueDisparity(now, *seen.truth, View(other_y));
      seen.flow_from_previous = sim::TrueFlow(now, *seen.truth, now, seen.view);
      return seen;
    };
    return {name, eye(0.05, -0.05), eye(-0.05, 0.05)};
  }

  DatasetFrame Frame() const {
    DatasetFrame frame;
    frame.t = hardware::Time(hardware::FromSeconds(0.04));
    frame.head.left.pan_rad = 0.1;
    frame.pairs.push_back(Pair(""));
    frame.state = sim::ReadWorldState(*world_);
    return frame;
  }

 private:
  std::unique_ptr<sim::World> world_;
  std::shared_ptr<const sim::SceneShapes> shapes_;
};

DatasetInfo Info() {
  DatasetInfo info;
  info.scene = "koala/room";
  info.seed = 7;
  info.gl_renderer = "llvmpipe";
  info.versions = {{"horopter", "0.1.0"}};
  return info;
}

nlohmann::json Manifest(const fs::path& folder) {
  return nlohmann::json::parse(ReadFile(folder / "manifest.json"));
}

std::set<std::string> FilesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

TEST(DatasetWriter, WritesWhatItSaysAndItReadsBack) {
  const Scratch scratch;
  const Studio studio;
  const fs::path folder = scratch / "set";
  DatasetWriter writer(folder, Info(), studio.legend());
  const DatasetFrame frame = studio.Frame();
  const fs::path at = writer.AddFrame(frame);
  writer.Finish();

  EXPECT_EQ(FilesIn(folder),
            (std::set<std::string>{"000000", "index.csv", "legend.csv", "manifest.json"}));
  std::set<std::string> expected = {"SHA256SUMS", "cameras.yaml", "contacts.csv", "joints.csv",
                                    "poses.csv"};
  for (const std::string eye : {"left", "right"}) {
    for (const char* ending : {".png", "_depth.pfm", "_normals.pfm", "_parts.png", "_objects.png",
                               "_disparity.flo", "_visibility.png", "_flow_previous_to_this.flo",
                               "_flow_previous_to_this_visibility.png"}) {
      expected.insert(eye + ending);
    }
  }
  EXPECT_EQ(FilesIn(at), expected);

  const DatasetEye& left = frame.pairs[0].left;
  EXPECT_EQ(cv::norm(cv::imread(at / "left.png"), left.bgr, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(ReadPfm(at / "left_depth.pfm"), left.truth->depth, cv::NORM_INF), 0);
  EXPECT_EQ(cv::countNonZero(UnpackIds(ReadPng16(at / "left_parts.png", 1)) != left.truth->ids), 0);
  const DisplacementMaps disparity = ReadFlo(at / "left_disparity.flo");
  EXPECT_EQ(cv::norm(disparity.dx, left.to_other_eye->dx, cv::NORM_INF), 0);
  const StereoViews views = DecodeCameras(ReadFile(at / "cameras.yaml"), "cameras.yaml");
  EXPECT_TRUE(views.left.X_WC.isApprox(left.view.X_WC));
  EXPECT_EQ(DecodePoses(ReadFile(at / "poses.csv"), "poses.csv")[0].body, "crate");
  const cv::Mat1b seen = cv::imread(at / "left_visibility.png", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(cv::countNonZero((seen == 255) != left.to_other_eye->Mask(sim::Visibility::kVisible)),
            0);
  EXPECT_EQ(ReadFile(folder / "legend.csv"),
            "kind,value,name,object_value\npart,1,wall,1\npart,2,lid,2\n"
            "object,1,wall,1\nobject,2,crate,2\n");
  EXPECT_THAT(ReadFile(folder / "index.csv"),
              HasSubstr("frame,folder,t_s,neck_pan_deg,neck_tilt_deg,left_pan_deg"));
  EXPECT_THAT(ReadFile(folder / "index.csv"), HasSubstr("\n0,000000,0.040000000,0,0,5.7295"));
}

TEST(DatasetWriter, SaysThatItIsIncompleteUntilItIsFinished) {
  const Scratch scratch;
  const Studio studio;
  {
    DatasetWriter writer(scratch / "set", Info(), studio.legend());
    writer.AddFrame(studio.Frame());
  }
  EXPECT_EQ(Manifest(scratch / "set")["complete"], false);
  DatasetWriter other(scratch / "other", Info(), studio.legend());
  other.AddFrame(studio.Frame());
  other.AddFrame(studio.Frame());
  EXPECT_EQ(Manifest(scratch / "other")["complete"], false);
  other.Finish();
  const nlohmann::json manifest = Manifest(scratch / "other");
  EXPECT_EQ(manifest["complete"], true);
  EXPECT_EQ(manifest["frames"], 2);
  EXPECT_EQ(manifest["scene"], "koala/room");
  EXPECT_EQ(manifest["seed"], 7);
  EXPECT_EQ(manifest["gl_renderer"], "llvmpipe");
  EXPECT_EQ(manifest["versions"]["horopter"], "0.1.0");
  EXPECT_EQ(manifest["images"].size(), 4u);
}

TEST(DatasetWriter, ManifestSaysWhatWasAskedForAndWhichPixelsFlowLiesOn) {
  const Scratch scratch;
  DatasetInfo info = Info();
  info.seed.reset();
  info.robot = "koala";
  info.gl_backend = "osmesa";
  info.command = "horopter render koala/room.xml";
  info.request = R"({"scene": "koala/room"})";
  info.left_out_of_profile = {{"shutter", "still"}};
  DatasetWriter(scratch / "set", info, {}).Finish();
  const nlohmann::json manifest = Manifest(scratch / "set");
  EXPECT_TRUE(manifest["seed"].is_null());
  EXPECT_EQ(manifest["robot"], "koala");
  EXPECT_EQ(manifest["gl_backend"], "osmesa");
  EXPECT_EQ(manifest["command"], "horopter render koala/room.xml");
  EXPECT_EQ(manifest["request"]["scene"], "koala/room");
  EXPECT_EQ(manifest["left_out_of_profile"]["shutter"], "still");
  EXPECT_THAT(manifest["conventions"]["flow"], HasSubstr("pixels of the previous frame"));
  EXPECT_THAT(manifest["conventions"]["normals"], HasSubstr("optical frame of the camera"));
}

TEST(DatasetWriter, DisparityBetweenAnyTwoCamerasIsNamedAfterThem) {
  const Scratch scratch;
  const Studio studio;
  DatasetFrame frame;
  frame.pairs = {studio.Pair("peripheral"), studio.Pair("foveal")};
  frame.between = {{"peripheral_left", "foveal_right", *frame.pairs[0].left.to_other_eye}};
  DatasetWriter writer(scratch / "set", Info(), {});
  const fs::path at = writer.AddFrame(frame);
  const DisplacementMaps read = ReadFlo(at / "peripheral_left_to_foveal_right_disparity.flo");
  EXPECT_EQ(cv::norm(read.dx, frame.between[0].field.dx, cv::NORM_INF), 0);
  EXPECT_TRUE(fs::exists(at / "peripheral_left_to_foveal_right_visibility.png"));
  frame.between[0].to = "foveal_middle";
  EXPECT_THROW(writer.AddFrame(frame), std::invalid_argument);
}

TEST(DatasetWriter, HashesAreThoseOfSha256sum) {
  const Scratch scratch;
  const Studio studio;
  DatasetWriter writer(scratch / "set", Info(), studio.legend());
  const fs::path at = writer.AddFrame(studio.Frame());
  writer.Finish();
  const std::string check = "cd '" + at.string() + "' && sha256sum --quiet -c SHA256SUMS";
  EXPECT_EQ(std::system(check.c_str()), 0);
  const std::string sums = ReadFile(at / "SHA256SUMS");
  const std::string left = Manifest(scratch / "set")["images"]["000000/left.png"];
  EXPECT_THAT(sums, HasSubstr(left + "  left.png\n"));
}

TEST(DatasetWriter, EqualFramesGiveEqualBytes) {
  const Scratch scratch;
  for (const char* name : {"a", "b"}) {
    const Studio studio;
    DatasetWriter writer(scratch / name, Info(), studio.legend());
    writer.AddFrame(studio.Frame());
    writer.Finish();
  }
  EXPECT_EQ(ReadFile(scratch / "a/manifest.json"), ReadFile(scratch / "b/manifest.json"));
  EXPECT_EQ(ReadFile(scratch / "a/000000/SHA256SUMS"), ReadFile(scratch / "b/000000/SHA256SUMS"));
}

TEST(DatasetWriter, LeavesNothingOfAFrameThatFails) {
  const Scratch scratch;
  const Studio studio;
  DatasetWriter writer(scratch / "set", Info(), studio.legend());
  DatasetFrame frame = studio.Frame();
  frame.pairs[0].right.bgr = cv::Mat(5, 5, CV_8UC3);
  EXPECT_THROW(writer.AddFrame(frame), std::invalid_argument);
  frame = studio.Frame();
  frame.pairs[0].left.bgr = cv::Mat(18, 24, CV_8UC1);
  EXPECT_THROW(writer.AddFrame(frame), std::invalid_argument);
  frame = studio.Frame();
  frame.pairs.push_back(frame.pairs[0]);
  EXPECT_THROW(writer.AddFrame(frame), std::invalid_argument) << "two pairs of one name";
  frame = studio.Frame();
  frame.pairs[0].left.truth->depth = cv::Mat1f(1, 1);
  EXPECT_THROW(writer.AddFrame(frame), std::invalid_argument);
  EXPECT_EQ(FilesIn(scratch / "set"),
            (std::set<std::string>{"index.csv", "legend.csv", "manifest.json"}));
  EXPECT_EQ(writer.frame_count(), 0);
  EXPECT_EQ(writer.AddFrame(studio.Frame()).filename(), "000000");
}

TEST(DatasetWriter, AFrameThatCannotBeWrittenLeavesNoFolderAndNoRow) {
  const Scratch scratch;
  const Studio studio;
  DatasetWriter writer(scratch / "set", Info(), studio.legend());
  std::ofstream(scratch / "set/000000") << "in the way";
  EXPECT_THROW(writer.AddFrame(studio.Frame()), ResultsError);
  EXPECT_EQ(FilesIn(scratch / "set"),
            (std::set<std::string>{"000000", "index.csv", "legend.csv", "manifest.json"}));
  EXPECT_THAT(ReadFile(scratch / "set/index.csv"), testing::Not(HasSubstr("000000")));
}

TEST(DatasetWriter, KeepsPairsApartByName) {
  const Scratch scratch;
  const Studio studio;
  DatasetFrame frame;
  frame.pairs = {studio.Pair("peripheral"), studio.Pair("foveal")};
  DatasetWriter writer(scratch / "set", Info(), {});
  const auto files = FilesIn(writer.AddFrame(frame));
  EXPECT_TRUE(files.count("peripheral_left.png"));
  EXPECT_TRUE(files.count("foveal_right_depth.pfm"));
  EXPECT_TRUE(files.count("foveal_cameras.yaml"));
  EXPECT_FALSE(files.count("poses.csv")) << "no state was given";
  EXPECT_FALSE(files.count("foveal_left_objects.png")) << "no legend was given";
}

TEST(DatasetWriter, AddsSixteenBitPicturesAndCountsWhatDoesNotFit) {
  const Scratch scratch;
  const Studio studio;
  DatasetWriter writer(scratch / "set", Info(), studio.legend(),
                       {.png16 = true, .depth_units_per_m = 40000});
  DatasetFrame frame = studio.Frame();
  const fs::path at = writer.AddFrame(frame);
  writer.Finish();
  const cv::Mat1f depth = UnpackDepth(ReadPng16(at / "left_depth.png", 1), 40000);
  const cv::Mat1f& exact = frame.pairs[0].left.truth->depth;
  EXPECT_NEAR(depth(9, 9), exact(9, 9), 0.5 / 40000 + 1e-7);
  EXPECT_GT(Manifest(scratch / "set")["png16"]["left_out"]["000000/left_depth.png"], 10)
      << "the wall is farther than 1.64 m";
  // x_left - x_right is positive before a parallel pair, in either picture.
  for (const char* file : {"left_disparity.png", "right_disparity.png"}) {
    const cv::Mat1f disparity = UnpackKittiDisparity(ReadPng16(at / file, 1));
    const double fx = frame.pairs[0].left.view.camera.intrinsics().fx;
    EXPECT_NEAR(disparity(0, 12), fx * 0.1 / 2.0, 1.0 / 512 + 1e-4);
  }
  EXPECT_EQ(UnpackKittiFlow(ReadPng16(at / "left_flow_previous_to_this.png", 3)).dx(9, 9), 0);
}

TEST(DatasetWriter, RefusesAFolderThatHoldsSomething) {
  const Scratch scratch;
  fs::create_directory(scratch / "set");
  DatasetWriter(scratch / "set", Info(), {}).Finish();
  try {
    DatasetWriter(scratch / "set", Info(), {});
    FAIL() << "a second data set over the first";
  } catch (const ResultsError& e) {
    EXPECT_THAT(e.what(), HasSubstr("is not an empty folder; remove it or choose another"));
  }
  std::ofstream(scratch / "file") << "x";
  EXPECT_THROW(DatasetWriter(scratch / "file", Info(), {}), ResultsError);
}

}  // namespace
}  // namespace horopter::scenarios
