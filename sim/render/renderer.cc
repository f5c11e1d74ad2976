// SPDX-License-Identifier: Apache-2.0
#include "sim/render/renderer.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::FieldError;
using hardware::Intrinsics;
using hardware::Pose;

constexpr int kVisibleGeomGroups = 3;  // groups 0, 1, 2
constexpr int kSpareGeoms = 64;        // mjvScene slots beyond the model's geoms

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

/// The pinhole as an OpenGL frustum. Pixel (0, 0) is a centre, so the image spans -0.5 to W - 0.5;
/// MuJoCo keeps left and right as a centre and a width that follows from the viewport's aspect.
mjvGLCamera FrustumOf(const Pose& X_WC, const Intrinsics& in, double near_m, double far_m) {
  const double pixel_m = near_m / in.fx;  // size of a pixel on the near plane
  mjvGLCamera camera{};
  for (int k = 0; k < 3; ++k) {
    camera.pos[k] = static_cast<float>(X_WC.translation()[k]);
    camera.forward[k] = static_cast<float>(X_WC.linear()(k, 2));
    camera.up[k] = static_cast<float>(-X_WC.linear()(k, 1));
  }
  camera.frustum_center = static_cast<float>((in.width / 2.0 - 0.5 - in.cx) * pixel_m);
  camera.frustum_top = static_cast<float>((in.cy + 0.5) * pixel_m);
  camera.frustum_bottom = static_cast<float>((in.cy + 0.5 - in.height) * pixel_m);
  camera.frustum_near = static_cast<float>(near_m);
  camera.frustum_far = static_cast<float>(far_m);
  return camera;
}

std::vector<FieldError> CheckView(const Pose& X_WC, const CameraModel& camera,
                                  const RendererOptions& options) {
  constexpr double kSquare = 1e-9;
  std::vector<FieldError> errors;
  const Intrinsics& in = camera.intrinsics();
  const auto check_size = [&errors](const char* field, int value, int limit, const char* option) {
    if (value <= limit) return;
    errors.push_back({field, std::to_string(value),
                      fmt::format("must be at most {}, the renderer's {}", limit, option)});
  };
  check_size("camera.width", in.width, options.width, "width");
  check_size("camera.height", in.height, options.height, "height");
  if (camera.distortion().any()) {
    errors.push_back({"camera.distortion", "not zero",
                      "must be zero to render: render an ideal view and resample it"});
  }
  if (std::abs(in.fx - in.fy) > kSquare * in.fx) {
    errors.push_back(
        {"camera.fy", std::to_string(in.fy),
         fmt::format("must equal fx = {} to render: render square pixels and resample", in.fx)});
  }
  if (!X_WC.matrix().allFinite()) errors.push_back({"X_WC", "not finite", "must be finite"});
  return errors;
}

/// mjvScene's buffers, freed even when what comes after them cannot be made.
struct Scene : mjvScene {
  Scene(const mjModel& model, int capacity) {
    mjv_defaultScene(this);
    mjv_makeScene(&model, this, capacity);
  }
  ~Scene() { mjv_freeScene(this); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

}  // namespace

std::vector<FieldError> RendererOptions::Validate() const {
  std::vector<FieldError> errors;
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

class Renderer::Gl {
 public:
  Gl(World& world, const RendererOptions& options);
  ~Gl();
  Gl(const Gl&) = delete;
  Gl& operator=(const Gl&) = delete;

  GlContext& context() { return *context_; }
  /// Takes the world's geoms and lights as they are now, seen by `camera`.
  void UpdateScene(const mjvGLCamera& camera);
  /// Draws into the lower left corner of the off-screen buffer, colours or geom numbers.
  void Draw(int width, int height, bool numbers);
  cv::Mat3b ReadColour(int width, int height);
  cv::Mat1i ReadIds(int width, int height);
  cv::Mat1f ReadDepth(int width, int height, double near_m, double far_m);
  void UploadTextures();

 private:
  using ReadPixels = void(APIENTRY*)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*);
  using Finish = void(APIENTRY*)();
  using GetIntegerv = void(APIENTRY*)(GLenum, GLint*);

  template <typename Function>
  Function Load(const char* name);
  void CheckSize(const RendererOptions& options);
  /// Four bytes per pixel into staging_, row 0 at the bottom.
  void Read(int width, int height, GLenum format, GLenum type);
  const std::uint32_t* StagedRow(int y, int width, int height) const {
    return staging_.data() + static_cast<std::size_t>(height - 1 - y) * width;
  }

  World& world_;
  std::unique_ptr<GlContext> context_;
  ReadPixels read_pixels_;
  Finish finish_;
  mjvOption option_ = CameraOption();
  Scene scene_;
  mjrContext mujoco_{};
  std::vector<std::uint32_t> staging_;
};

Renderer::Gl::Gl(World& world, const RendererOptions& options)
    : world_(world),
      context_(CreateGlContext(options.gl_backend, 1, 1)),
      scene_(world.model(), world.model().ngeom + kSpareGeoms) {
  context_->MakeCurrent();
  read_pixels_ = Load<ReadPixels>("glReadPixels");
  finish_ = Load<Finish>("glFinish");
  CheckSize(options);
  mjr_defaultContext(&mujoco_);
  // MuJoCo takes the buffer's size and samples from the model. A multisampled depth or id would be
  // a blend of several surfaces.
  mjModel model = world.model();
  model.vis.global.offwidth = options.width;
  model.vis.global.offheight = options.height;
  model.vis.quality.offsamples = 0;
  try {
    mjr_makeContext(&model, &mujoco_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &mujoco_);
  } catch (const PhysicsError& e) {
    throw RenderError(fmt::format("cannot render with {}: {}", context_->gl_renderer(), e.what()));
  }
}

Renderer::Gl::~Gl() {
  try {
    context_->MakeCurrent();
    mjr_freeContext(&mujoco_);
  } catch (const std::runtime_error&) {
    // Without its context there is nothing left to free in GL.
  }
}

template <typename Function>
Function Renderer::Gl::Load(const char* name) {
  const auto function = reinterpret_cast<Function>(context_->Function(name));
  if (function == nullptr) {
    throw RenderError(fmt::format("{} lacks {}", context_->gl_renderer(), name));
  }
  return function;
}

void Renderer::Gl::CheckSize(const RendererOptions& options) {
  const auto get_integer = Load<GetIntegerv>("glGetIntegerv");
  GLint renderbuffer = 0;
  std::array<GLint, 2> viewport{};
  get_integer(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  get_integer(GL_MAX_VIEWPORT_DIMS, viewport.data());
  std::vector<FieldError> errors;
  const auto check = [&](const char* field, int value, int limit) {
    if (value <= limit) return;
    errors.push_back(
        {field, std::to_string(value),
         fmt::format("must be at most {}, the limit of {}", limit, context_->gl_renderer())});
  };
  check("renderer.width", options.width, std::min(renderbuffer, viewport[0]));
  check("renderer.height", options.height, std::min(renderbuffer, viewport[1]));
  hardware::ThrowIfAny(std::move(errors));
}

void Renderer::Gl::UpdateScene(const mjvGLCamera& camera) {
  // In mono MuJoCo averages both cameras. They come first: infinite planes are centred on them.
  scene_.camera[0] = scene_.camera[1] = camera;
  scene_.ngeom = 0;
  mjv_addGeoms(&world_.model(), &world_.mutable_data(), &option_, nullptr, mjCAT_ALL, &scene_);
  mjv_makeLights(&world_.model(), &world_.mutable_data(), &scene_);
}

void Renderer::Gl::Draw(int width, int height, bool numbers) {
  scene_.flags[mjRND_SEGMENT] = scene_.flags[mjRND_IDCOLOR] = numbers ? 1 : 0;
  mjr_render({0, 0, width, height}, &scene_, &mujoco_);
  finish_();  // llvmpipe would draw while the read-back is timed
}

void Renderer::Gl::Read(int width, int height, GLenum format, GLenum type) {
  staging_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  mjr_restoreBuffer(&mujoco_);
  read_pixels_(0, 0, width, height, format, type, staging_.data());
}

cv::Mat3b Renderer::Gl::ReadColour(int width, int height) {
  Read(width, height, GL_RGBA, GL_UNSIGNED_BYTE);
  const cv::Mat4b rgba(height, width, reinterpret_cast<cv::Vec4b*>(staging_.data()));
  cv::Mat3b bgr;
  cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
  cv::flip(bgr, bgr, 0);
  return bgr;
}

cv::Mat1i Renderer::Gl::ReadIds(int width, int height) {
  Read(width, height, GL_RGBA, GL_UNSIGNED_BYTE);
  std::vector<int> geom_of(static_cast<std::size_t>(scene_.ngeom) + 1, -1);
  for (int i = 0; i < scene_.ngeom; ++i) {
    const mjvGeom& geom = scene_.geoms[i];
    if (geom.objtype == mjOBJ_GEOM && geom.segid >= 0 && geom.segid < scene_.ngeom) {
      geom_of[static_cast<std::size_t>(geom.segid) + 1] = geom.objid;
    }
  }
  cv::Mat1i ids(height, width);
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* row = StagedRow(y, width, height);
    for (int x = 0; x < width; ++x) {
      const std::uint32_t number = row[x] & 0xFFFFFFu;  // red lowest; alpha is no part of it
      ids(y, x) = number < geom_of.size() ? geom_of[number] : -1;
    }
  }
  return ids;
}

cv::Mat1f Renderer::Gl::ReadDepth(int width, int height, double near_m, double far_m) {
  Read(width, height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  // Window depth d of a perspective frustum is linear in 1/z: 1/z = 1/near + d (1/far - 1/near).
  // The planes are those OpenGL got, as floats.
  constexpr std::uint32_t kFarthest = (1u << 24) - 1;
  const double nearest = 1.0 / static_cast<float>(near_m);
  const double slope = (1.0 / static_cast<float>(far_m) - nearest) / kFarthest;
  cv::Mat1f depth(height, width);
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* row = StagedRow(y, width, height);
    for (int x = 0; x < width; ++x) {
      const std::uint32_t d = row[x] >> 8;
      depth(y, x) = d == kFarthest ? std::numeric_limits<float>::infinity()
                                   : static_cast<float>(1.0 / (nearest + slope * d));
    }
  }
  return depth;
}

void Renderer::Gl::UploadTextures() {
  context_->MakeCurrent();
  for (int i = 0; i < world_.model().ntex; ++i) mjr_uploadTexture(&world_.model(), &mujoco_, i);
}

Renderer::Renderer(World& world, const RendererOptions& options) : options_(options) {
  hardware::ThrowIfAny(options.Validate());
  gl_ = std::make_unique<Gl>(world, options);
}

Renderer::~Renderer() = default;

RenderedView Renderer::Render(const Pose& X_WC, const CameraModel& camera, const Products& products,
                              hardware::StageTimes* times) {
  hardware::ThrowIfAny(CheckView(X_WC, camera, options_));
  const int width = camera.width();
  const int height = camera.height();
  hardware::StageTimes unwanted;
  hardware::StageTimes& book = times != nullptr ? *times : unwanted;
  RenderedView view;

  gl_->context().MakeCurrent();
  gl_->UpdateScene(FrustumOf(X_WC, camera.intrinsics(), options_.near_m, options_.far_m));
  if (products.rgb) {
    book.Measure("render", [&] { gl_->Draw(width, height, false); });
    book.Measure("read_back", [&] { view.bgr = gl_->ReadColour(width, height); });
  }
  if (products.depth || products.ids) {
    book.Measure("render", [&] { gl_->Draw(width, height, true); });
    book.Measure("read_back", [&] {
      if (products.ids) view.ids = gl_->ReadIds(width, height);
      if (products.depth) {
        view.depth = gl_->ReadDepth(width, height, options_.near_m, options_.far_m);
      }
    });
  }
  return view;
}

void Renderer::UploadTextures() { gl_->UploadTextures(); }

std::string Renderer::gl_renderer() const { return gl_->context().gl_renderer(); }

}  // namespace horopter::sim
