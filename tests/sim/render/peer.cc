// SPDX-License-Identifier: Apache-2.0
#include "peer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace horopter::sim::testing {
namespace {

constexpr int kShownGroups = 3;

mjvOption GeomsOnly() {
  mjvOption option;
  mjv_defaultOption(&option);
  std::fill(std::begin(option.sitegroup), std::end(option.sitegroup), mjtByte{0});
  for (int group = 0; group < mjNGROUP; ++group) option.geomgroup[group] = group < kShownGroups;
  for (mjtByte& flag : option.flags) flag = 0;
  option.flags[mjVIS_TEXTURE] = option.flags[mjVIS_STATIC] = 1;
  return option;
}

}  // namespace

Peer::Peer(World& world, const RendererOptions& options)
    : world_(world),
      options_(options),
      context_(CreateGlContext(options.gl_backend, 1, 1)),
      option_(GeomsOnly()) {
  context_->MakeCurrent();
  mjModel model = world.model();
  model.vis.global.offwidth = options.width;
  model.vis.global.offheight = options.height;
  model.vis.quality.offsamples = 0;
  mjv_defaultCamera(&camera_);
  mjv_defaultPerturb(&perturb_);
  mjv_defaultScene(&scene_);
  mjv_makeScene(&world.model(), &scene_, world.model().ngeom + 100);
  mjr_defaultContext(&mujoco_);
  mjr_makeContext(&model, &mujoco_, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &mujoco_);
  scene_.flags[mjRND_SHADOW] = options.shadows;
  context_->Release();
}

Peer::~Peer() {
  context_->MakeCurrent();
  mjr_freeContext(&mujoco_);
  mjv_freeScene(&scene_);
}

void Peer::SetCamera(const PosedCamera& view) {
  const hardware::Intrinsics& in = view.camera.intrinsics();
  const double pixel_m = options_.near_m / in.fx;
  mjvGLCamera& eye = scene_.camera[0];
  for (int k = 0; k < 3; ++k) {
    eye.pos[k] = static_cast<float>(view.X_WC.translation()[k]);
    eye.forward[k] = static_cast<float>(view.X_WC.linear()(k, 2));
    eye.up[k] = static_cast<float>(-view.X_WC.linear()(k, 1));
  }
  eye.frustum_center = static_cast<float>((in.width / 2.0 - 0.5 - in.cx) * pixel_m);
  eye.frustum_top = static_cast<float>((in.cy + 0.5) * pixel_m);
  eye.frustum_bottom = static_cast<float>((in.cy + 0.5 - in.height) * pixel_m);
  eye.frustum_near = static_cast<float>(options_.near_m);
  eye.frustum_far = static_cast<float>(options_.far_m);
  scene_.camera[1] = eye;
}

RenderedView Peer::Render(const PosedCamera& view, const Products& products) {
  const mjrRect image{0, 0, view.camera.width(), view.camera.height()};
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  rgb_.resize(3 * pixels);
  depth_.resize(pixels);
  RenderedView seen;
  context_->MakeCurrent();
  // Infinite planes are centred on the camera of the update before: twice, as for a still camera.
  SetCamera(view);
  mjv_updateScene(&world_.model(), &world_.mutable_data(), &option_, &perturb_, &camera_, mjCAT_ALL,
                  &scene_);
  SetCamera(view);
  if (products.rgb) {
    mjr_render(image, &scene_, &mujoco_);
    mjr_readPixels(rgb_.data(), products.depth ? depth_.data() : nullptr, image, &mujoco_);
  }
  if (products.rgb) {
    const cv::Mat3b rgb(image.height, image.width, reinterpret_cast<cv::Vec3b*>(rgb_.data()));
    cv::cvtColor(rgb, seen.bgr, cv::COLOR_RGB2BGR);
    cv::flip(seen.bgr, seen.bgr, 0);
  }
  if (products.ids || !products.rgb) Ids(image, !products.rgb, seen);
  if (products.depth) seen.depth = Depth(image);
  context_->Release();
  return seen;
}

cv::Mat1f Peer::Depth(const mjrRect& image) const {
  const double nearest = 1 / options_.near_m, farthest = 1 / options_.far_m;
  cv::Mat1f depth(image.height, image.width);
  for (int y = 0; y < image.height; ++y) {
    const float* row = depth_.data() + static_cast<std::size_t>(image.height - 1 - y) * image.width;
    for (int x = 0; x < image.width; ++x) {
      depth(y, x) = row[x] >= 1 ? std::numeric_limits<float>::infinity()
                                : static_cast<float>(1 / (nearest + row[x] * (farthest - nearest)));
    }
  }
  return depth;
}

void Peer::Ids(const mjrRect& image, bool with_depth, RenderedView& view) {
  scene_.flags[mjRND_SEGMENT] = scene_.flags[mjRND_IDCOLOR] = 1;
  mjr_render(image, &scene_, &mujoco_);
  mjr_readPixels(rgb_.data(), with_depth ? depth_.data() : nullptr, image, &mujoco_);
  scene_.flags[mjRND_SEGMENT] = scene_.flags[mjRND_IDCOLOR] = 0;
  std::vector<int> geom_of(static_cast<std::size_t>(scene_.ngeom) + 1, -1);
  for (int i = 0; i < scene_.ngeom; ++i) {
    const mjvGeom& geom = scene_.geoms[i];
    if (geom.objtype == mjOBJ_GEOM) geom_of[static_cast<std::size_t>(geom.segid) + 1] = geom.objid;
  }
  view.ids.create(image.height, image.width);
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* row =
        rgb_.data() + 3 * static_cast<std::size_t>(image.height - 1 - y) * image.width;
    for (int x = 0; x < image.width; ++x, row += 3) {
      const auto number = static_cast<std::size_t>(row[0] | row[1] << 8 | row[2] << 16);
      view.ids(y, x) = number < geom_of.size() ? geom_of[number] : -1;
    }
  }
}

}  // namespace horopter::sim::testing
