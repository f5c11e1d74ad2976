// SPDX-License-Identifier: Apache-2.0
#include "bench_scene.h"

#include <Eigen/Geometry>
#include <cmath>

#include "sim/textures/paint_textures.h"

namespace horopter::sim::testing {

std::filesystem::path PathOf(const BenchSceneName& scene) {
  return std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes" / scene.file;
}

std::vector<BenchSceneName> BenchScenes() {
  std::vector<BenchSceneName> existing;
  for (const BenchSceneName& scene :
       {BenchSceneName{"koala", "koala/room.xml", "left", "right"},
        BenchSceneName{"nao", "nao/workspace.xml", "left_eye", "right_eye"},
        BenchSceneName{"yorick", "yorick/tabletop.xml", "left_peripheral", "right_peripheral"}}) {
    if (std::filesystem::exists(PathOf(scene))) existing.push_back(scene);
  }
  return existing;
}

BenchScene::BenchScene(const BenchSceneName& scene)
    : name_(scene), world_(std::make_unique<World>(PathOf(scene))) {
  PaintTextures(world_->mutable_model(), 1);
  world_->Forward();
  start_ = world_->data().qpos[0];
}

void BenchScene::Next() {
  constexpr double kStep = 1e-3;
  ++frame_;
  world_->mutable_data().qpos[0] = start_ + kStep * (frame_ % 10);
  world_->Forward();
}

std::array<PosedCamera, 2> BenchScene::Pair(int width, int height) const {
  const double turned = 0.1 * M_PI / 180 * (frame_ % 10);
  const auto camera = hardware::CameraModel::FromHorizontalFov(width, height, 60 * M_PI / 180);
  const auto at = [&](const std::string& name) {
    hardware::Pose X_WC = world_->X_WCamera(name);
    X_WC.rotate(Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitY()));
    return PosedCamera{X_WC, camera};
  };
  return {at(name_.left), at(name_.right)};
}

}  // namespace horopter::sim::testing
