// SPDX-License-Identifier: Apache-2.0
#include "sim/render/shadow_maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/render/gl_context.h"
#include "sim/render/look_along.h"

namespace horopter::sim {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

/// Clip coordinates (-1 to 1) to those of a texture (0 to 1).
Matrix4f TextureFromClip() {
  Matrix4f bias = Matrix4f::Identity() * 0.5f;
  bias.col(3) << 0.5f, 0.5f, 0.5f, 1;
  return bias;
}

bool SameParameters(const mjvLight& a, const mjvLight& b) {
  return std::equal(a.pos, a.pos + 3, b.pos) && std::equal(a.dir, a.dir + 3, b.dir) &&
         a.cutoff == b.cutoff && a.directional == b.directional;
}

/// Adds `area`, joined with every one that it overlaps.
void Join(std::vector<cv::Rect>& areas, cv::Rect area) {
  if (area.empty()) return;
  for (std::size_t i = 0; i < areas.size();) {
    if ((areas[i] & area).empty()) {
      ++i;
      continue;
    }
    area |= areas[i];
    areas.erase(areas.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;
  }
  areas.push_back(area);
}

}  // namespace

ShadowMaps::ShadowMaps(const GlFunctions& gl, const mjrContext& mujoco, const GeomShapes& shapes)
    : gl_(gl),
      shapes_(shapes),
      size_(mujoco.shadowSize),
      clip_(mujoco.shadowClip),
      spot_scale_(mujoco.shadowScale) {}

ShadowMaps::~ShadowMaps() {
  for (const Map& map : maps_) {
    gl_.DeleteFramebuffers(1, &map.frame);
    gl_.DeleteTextures(1, &map.texture);
  }
}

ShadowMaps::Map ShadowMaps::MakeMap() const {
  Map map;
  gl_.GenTextures(1, &map.texture);
  gl_.BindTexture(GL_TEXTURE_2D, map.texture);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, size_, size_, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl_.GenFramebuffers(1, &map.frame);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, map.frame);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.texture, 0);
  gl_.DrawBuffer(GL_NONE);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw RenderError("this OpenGL cannot draw into a shadow map: lower the model's shadowsize");
  }
  return map;
}

ShadowMaps::Caster ShadowMaps::CasterOf(const mjvGeom& geom) {
  Caster caster{geom.type, geom.dataid, {}, {}, {}, geom.modelrbound};
  std::copy_n(geom.size, 3, caster.size.begin());
  std::copy_n(geom.pos, 3, caster.pos.begin());
  std::copy_n(geom.mat, 9, caster.mat.begin());
  return caster;
}

bool ShadowMaps::TakeLight(Map& map, const mjvLight& light, float near, float far) const {
  constexpr float kWidestSpot_deg = 160;
  if (map.drawn && SameParameters(map.light, light) && map.near == near && map.far == far) {
    return true;
  }
  map.light = light;
  map.near = near;
  map.far = far;
  map.view = LookAlong(light.pos, light.dir, UprightFor(light.dir).data());
  gl_.MatrixMode(GL_PROJECTION);
  gl_.LoadIdentity();
  if (light.directional) {
    gl_.Ortho(-clip_, clip_, -clip_, clip_, near, far);
  } else {
    const double fov_deg = std::min(2 * light.cutoff * spot_scale_, kWidestSpot_deg);
    const double half = std::tan(fov_deg / 360 * M_PI) * static_cast<double>(near);
    gl_.Frustum(-half, half, -half, half, near, far);
  }
  gl_.GetFloatv(GL_PROJECTION_MATRIX, map.projection.data());
  map.map_from_world = TextureFromClip() * (map.projection * map.view);
  return false;
}

cv::Rect ShadowMaps::Footprint(const Map& map, const Caster& caster) const {
  const cv::Rect all(0, 0, size_, size_);
  const Vector3f centre(caster.pos.data());
  if (caster.type == mjGEOM_PLANE) {
    const Vector3f normal(caster.mat[2], caster.mat[5], caster.mat[8]);
    const Vector3f to_light = map.light.directional ? Vector3f(-Vector3f(map.light.dir))
                                                    : Vector3f(map.light.pos) - centre;
    // Only back faces cast a shadow.
    return normal.dot(to_light) > 1e-3f * to_light.norm() ? cv::Rect() : all;
  }
  if (caster.radius <= 0) return all;
  constexpr int kMargin_px = 2;
  Eigen::Array2f low(2, 2), high(-2, -2);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3f sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Eigen::Vector4f at =
        map.projection * map.view * (centre + caster.radius * sign).homogeneous();
    if (at.w() < map.near) return all;
    low = low.min(at.head<2>().array() / at.w());
    high = high.max(at.head<2>().array() / at.w());
  }
  const auto texel = [this](float clip) {
    return static_cast<int>((std::clamp(clip, -2.f, 2.f) * 0.5f + 0.5f) *
                            static_cast<float>(size_));
  };
  const cv::Point from(texel(low.x()) - kMargin_px, texel(low.y()) - kMargin_px);
  const cv::Point to(texel(high.x()) + kMargin_px + 1, texel(high.y()) + kMargin_px + 1);
  return cv::Rect(from, to) & all;
}

std::vector<cv::Rect> ShadowMaps::Stale(const Map& map, const std::vector<Caster>& casters) const {
  std::vector<cv::Rect> areas;
  for (std::size_t i = 0; i < std::max(casters.size(), map.casters.size()); ++i) {
    const bool is = i < casters.size(), was = i < map.casters.size();
    if (is && was && casters[i] == map.casters[i]) continue;
    if (was) Join(areas, Footprint(map, map.casters[i]));
    if (is) Join(areas, Footprint(map, casters[i]));
  }
  return areas;
}

void ShadowMaps::Update(int k, const mjvLight& light, const mjvScene& scene) {
  while (maps_.size() <= static_cast<std::size_t>(k)) maps_.push_back(MakeMap());
  Map& map = maps_[static_cast<std::size_t>(k)];
  const mjvGLCamera& camera = scene.camera[0];
  std::vector<Caster> casters;
  casters.reserve(static_cast<std::size_t>(scene.ngeom));
  for (int i = 0; i < scene.ngeom; ++i) casters.push_back(CasterOf(scene.geoms[i]));

  const bool kept = TakeLight(map, light, camera.frustum_near, camera.frustum_far);
  std::vector<cv::Rect> areas{{0, 0, size_, size_}};
  if (kept) areas = Stale(map, casters);
  map.casters = std::move(casters);
  map.drawn = true;
  for (const cv::Rect& area : areas) Redraw(map, area, scene);
}

void ShadowMaps::Redraw(const Map& map, const cv::Rect& area, const mjvScene& scene) const {
  gl_.MatrixMode(GL_PROJECTION);
  gl_.LoadMatrixf(map.projection.data());
  gl_.MatrixMode(GL_MODELVIEW);
  gl_.LoadMatrixf(map.view.data());
  gl_.BindFramebuffer(GL_FRAMEBUFFER, map.frame);
  gl_.DrawBuffer(GL_NONE);
  gl_.UseProgram(0);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(area.x, area.y, area.width, area.height);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.Viewport(1, 1, size_ - 2, size_ - 2);  // a clear border, beyond which nothing is in shadow
  gl_.CullFace(GL_FRONT);
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (std::size_t i = 0; i < map.casters.size(); ++i) {
    if ((Footprint(map, map.casters[i]) & area).empty()) continue;
    shapes_.Draw(scene.geoms[i], false);
  }
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.CullFace(GL_BACK);
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace horopter::sim
