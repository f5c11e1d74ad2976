// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/render/one_pass.h"
#include "sim/render/read_back.h"
#include "sim/render/renderer.h"

namespace horopter::sim {

/// A Renderer's inside: an OpenGL context with MuJoCo's objects in it, and the steps of a view.
/// Arguments have been checked. Its context is taken by every call and let go by Release().
class SceneRenderer {
 public:
  /// @throws hardware::ConfigError, RenderError as Renderer does
  SceneRenderer(World& world, const RendererOptions& options);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  RenderedView Render(const PosedCamera& view, const Products& products,
                      hardware::StageTimes* times);
  void UploadTextures();
  std::string gl_renderer();
  void Release() { context_->Release(); }

 private:
  /// mjvScene's buffers, freed even when what comes after them cannot be made.
  struct Scene : mjvScene {
    Scene(const mjModel& model, int capacity);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
  };

  void CheckLimits() const;
  void MakeMujocoContext();
  /// Takes the world's geoms and lights as they are now, seen by `camera`.
  void UpdateScene(const mjvGLCamera& camera);
  /// Whether mjr_render has to make the colours.
  bool LeavesColoursToMujoco() const;
  void DrawColours(cv::Size size, hardware::StageTimes* times);
  void DrawNumbers(cv::Size size, hardware::StageTimes* times);
  void Fetch(cv::Size size, const Products& products, RenderedView& view);
  /// Runs a step, and when its time is wanted waits until OpenGL has done it.
  template <typename Step>
  void Book(hardware::StageTimes* times, const char* stage, Step&& step);
  /// Geom id of each number that OnePass writes, -1 for all that it does not.
  std::vector<int> GeomOfNumber() const;

  World& world_;
  RendererOptions options_;
  std::unique_ptr<GlContext> context_;
  GlFunctions gl_;
  mjvOption option_;
  Scene scene_;
  mjrContext mujoco_{};
  std::unique_ptr<OnePass> one_pass_;
  ReadBack read_back_;
};

}  // namespace horopter::sim
