// SPDX-License-Identifier: Apache-2.0
#include "sim/render/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "sim/render/view_frustum.h"

namespace horopter::sim {
namespace {

constexpr int kVisibleGeomGroups = 3;  // groups 0, 1, 2
constexpr int kSpareGeoms = 64;        // mjvScene slots beyond the model's geoms
constexpr int kMostNumbers = 1 << 16;  // in a pixel's alpha and stencil
constexpr int kSupersampling = 2;      // samples along each side of a pixel

/// Only geoms, only those that cameras are meant to see.
mjvOption CameraOption() {
  mjvOption option;
  mjv_defaultOption(&option);
  for (int group = 0; group < mjNGROUP; ++group) {
    option.geomgroup[group] = group < kVisibleGeomGroups;
    option.sitegroup[group] = option.jointgroup[group] = option.tendongroup[group] = 0;
    option.actuatorgroup[group] = option.skingroup[group] = 0;
  }
  std::fill(std::begin(option.flags), std::end(option.flags), mjtByte{0});
  option.flags[mjVIS_TEXTURE] = option.flags[mjVIS_STATIC] = 1;
  return option;
}

}  // namespace

SceneRenderer::Scene::Scene(const mjModel& model, int capacity) {
  mjv_defaultScene(this);
  mjv_makeScene(&model, this, capacity);
  nskin = 0;  // skins are decoration
}

SceneRenderer::Scene::~Scene() { mjv_freeScene(this); }

SceneRenderer::SceneRenderer(World& world, const RendererOptions& options)
    : world_(world),
      options_(options),
      context_(CreateGlContext(options.gl_backend, 1, 1)),
      gl_((context_->MakeCurrent(), *context_)),
      option_(CameraOption()),
      scene_(world.model(), world.model().ngeom + kSpareGeoms),
      read_back_(gl_) {
  CheckLimits();
  MakeMujocoContext();
  scene_.flags[mjRND_SHADOW] = options.shadows;
  one_pass_ = std::make_unique<OnePass>(gl_, mujoco_);
}

SceneRenderer::~SceneRenderer() {
  try {
    context_->MakeCurrent();
    one_pass_.reset();
    mjr_freeContext(&mujoco_);
  } catch (const std::runtime_error&) {
    // Without its context there is nothing left to free in GL.
  }
}

void SceneRenderer::CheckLimits() const {
  GLint renderbuffer = 0;
  std::array<GLint, 2> viewport{};
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  const int samples = options_.supersample ? kSupersampling : 1;
  std::vector<hardware::FieldError> errors;
  const auto check = [&](const char* field, int value, int limit) {
    if (value <= limit) return;
    errors.push_back(
        {field, std::to_string(value),
         fmt::format("must be at most {}, the limit of {}", limit, context_->gl_renderer())});
  };
  check("renderer.width", options_.width, std::min(renderbuffer, viewport[0]) / samples);
  check("renderer.height", options_.height, std::min(renderbuffer, viewport[1]) / samples);
  hardware::ThrowIfAny(std::move(errors));
  if (world_.model().ngeom + kSpareGeoms >= kMostNumbers) {
    throw RenderError(
        fmt::format("{} geoms are more than can be told apart in an image", world_.model().ngeom));
  }
}

void SceneRenderer::MakeMujocoContext() {
  mjr_defaultContext(&mujoco_);
  // MuJoCo takes the buffer's size and samples from the model. A multisampled depth or id would be
  // a blend of several surfaces.
  mjModel model = world_.model();
  const int samples = options_.supersample ? kSupersampling : 1;
  model.vis.global.offwidth = options_.width * samples;
  model.vis.global.offheight = options_.height * samples;
  model.vis.quality.offsamples = 0;
  try {
    mjr_makeContext(&model, &mujoco_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &mujoco_);
  } catch (const PhysicsError& e) {
    throw RenderError(fmt::format("cannot render with {}: {}", context_->gl_renderer(), e.what()));
  }
}

void SceneRenderer::UpdateScene(const mjvGLCamera& camera) {
  // In mono MuJoCo averages both cameras. They come first: infinite planes are centred on them.
  scene_.camera[0] = scene_.camera[1] = camera;
  scene_.ngeom = 0;
  mjv_addGeoms(&world_.model(), &world_.mutable_data(), &option_, nullptr, mjCAT_ALL, &scene_);
  mjv_makeLights(&world_.model(), &world_.mutable_data(), &scene_);
}

bool SceneRenderer::LeavesColoursToMujoco() const {
  return options_.shading == Shading::kMujoco || !OnePass::CannotDraw(scene_).empty();
}

template <typename Step>
void SceneRenderer::Book(hardware::StageTimes* times, const char* stage, Step&& step) {
  if (times == nullptr) return step();
  times->Measure(stage, [&] {
    step();
    gl_.Finish();  // llvmpipe would draw while the next stage is timed
  });
}

void SceneRenderer::DrawColours(cv::Size size, hardware::StageTimes* times) {
  if (LeavesColoursToMujoco()) {
    Book(times, "render", [&] { mjr_render({0, 0, size.width, size.height}, &scene_, &mujoco_); });
    return;
  }
  Book(times, "shadow_maps", [&] { one_pass_->UpdateShadows(scene_); });
  Book(times, "render", [&] { one_pass_->Draw(scene_, size, true); });
}

void SceneRenderer::DrawNumbers(cv::Size size, hardware::StageTimes* times) {
  Book(times, "render", [&] { one_pass_->Draw(scene_, size, false); });
}

RenderedView SceneRenderer::Render(const PosedCamera& view, const Products& products,
                                   hardware::StageTimes* times) {
  const hardware::Intrinsics& in = view.camera.intrinsics();
  const cv::Size size(in.width, in.height);
  const bool measures = products.depth || products.ids;
  RenderedView seen;
  context_->MakeCurrent();
  UpdateScene(FrustumOf(view.X_WC, in, options_.near_m, options_.far_m));
  if (products.rgb) {
    const cv::Size drawn = options_.supersample ? size * kSupersampling : size;
    const bool all_in_one = !options_.supersample && !LeavesColoursToMujoco();
    DrawColours(drawn, times);
    Book(times, "read_back", [&] {
      Fetch(drawn, all_in_one ? products : Products{}, seen);
      if (options_.supersample) seen.bgr = Halved(seen.bgr);
    });
    if (all_in_one || !measures) return seen;
  }
  if (measures) {
    DrawNumbers(size, times);
    Book(times, "read_back",
         [&] { Fetch(size, {.rgb = false, .depth = products.depth, .ids = products.ids}, seen); });
  }
  return seen;
}

void SceneRenderer::Fetch(cv::Size size, const Products& products, RenderedView& view) {
  const std::vector<int> geom_of_number = products.ids ? GeomOfNumber() : std::vector<int>();
  if (products.rgb || products.ids) read_back_.FetchColours(size);
  if (products.depth || ReadBack::UsesHighByte(geom_of_number)) read_back_.FetchDepth(size);
  if (products.rgb) view.bgr = read_back_.Bgr();
  if (products.depth) view.depth = read_back_.Depth(options_.near_m, options_.far_m);
  if (products.ids) view.ids = read_back_.Lookup(geom_of_number);
}

std::vector<int> SceneRenderer::GeomOfNumber() const {
  std::vector<int> geom_of(OnePass::NumbersOf(scene_), -1);
  for (int i = 0; i < scene_.ngeom; ++i) {
    const mjvGeom& geom = scene_.geoms[i];
    if (geom.objtype == mjOBJ_GEOM) geom_of[static_cast<std::size_t>(i) + 1] = geom.objid;
  }
  return geom_of;
}

void SceneRenderer::UploadTextures() {
  context_->MakeCurrent();
  for (int i = 0; i < world_.model().ntex; ++i) mjr_uploadTexture(&world_.model(), &mujoco_, i);
}

std::string SceneRenderer::gl_renderer() { return context_->gl_renderer(); }

}  // namespace horopter::sim
