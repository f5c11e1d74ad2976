// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/paint_textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "hardware/types/config_error.h"
#include "sim/render/renderer.h"

namespace horopter::sim {
namespace {

std::string SceneWith(const std::string& custom) {
  return R"(<mujoco><visual><headlight active="0"/></visual><asset>
    <texture name="crate" type="cube" builtin="flat" width="64" height="384"/>
    <texture name="sheet" type="2d" builtin="flat" width="32" height="64" rgb1="0.2 0.4 0.6"/>
    <material name="crate" texture="crate" specular="0"/>
    <material name="sheet" texture="sheet" specular="0"/></asset>
    <custom>)" +
         custom + R"(</custom>
    <worldbody><light directional="true" dir="0 0 -1" diffuse="0 0 0" specular="0 0 0"
                      ambient="0.9 0.9 0.9" castshadow="false"/>
      <geom type="box" size="0.5 0.25 0.125" material="crate"/>
      <geom type="plane" size="0.5 0.5 1" pos="0 0 -5" material="sheet"/></worldbody></mujoco>)";
}

const char* const kCrate = R"(<text name="texture:crate" data="plaster,size_m=1x0.5x0.25"/>)";

/// A camera that looks at the origin from `distance` along `out`, with `up` upwards.
hardware::Pose LookingAtOrigin(const Eigen::Vector3d& out, const Eigen::Vector3d& up,
                               double distance) {
  hardware::Pose X = hardware::Pose::Identity();
  X.linear().col(2) = -out;
  X.linear().col(1) = -up;
  X.linear().col(0) = X.linear().col(1).cross(X.linear().col(2));
  X.translation() = distance * out;
  return X;
}

/// The part of a centred face's image that shows the face, scaled to the picture's size.
cv::Mat FaceAsSeen(Renderer& renderer, const hardware::Pose& X_WC, double distance, double width_m,
                   double height_m) {
  const auto camera = hardware::CameraModel::FromHorizontalFov(401, 401, 0.9);
  const cv::Mat bgr = renderer.Render(X_WC, camera).bgr;
  const double scale = camera.intrinsics().fx / distance;
  cv::Mat face;
  cv::getRectSubPix(bgr,
                    cv::Size(static_cast<int>(width_m * scale), static_cast<int>(height_m * scale)),
                    cv::Point2f(200, 200), face);
  cv::resize(face, face, {64, 64}, 0, 0, cv::INTER_AREA);
  return face;
}

double Correlation(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat coarse_a, coarse_b, score;
  cv::GaussianBlur(a, coarse_a, {7, 7}, 0);
  cv::GaussianBlur(b, coarse_b, {7, 7}, 0);
  cv::matchTemplate(coarse_a, coarse_b, score, cv::TM_CCOEFF_NORMED);
  return score.at<float>(0, 0);
}

TEST(PaintTextures, EveryFaceOfABoxShowsItsPictureUpright) {
  const auto world = World::FromXml(SceneWith(kCrate));
  PaintTextures(world->mutable_model(), 3);
  const auto pictures = PaintPictures(world->model(), 3);
  ASSERT_EQ(pictures.size(), 6U);
  Renderer renderer(*world);
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  struct Face {
    Eigen::Vector3d out, up;
    double width_m, height_m, half_depth_m;
  };
  const Face faces[] = {{x, z, 0.5, 0.25, 0.5}, {-x, z, 0.5, 0.25, 0.5}, {y, z, 1, 0.25, 0.25},
                        {-y, z, 1, 0.25, 0.25}, {z, y, 1, 0.5, 0.125},   {-z, -y, 1, 0.5, 0.125}};
  for (int i = 0; i < 6; ++i) {
    const Face& f = faces[i];
    const double distance = 1.3;
    const auto X_WC = LookingAtOrigin(f.out, f.up, distance + f.half_depth_m);
    const cv::Mat seen = FaceAsSeen(renderer, X_WC, distance, f.width_m, f.height_m);
    EXPECT_GT(Correlation(seen, pictures[i].bgr), 0.9) << pictures[i].name;
    for (const int flip : {0, 1, -1}) {
      cv::Mat flipped;
      cv::flip(pictures[i].bgr, flipped, flip);
      EXPECT_LT(Correlation(seen, flipped), 0.8) << pictures[i].name << " flip " << flip;
    }
  }
}

TEST(PaintTextures, ChessboardCornersAreSeenWhereTheBoardSaysTheyAre) {
  World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/chessboard_room.xml");
  PaintTextures(world.mutable_model(), 1);
  Renderer renderer(world);
  const auto camera = hardware::CameraModel::FromHorizontalFov(640, 480, M_PI / 3);
  const hardware::Pose X_WC = world.X_WCamera("left");
  const hardware::Pose X_CBoard = X_WC.inverse() * world.X_WBody("board");
  cv::Mat grey;
  cv::cvtColor(renderer.Render(X_WC, camera).bgr, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::Point2f> expected;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 8; ++column) {
      const Eigen::Vector3d p_Board(0, 0.04 * (3.5 - column), 0.04 * (2.5 - row));
      const auto pixel = camera.Project(X_CBoard * p_Board);
      ASSERT_TRUE(pixel.has_value());
      expected.emplace_back(pixel->x(), pixel->y());
    }
  }
  std::vector<cv::Point2f> found = expected;
  cv::cornerSubPix(grey, found, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT, 50, 0});
  double squares = 0;
  cv::Point2f mean(0, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const cv::Point2f error = found[i] - expected[i];
    squares += error.dot(error) / found.size();
    mean += error / static_cast<float>(found.size());
  }
  EXPECT_LT(std::sqrt(squares), 0.25);  // one sample per pixel, bilinear texture
  EXPECT_LT(std::hypot(mean.x, mean.y), 0.1);
}

TEST(PaintTextures, LeavesUndeclaredTexturesAlone) {
  const auto world = World::FromXml(SceneWith(kCrate));
  const mjModel& model = world->model();
  const int sheet = world->Id(mjOBJ_TEXTURE, "sheet");
  const std::string before(reinterpret_cast<const char*>(model.tex_rgb + model.tex_adr[sheet]),
                           3 * 32 * 64);
  PaintTextures(world->mutable_model(), 1);
  EXPECT_EQ(std::memcmp(model.tex_rgb + model.tex_adr[sheet], before.data(), before.size()), 0);
}

TEST(PaintTextures, ATexturesPictureDoesNotDependOnOthers) {
  const std::string sheet = R"(<text name="texture:sheet" data="marble,size_m=1x1"/>)";
  const auto alone = World::FromXml(SceneWith(kCrate));
  const auto both = World::FromXml(SceneWith(sheet + kCrate));
  const auto a = PaintPictures(alone->model(), 9);
  const auto b = PaintPictures(both->model(), 9);
  ASSERT_EQ(b.size(), 7U);
  EXPECT_EQ(b[1].name, a[0].name);
  EXPECT_EQ(cv::norm(a[0].bgr, b[1].bgr, cv::NORM_INF), 0);
}

TEST(PaintTextures, BadDeclarationsNameTheTexture) {
  const auto message = [](const std::string& custom) -> std::string {
    const auto world = World::FromXml(SceneWith(custom));
    try {
      PaintTextures(world->mutable_model(), 1);
    } catch (const hardware::ConfigError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message(R"(<text name="texture:crat" data="wood,size_m=1x1x1"/>)").find("texture:crat"),
            std::string::npos);
  EXPECT_NE(message(R"(<text name="texture:crate" data="wood,size_m=1x1"/>)").find("XxYxZ"),
            std::string::npos);
  EXPECT_NE(message(R"(<text name="texture:sheet" data="wood,size_m=1x1x1"/>)").find("WxH"),
            std::string::npos);
}

}  // namespace
}  // namespace horopter::sim
