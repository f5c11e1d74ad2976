// SPDX-License-Identifier: Apache-2.0
#include "sim/render/renderer.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "sim/render/scene_renderer.h"
#include "sim/render/view_frustum.h"

namespace horopter::sim {
namespace {

/// Lets the context go at the end of a call, so that the next may come from another thread.
class Turn {
 public:
  explicit Turn(SceneRenderer& scene) : scene_(scene) {}
  ~Turn() { scene_.Release(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  SceneRenderer& scene_;
};

void CheckMujoco() {
  constexpr int kSeries = 22;  // 2.2: the display lists' order and drawing that ours repeats
  if (mj_version() / 10 == kSeries) return;
  throw RenderError(fmt::format("MuJoCo {} is loaded; this renderer draws MuJoCo 2.2's scenes only",
                                mj_version()));
}

}  // namespace

std::vector<hardware::FieldError> RendererOptions::Validate() const {
  std::vector<hardware::FieldError> errors;
  if (width < 1) errors.push_back({"renderer.width", std::to_string(width), "must be at least 1"});
  if (height < 1) {
    errors.push_back({"renderer.height", std::to_string(height), "must be at least 1"});
  }
  if (!(std::isfinite(near_m) && near_m > 0)) {
    errors.push_back({"renderer.near_m", std::to_string(near_m), "must be finite and positive"});
  }
  if (!(std::isfinite(far_m) && far_m > near_m)) {
    errors.push_back({"renderer.far_m", std::to_string(far_m), "must be finite and beyond near_m"});
  }
  return errors;
}

Renderer::Renderer(World& world, const RendererOptions& options) : options_(options) {
  hardware::ThrowIfAny(options.Validate());
  CheckMujoco();
  scene_ = std::make_unique<SceneRenderer>(world, options);
  scene_->Release();
}

Renderer::~Renderer() = default;

RenderedView Renderer::Render(const hardware::Pose& X_WC, const hardware::CameraModel& camera,
                              const Products& products, hardware::StageTimes* times) {
  hardware::ThrowIfAny(CheckView(X_WC, camera, {options_.width, options_.height}));
  const Turn turn(*scene_);
  return scene_->Render({X_WC, camera}, products, times);
}

std::vector<RenderedView> Renderer::RenderAll(std::span<const PosedCamera> cameras,
                                              const Products& products,
                                              hardware::StageTimes* times) {
  for (const PosedCamera& view : cameras) {
    hardware::ThrowIfAny(CheckView(view.X_WC, view.camera, {options_.width, options_.height}));
  }
  const Turn turn(*scene_);
  std::vector<RenderedView> seen;
  for (const PosedCamera& view : cameras) seen.push_back(scene_->Render(view, products, times));
  return seen;
}

void Renderer::UploadTextures() {
  const Turn turn(*scene_);
  scene_->UploadTextures();
}

std::string Renderer::gl_renderer() const {
  const Turn turn(*scene_);
  return scene_->gl_renderer();
}

}  // namespace horopter::sim
