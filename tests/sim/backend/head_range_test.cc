// SPDX-License-Identifier: Apache-2.0
//
// Every head of the papers through its range: where known points are seen in rendered images
// against what the stack knows, the head's geometry and the camera model.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "control/kinematics/head_kinematics.h"
#include "scenarios/format/robot_description.h"
#include "sim/camera/eye_camera.h"
#include "sim/random/random_stream.h"
#include "sim/render/renderer.h"
#include "sim/world/world.h"
#include "tests/sim/backend/spot_board.h"
#include "tests/sim/camera/spots.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using hardware::HeadAngles;
using hardware::Pose;

const std::filesystem::path kSource(HOROPTER_SOURCE_DIR);

struct Head {
  const char* robot;
  const char* pair;
};

void PrintTo(const Head& head, std::ostream* out) { *out << head.robot << " " << head.pair; }

class HeadRange : public testing::TestWithParam<Head> {
 protected:
  HeadRange()
      : robot_(
            scenarios::LoadRobotDescription(kSource / "scenes" / GetParam().robot / "robot.yaml")),
        pair_(robot_.Cameras(GetParam().pair)),
        world_(kSource / "tests/sim/backend/data" /
               (std::string("spots_") + GetParam().robot + ".xml")),
        board_(world_) {}

  /// The native camera with a lens that distorts.
  CameraModel Camera() const {
    LensProfile lens{.distortion = {.k1 = -0.18, .k2 = 0.05, .p1 = 0.002, .p2 = -0.0015},
                     .principal_point_offset_px = {7.3, -4.9},
                     .pixel_aspect = 1.03};
    return lens.Model(pair_.width_px, pair_.height_px, pair_.horizontal_fov_deg * M_PI / 180);
  }

  /// The ends of the range, its middle, and places between.
  std::vector<HeadAngles> Poses() const {
    RandomStream random(1, "poses");
    std::vector<HeadAngles> poses;
    for (int i = 0; i < 6; ++i) {
      hardware::HeadAxisArray angles{};
      for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
        const hardware::AxisLimits& limits = robot_.head_limits[axis];
        const double share = i == 0 ? 0 : i == 1 ? 1 : i == 2 ? 0.5 : random.Uniform(0, 1);
        angles[axis] = limits.min_rad + share * (limits.max_rad - limits.min_rad);
      }
      poses.push_back(hardware::FromArray(angles));
    }
    return poses;
  }

  void MoveTo(const HeadAngles& angles) {
    const auto values = hardware::ToArray(angles);
    for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
      if (!robot_.head_limits[axis].exists()) continue;
      const int joint = world_.Id(mjOBJ_JOINT, hardware::kHeadAxisNames[axis]);
      world_.mutable_data().qpos[world_.model().jnt_qposadr[joint]] = values[axis];
    }
    world_.Forward();
  }

  /// Places the board before where the eye should be, a little askew, so that it fills the image.
  Pose PlaceBoard(const Pose& X_WC, double horizontal_fov_rad) {
    Pose X_CT = Pose::Identity();
    X_CT.translation().z() = 0.55 / std::tan(horizontal_fov_rad / 2);
    X_CT.linear() = (Eigen::AngleAxisd(0.15, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    world_.PlaceBody("spot_board", X_WC * X_CT);
    return X_WC * X_CT;
  }

  const scenarios::RobotDescription robot_;
  const scenarios::CameraPairDescription pair_;
  World world_;
  SpotBoard board_;
};

TEST_P(HeadRange, KnownPointsAreSeenWhereHeadGeometryAndCameraModelSay) {
  constexpr double kTolerance_px = 0.05, kBorder_px = 14;
  const hardware::HeadGeometry geometry = robot_.GeometryOf(pair_);
  const CameraModel camera = Camera();
  EyeCamera eye_camera(camera, {}, 1, "left");
  const CameraModel pinhole = eye_camera.View({});
  Renderer renderer(world_, {.width = pinhole.width(), .height = pinhole.height()});
  double worst = 0;
  for (const HeadAngles& angles : Poses()) {
    MoveTo(angles);
    for (const Eye eye : hardware::kBothEyes) {
      const Pose X_WC = world_.X_WBody("base") * control::EyePose(geometry, angles, eye);
      const Pose X_WT = PlaceBoard(X_WC, camera.horizontal_fov_rad());
      const std::string& name = eye == Eye::kLeft ? pair_.left : pair_.right;
      const cv::Mat3b view = renderer.Render(world_.X_WCamera(name), pinhole).bgr;
      const cv::Mat3b image = eye_camera.Develop(view, {}, 0);
      int seen = 0;
      for (const Eigen::Vector3d& p_T : SpotBoard::Centres()) {
        const auto expected = camera.Project(X_WC.inverse() * X_WT * p_T);
        if (!expected || expected->minCoeff() < kBorder_px ||
            expected->x() > camera.width() - kBorder_px ||
            expected->y() > camera.height() - kBorder_px) {
          continue;
        }
        ++seen;
        const double error = (CentroidAround(image, *expected, 10) - *expected).norm();
        EXPECT_LT(error, kTolerance_px) << name << " at " << expected->transpose();
        worst = std::max(worst, error);
      }
      EXPECT_GT(seen, 40) << name;
    }
  }
  RecordProperty("worst_error_px", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Heads, HeadRange,
                         testing::Values(Head{"koala", "eyes"}, Head{"nao", "eyes"},
                                         Head{"nao", "tele"}, Head{"yorick", "peripheral"},
                                         Head{"yorick", "foveal"}),
                         [](const auto& head) {
                           return std::string(head.param.robot) + "_" + head.param.pair;
                         });

}  // namespace
}  // namespace horopter::sim
