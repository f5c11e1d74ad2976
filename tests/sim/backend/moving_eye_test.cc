// SPDX-License-Identifier: Apache-2.0
//
// Heads in a saccade, whose eyes sit off the axes they turn about: images through a shutter against
// brute force, one view rendered for every row at the pose of its instant.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "sim/backend/sim_cameras.h"
#include "sim/camera/row_exposure.h"
#include "sim/textures/paint_textures.h"
#include "tests/sim/backend/spot_board.h"
#include "tests/sim/camera/spots.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using hardware::Pose;
using hardware::Time;

const std::filesystem::path kSource(HOROPTER_SOURCE_DIR);
constexpr double kBegins_rad = -0.4;  // at time zero
constexpr int kReach_px = 10;         // around a spot

/// A camera of a head that turns one axis at its highest speed.
struct Saccade {
  const char* name;
  const char* robot;
  const char* room;  ///< a scene of the robot with things to see
  const char* left;
  const char* right;
  const char* axis;
  double speed_rad_s;
  double focal_px;  ///< at 320 x 240
  ShutterProfile shutter;
  double exposure_s;
  double away_m;    ///< of a board of spots
  double shift_px;  ///< by which the optical centre's way moves some spots, at least
};

void PrintTo(const Saccade& saccade, std::ostream* out) { *out << saccade.name; }

/// A head that turns at a constant speed while nothing else moves.
class TurningHead {
 public:
  TurningHead(const std::filesystem::path& scene, const Saccade& saccade,
              const CameraProfile& profile, bool spots)
      : saccade_(saccade),
        world_(scene),
        exposure_(profile.shutter, profile.exposure, 240),
        config_{.mjcf_camera = {saccade.left, saccade.right},
                .model = {Model(), Model()},
                .profile = profile} {
    if (spots) {
      const SpotBoard board(world_);
    } else {
      PaintTextures(world_.mutable_model(), 1);
    }
    rest_.assign(world_.data().qpos, world_.data().qpos + world_.model().nq);
    SetAxis();
  }

  CameraModel Model() const {
    return CameraModel({320, 240, saccade_.focal_px, saccade_.focal_px, 159.5, 119.5});
  }

  /// Starts to turn; PlaceBoard() comes before.
  hardware::StereoFrame LookAt(Time t) {
    renderer_.emplace(world_, RendererOptions{.width = config_.RenderSize().width,
                                              .height = config_.RenderSize().height});
    clock_.emplace(
        world_, [this] { Step(); }, times_);
    cameras_.emplace(world_, *renderer_, *clock_, config_, times_);
    EXPECT_TRUE(cameras_->Configure().ok());
    EXPECT_TRUE(cameras_->Activate().ok());
    Remember();
    clock_->SleepUntil(t);
    return cameras_->Grab().value();
  }

  /// The board before where an eye looks at `t`, askew, so that depths differ.
  void PlaceBoard(Eye eye, Time t) {
    SetAxis(t);
    X_WT_.setIdentity();
    X_WT_.translation().z() = saccade_.away_m;
    X_WT_.linear() = (Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()) *
                      Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitX()))
                         .toRotationMatrix();
    X_WT_ = world_.X_WCamera(config_.mjcf_camera[eye]) * X_WT_;
    SetAxis(Time{});
    world_.PlaceBody("spot_board", X_WT_);
  }

  /// The poses of an eye at every step so far, around `t`.
  EyeMotion Motion(Eye eye, Time t) const {
    const Pose X_MW = PoseAt(eye, t).inverse();
    EyeMotion motion;
    for (const Place& place : places_) {
      const Pose X_MC = X_MW * place.X_WC[eye];
      motion.Add(hardware::ToSeconds(place.t - t), X_MC.linear(), X_MC.translation());
    }
    return motion;
  }
  Pose PoseAt(Eye eye, Time t) const {
    return std::find_if(places_.begin(), places_.end(), [t](const Place& p) { return p.t == t; })
        ->X_WC[eye];
  }

  /// A view for every row, the mean of several when it is exposed for a time.
  cv::Mat3b BruteForce(Eye eye, Time t) {
    const EyeMotion motion = Motion(eye, t);
    cv::Mat3b image(Model().height(), Model().width()), seen;
    std::optional<double> seen_at;
    for (int row = 0; row < image.rows; ++row) {
      const double middle = exposure_.Middle(row);
      if (seen_at != middle) seen = MeanOver(PoseAt(eye, t), motion, middle);
      seen_at = middle;
      seen.row(row).copyTo(image.row(row));
    }
    return image;
  }

  /// Where a spot is when its row is exposed; nothing when that is outside the image.
  std::optional<Eigen::Vector2d> Expected(const Eigen::Vector3d& p_T, Eye eye, Time t) const {
    double row = 119.5;
    std::optional<Eigen::Vector2d> at;
    for (int i = 0; i < 8; ++i) {
      at = Model().Project(InEye(eye, t, row).inverse() * PoseAt(eye, t).inverse() * X_WT_ * p_T);
      if (!at || at->minCoeff() < 18 || at->x() > 301 || at->y() > 221) return std::nullopt;
      row = at->y();
    }
    return at;
  }

  /// How far a spot would be from where it is if the optical centre rested in its row.
  double ShiftByTranslation(const Eigen::Vector3d& p_T, Eye eye, Time t, double row) const {
    const Eigen::Vector3d p_M = PoseAt(eye, t).inverse() * X_WT_ * p_T;
    Pose X_MC = InEye(eye, t, row);
    const Eigen::Vector2d at = Model().Project(X_MC.inverse() * p_M).value();
    X_MC.translation().setZero();
    return (Model().Project(X_MC.inverse() * p_M).value() - at).norm();
  }

 private:
  struct Place {
    Time t;
    hardware::PerEye<Pose> X_WC;
  };

  /// X_MC when a row is exposed.
  Pose InEye(Eye eye, Time t, double row) const {
    return Motion(eye, t).PoseAt(exposure_.Middle(static_cast<int>(std::lround(row))));
  }
  cv::Mat3b MeanOver(const Pose& X_WM, const EyeMotion& motion, double middle_s) {
    const int instants = exposure_.time_s() > 0 ? 32 : 1;
    cv::Mat3f sum(Model().height(), Model().width(), cv::Vec3f(0, 0, 0));
    for (int i = 0; i < instants; ++i) {
      const double t_s = middle_s + ((i + 0.5) / instants - 0.5) * exposure_.time_s();
      cv::add(sum, renderer_->Render(X_WM * motion.PoseAt(t_s), Model()).bgr, sum, cv::noArray(),
              CV_32F);
    }
    cv::Mat3b mean;
    sum.convertTo(mean, CV_8U, 1.0 / instants);
    return mean;
  }

  void SetAxis(Time t) {
    std::copy(rest_.begin(), rest_.end(), world_.mutable_data().qpos);
    mju_zero(world_.mutable_data().qvel, world_.model().nv);
    const int joint = world_.Id(mjOBJ_JOINT, saccade_.axis);
    world_.mutable_data().qpos[world_.model().jnt_qposadr[joint]] =
        kBegins_rad + saccade_.speed_rad_s * hardware::ToSeconds(t.time_since_epoch());
    world_.Forward();
  }
  void SetAxis() { SetAxis(world_.now()); }
  void Step() {
    world_.Step();
    SetAxis();
    Remember();
  }
  void Remember() {
    places_.push_back({world_.now(),
                       {world_.X_WCamera(config_.mjcf_camera.left),
                        world_.X_WCamera(config_.mjcf_camera.right)}});
  }

  Saccade saccade_;
  World world_;
  RowExposure exposure_;
  SimCamerasConfig config_;
  std::vector<double> rest_;
  Pose X_WT_;
  std::optional<Renderer> renderer_;
  hardware::StageTimes times_;
  std::optional<SimClock> clock_;
  std::optional<SimCameras> cameras_;
  std::vector<Place> places_;
};

class MovingEye : public testing::TestWithParam<Saccade> {
 protected:
  static CameraProfile Profile() {
    CameraProfile profile;
    profile.shutter = GetParam().shutter;
    profile.exposure.time_s = GetParam().exposure_s;
    return profile;
  }
  static std::filesystem::path SpotsScene() {
    return kSource / "tests/sim/backend/data" / ("spots_" + std::string(GetParam().robot) + ".xml");
  }
  static constexpr Time kLook{std::chrono::milliseconds(50)};
};

TEST_P(MovingEye, PointsAreSeenWhereBruteForceSeesThem) {
  const Saccade& saccade = GetParam();
  TurningHead head(SpotsScene(), saccade, Profile(), true);
  head.PlaceBoard(Eye::kLeft, kLook - std::chrono::milliseconds(15));
  const hardware::StereoFrame frame = head.LookAt(kLook);
  const Time t = frame.left.t_capture;
  const cv::Mat3b expected = head.BruteForce(Eye::kLeft, t);
  double worst = 0, shift = 0;
  int seen = 0;
  for (const Eigen::Vector3d& p_T : SpotBoard::Centres()) {
    const auto at = head.Expected(p_T, Eye::kLeft, t);
    if (!at) continue;
    ++seen;
    shift = std::max(shift, head.ShiftByTranslation(p_T, Eye::kLeft, t, at->y()));
    const Eigen::Vector2d there = CentroidAround(expected, *at, kReach_px);
    const double error = (CentroidAround(frame.left.bgr, *at, kReach_px) - there).norm();
    EXPECT_LT(error, 0.1) << at->transpose();
    worst = std::max(worst, error);
  }
  EXPECT_GE(seen, 3);
  EXPECT_GE(shift, saccade.shift_px) << "or else the scene would not show the translation";
  RecordProperty("worst_error_px", std::to_string(worst));
}

/// Share of the pixels that lie out of the range of their neighbourhood in another image.
double Misplaced(const cv::Mat3b& image, const cv::Mat3b& other) {
  constexpr int kReach = 1, kLevels = 8;
  int misplaced = 0;
  for (int y = kReach; y < image.rows - kReach; ++y) {
    for (int x = kReach; x < image.cols - kReach; ++x) {
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        int low = 255, high = 0;
        for (int dx = -kReach; dx <= kReach; ++dx) {
          for (int dy = -kReach; dy <= kReach; ++dy) {
            low = std::min<int>(low, other(y + dy, x + dx)[k]);
            high = std::max<int>(high, other(y + dy, x + dx)[k]);
          }
        }
        inside = inside && image(y, x)[k] >= low - kLevels && image(y, x)[k] <= high + kLevels;
      }
      misplaced += !inside;
    }
  }
  return misplaced / static_cast<double>(image.total());
}

TEST_P(MovingEye, AnyNumberOfThreadsGivesTheSameBits) {
  CameraProfile profile = Profile();
  profile.exposure.time_s = 0.005;
  const auto look = [&] {
    TurningHead head(SpotsScene(), GetParam(), profile, true);
    head.PlaceBoard(Eye::kLeft, kLook - std::chrono::milliseconds(15));
    return head.LookAt(kLook);
  };
  const hardware::StereoFrame many = look();
  cv::setNumThreads(1);
  const hardware::StereoFrame one = look();
  cv::setNumThreads(-1);
  EXPECT_GT(cv::norm(many.left.bgr, cv::NORM_INF), 0);
  for (const Eye eye : hardware::kBothEyes) {
    EXPECT_EQ(cv::norm(many[eye].bgr, one[eye].bgr, cv::NORM_INF), 0);
  }
}

const Saccade kNao{.name = "nao_rolling",
                   .robot = "nao",
                   .room = "nao/workspace.xml",
                   .left = "left_eye",
                   .right = "right_eye",
                   .axis = "neck_pan",
                   .speed_rad_s = 8.27,
                   .focal_px = 280.5,
                   .shutter = {Shutter::kRolling, 0.030},
                   .exposure_s = 0,
                   .away_m = 0.6,
                   .shift_px = 3};

Saccade NaoBlurred() {
  Saccade saccade = kNao;
  saccade.name = "nao_blurred";
  saccade.shutter = {};
  saccade.exposure_s = 0.003;
  saccade.shift_px = 0;  // in the middle of the exposure
  return saccade;
}

Saccade YorickFoveal(const char* name, const ShutterProfile& shutter, double shift_px) {
  return {.name = name,
          .robot = "yorick",
          .room = "yorick/tabletop.xml",
          .left = "left_fovea",
          .right = "right_fovea",
          .axis = "neck_pan",
          .speed_rad_s = 7.5,
          .focal_px = 1303,
          .shutter = shutter,
          .exposure_s = 0,
          .away_m = 1.1,
          .shift_px = shift_px};
}

INSTANTIATE_TEST_SUITE_P(
    Saccades, MovingEye,
    testing::Values(kNao, NaoBlurred(),
                    YorickFoveal("yorick_foveal_interlaced", {Shutter::kInterlaced, 0.020}, 6),
                    YorickFoveal("yorick_foveal_rolling", {Shutter::kRolling, 0.030}, 4)),
    [](const auto& saccade) { return std::string(saccade.param.name); });

class MovingEyeInARoom : public MovingEye {};

TEST_P(MovingEyeInARoom, SeesWhatHidesWhatAsBruteForceDoes) {
  TurningHead head(kSource / "scenes" / GetParam().room, GetParam(), Profile(), false);
  const hardware::StereoFrame frame = head.LookAt(kLook);
  const double share = Misplaced(frame.left.bgr, head.BruteForce(Eye::kLeft, frame.left.t_capture));
  EXPECT_LT(share, 0.001);
  RecordProperty("share_of_misplaced_pixels", std::to_string(share));
}

INSTANTIATE_TEST_SUITE_P(Saccades, MovingEyeInARoom,
                         testing::Values(kNao, YorickFoveal("yorick_foveal_rolling",
                                                            {Shutter::kRolling, 0.030}, 4)),
                         [](const auto& saccade) { return std::string(saccade.param.name); });

}  // namespace
}  // namespace horopter::sim
