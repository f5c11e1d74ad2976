// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/camera_yaml.h"

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <vector>

#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using hardware::CameraModel;
using hardware::Pose;
using testing::HasSubstr;

StereoViews Views() {
  Pose X_WL = Pose::Identity(), X_WR = Pose::Identity();
  X_WL.translation() << 0.1, 0.2, 1.0 / 3;
  X_WL.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  X_WR.translation() << 0.13, 0.15, 0.3;
  X_WR.linear() = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  const CameraModel left({640, 480, 512, 560.1, 320.4, 239.8},
                         {.k1 = -0.21, .k2 = 0.07, .p1 = 1e-3, .p2 = -2e-4, .k3 = 0.01});
  return {{X_WL, left}, {X_WR, CameraModel::FromHorizontalFov(320, 240, 1)}};
}

TEST(CameraYaml, ReadsBack) {
  const StereoViews views = Views();
  const StereoViews read = DecodeCameras(EncodeCameras(views), "cameras.yaml");
  EXPECT_EQ(read.left.camera.width(), 640);
  EXPECT_EQ(read.right.camera.height(), 240);
  EXPECT_NEAR(read.left.camera.intrinsics().fy, 560.1, 1e-12);
  EXPECT_NEAR(read.left.camera.intrinsics().cx, 320.4, 1e-12);
  EXPECT_NEAR(read.left.camera.distortion().k3, 0.01, 1e-17);
  EXPECT_NEAR(read.left.camera.distortion().p2, -2e-4, 1e-18);
  EXPECT_TRUE(read.left.X_WC.isApprox(views.left.X_WC, 1e-14));
  EXPECT_TRUE(read.right.X_WC.isApprox(views.right.X_WC, 1e-14));
}

/// As a user would: read with cv::FileStorage, project with cv::projectPoints.
TEST(CameraYaml, OpenCvProjectsWithItAsWeDo) {
  const StereoViews views = Views();
  const cv::FileStorage file(EncodeCameras(views), cv::FileStorage::READ | cv::FileStorage::MEMORY);
  cv::Mat K1, D1, R, T;
  file["K1"] >> K1;
  file["D1"] >> D1;
  file["R"] >> R;
  file["T"] >> T;
  const Eigen::Vector3d p_L(0.2, -0.1, 1.7);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{p_L.x(), p_L.y(), p_L.z()}}, cv::Vec3d(), cv::Vec3d(),
                    K1, D1, pixels);
  const Eigen::Vector2d ours = *views.left.camera.Project(p_L);
  EXPECT_NEAR(pixels[0].x, ours.x(), 1e-9);
  EXPECT_NEAR(pixels[0].y, ours.y(), 1e-9);
  const Eigen::Vector3d p_R = views.right.X_WC.inverse() * views.left.X_WC * p_L;
  const cv::Mat theirs = R * (cv::Mat1d(3, 1) << p_L.x(), p_L.y(), p_L.z()) + T;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(theirs.at<double>(i), p_R[i], 1e-12);
}

TEST(CameraYaml, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& yaml) {
    return FormatComplaint([&] { DecodeCameras(yaml, "cameras.yaml"); });
  };
  const auto replaced = [](std::string from, std::string to) {
    std::string yaml = EncodeCameras(Views());
    const auto at = yaml.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return yaml.replace(at, from.size(), to);
  };
  EXPECT_THAT(complaint(""), HasSubstr("cameras.yaml: no YAML of OpenCV's"));
  EXPECT_THAT(complaint("hello"), HasSubstr("cameras.yaml: no YAML of OpenCV's"));
  EXPECT_THAT(complaint(replaced("K2:", "K3:")), HasSubstr("'K2' is not a 3x3 matrix"));
  EXPECT_THAT(complaint(replaced("cols: 5", "cols: 4")), HasSubstr("cameras.yaml: "));
  EXPECT_THAT(complaint(replaced("512.", "-512.")), HasSubstr("camera 1: camera.fx"));
  EXPECT_THAT(complaint(replaced("640", "0")), HasSubstr("camera.width"));
  EXPECT_THAT(complaint(replaced("T: !!", "Q: !!")), HasSubstr("'T' is not a 3x1 matrix"));
  const std::string whole = EncodeCameras(Views());
  EXPECT_NE(complaint(whole.substr(0, whole.size() / 2)), "");
  std::string other = EncodeCameras(Views());
  StereoViews moved = Views();
  moved.right.X_WC.translation().x() += 0.01;
  const std::string their = EncodeCameras(moved);
  EXPECT_THAT(complaint(other.substr(0, other.find("\nR:")) + their.substr(their.find("\nR:"))),
              HasSubstr("R and T contradict"));
}

}  // namespace
}  // namespace horopter::scenarios
