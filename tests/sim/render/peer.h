// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "sim/render/gl_context.h"
#include "sim/render/renderer.h"

namespace horopter::sim::testing {

/// Colour, depth and ids by MuJoCo's own calls alone, as a user would write it: for each camera
/// mjv_updateScene, mjr_render, mjr_readPixels of colour and depth, then a second mjr_render with
/// the segmentation flags for the ids.
///
/// Depth is that of the colour pass, where the sky has one and transparent geoms have none; without
/// colours it is that of the segmentation pass, as a Renderer's.
class Peer {
 public:
  Peer(World& world, const RendererOptions& options);
  ~Peer();
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  RenderedView Render(const PosedCamera& view, const Products& products);

 private:
  void SetCamera(const PosedCamera& view);
  void Ids(const mjrRect& image, bool with_depth, RenderedView& view);
  cv::Mat1f Depth(const mjrRect& image) const;

  World& world_;
  RendererOptions options_;
  std::unique_ptr<GlContext> context_;
  mjvOption option_;
  mjvCamera camera_;
  mjvPerturb perturb_;
  mjvScene scene_;
  mjrContext mujoco_;
  std::vector<unsigned char> rgb_;
  std::vector<float> depth_;
};

}  // namespace horopter::sim::testing
