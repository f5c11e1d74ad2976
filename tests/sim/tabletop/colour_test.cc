// SPDX-License-Identifier: Apache-2.0
// What a system that goes by colour alone would take for what.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "sim/render/renderer.h"
#include "sim/textures/paint_textures.h"
#include "tests/sim/tabletop/tabletop_scene.h"

namespace horopter::sim {
namespace {

constexpr int kBins = 18;  // of 10 deg
using Hues = std::array<double, kBins>;
constexpr std::array<const char*, 9> kObjects{"sugar",  "rice",    "raisins", "soda_can", "cup",
                                              "bottle", "toy_car", "tiger",   "giraffe"};

/// Shares of the saturated pixels of every object, each shown alone, its best side forward.
std::map<std::string, Hues> HuesOfObjects() {
  World world(YorickScenes() / "tabletop.xml");
  PaintTextures(world.mutable_model(), 1);
  Renderer renderer(world, {});
  const auto camera = hardware::CameraModel::FromHorizontalFov(320, 240, 0.5);
  std::map<std::string, Hues> all;
  for (const char* name : kObjects) {
    const int body = mj_name2id(&world.model(), mjOBJ_BODY, name);
    const int mocap = world.model().body_mocapid[body];
    double* at = world.mutable_data().mocap_pos + 3 * mocap;
    double* turned = world.mutable_data().mocap_quat + 4 * mocap;
    const std::array<double, 3> before{at[0], at[1], at[2]};
    at[0] = 0.9, at[1] = 0, at[2] = 1.6;  // in the air, before what stands on the table
    turned[0] = turned[1] = turned[2] = 0, turned[3] = 1;
    world.Forward();
    hardware::Pose X_WC = hardware::Pose::Identity();
    X_WC.linear() = hardware::OpticalToBody();
    X_WC.translation() << 0.3, 0, 1.7;
    const auto view = renderer.Render(X_WC, camera, {.rgb = true, .depth = false, .ids = true});
    cv::Mat3b hsv;
    cv::cvtColor(view.bgr, hsv, cv::COLOR_BGR2HSV);
    Hues hues{};
    double pixels = 0;
    for (int y = 0; y < hsv.rows; ++y) {
      for (int x = 0; x < hsv.cols; ++x) {
        const int geom = view.ids(y, x);
        if (geom < 0 || world.model().geom_bodyid[geom] != body) continue;
        if (hsv(y, x)[1] < 60 || hsv(y, x)[2] < 30) continue;
        ++hues[static_cast<std::size_t>(hsv(y, x)[0] / 10)];
        ++pixels;
      }
    }
    EXPECT_GT(pixels, 300) << name;
    for (double& share : hues) share /= pixels;
    all[name] = hues;
    std::copy(before.begin(), before.end(), at);
  }
  return all;
}

/// 1 of equal histograms, 0 of those that share no hue.
double Overlap(const Hues& a, const Hues& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kBins; ++i) sum += std::min(a[i], b[i]);
  return sum;
}

TEST(ObjectColours, TheTwoAnimalsAreNearestToEachOtherAndTheCarIsAlone) {
  const auto hues = HuesOfObjects();
  const double animals = Overlap(hues.at("tiger"), hues.at("giraffe"));
  EXPECT_GT(animals, 0.6);
  for (const auto& [name, of_object] : hues) {
    if (name != "tiger" && name != "giraffe") {
      EXPECT_LT(Overlap(hues.at("tiger"), of_object), animals) << name;
      EXPECT_LT(Overlap(hues.at("giraffe"), of_object), animals) << name;
    }
    if (name != "toy_car") {
      EXPECT_LT(Overlap(hues.at("toy_car"), of_object), 0.3) << name;
    }
  }
  const Hues& car = hues.at("toy_car");
  EXPECT_GT(*std::max_element(car.begin(), car.end()), 0.8) << "one bold colour";
}

}  // namespace
}  // namespace horopter::sim
