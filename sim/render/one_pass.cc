// SPDX-License-Identifier: Apache-2.0
#include "sim/render/one_pass.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "sim/render/look_along.h"
#include "sim/render/view_volume.h"

namespace horopter::sim {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

constexpr int kMostLights = 8;        // GL_MAX_LIGHTS of the fixed pipeline
constexpr int kMostShadows = 4;       // shadow maps that a program reads
constexpr float kOpaque = 0.995f;     // mjr_render's limit
constexpr float kBackOfPlane = 0.3f;  // by which a plane seen from behind fades

bool IsReflective(const mjvGeom& geom) {
  return (geom.type == mjGEOM_PLANE || geom.type == mjGEOM_BOX) && geom.reflectance > 0;
}

bool CastsShadow(const mjvScene& scene, int light) {
  return scene.flags[mjRND_SHADOW] && scene.lights[light].castshadow;
}

bool SeenFromBehind(const mjvScene& scene, const mjvGeom& geom) {
  return geom.type == mjGEOM_PLANE && IsBehind(geom, scene.camera[0].pos);
}

bool IsTransparent(const mjvScene& scene, const mjvGeom& geom) {
  return geom.rgba[3] < kOpaque || SeenFromBehind(scene, geom);
}

/// How far the geom's nearest point may be; planes and unknown extents last, as in mjr_render.
float NearestPoint(const mjvScene& scene, const mjvGeom& geom) {
  constexpr float kLast = 1e10f;
  if (geom.type == mjGEOM_PLANE || geom.modelrbound <= 0) return kLast;
  return (Vector3f(geom.pos) - Vector3f(scene.camera[0].pos)).norm() - geom.modelrbound;
}

/// The low byte of a geom's number as an alpha.
float LowNumber(int geom) { return static_cast<float>((geom + 1) & 0xFF) / 255; }

ImageKind ImageKindOf(const mjvGeom& geom, const mjrContext& mujoco) {
  if (geom.texid < 0) return ImageKind::kNone;
  if (geom.texcoord) return ImageKind::kFlat;
  return mujoco.textureType[geom.texid] == mjTEXTURE_2D ? ImageKind::kFlatGenerated
                                                        : ImageKind::kCube;
}

}  // namespace

OnePass::OnePass(const GlFunctions& gl, const mjrContext& mujoco)
    : gl_(gl),
      mujoco_(mujoco),
      shapes_(gl, mujoco),
      shadows_(gl, mujoco, shapes_),
      own_levels_(FindsOwnLevels(reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)))) {}

std::string OnePass::CannotDraw(const mjvScene& scene) {
  if (scene.flags[mjRND_FOG] || scene.flags[mjRND_WIREFRAME]) return "fog or wire frame";
  if (scene.nskin > 0) return "skins";
  if (scene.nlight > kMostLights) return fmt::format("more than {} lights", kMostLights);
  int shadows = 0;
  for (int i = 0; i < scene.nlight; ++i) shadows += CastsShadow(scene, i);
  if (shadows > kMostShadows) return fmt::format("more than {} shadow lights", kMostShadows);
  for (int i = 0; i < scene.ngeom; ++i) {
    if (!GeomShapes::Knows(scene.geoms[i])) return "shapes that are no model geoms";
    if (IsReflective(scene.geoms[i])) return "reflective surfaces";
  }
  return "";
}

OnePass::Order OnePass::Sort(const mjvScene& scene, cv::Size size) const {
  const ViewVolume seen(scene.camera[0],
                        static_cast<float>(size.width) / static_cast<float>(size.height));
  std::vector<std::pair<float, int>> opaque, transparent;
  for (int i = 0; i < scene.ngeom; ++i) {
    const mjvGeom& geom = scene.geoms[i];
    if (seen.Misses(geom)) continue;
    auto& group = IsTransparent(scene, geom) ? transparent : opaque;
    group.emplace_back(NearestPoint(scene, geom), i);
  }
  const auto sorted = [](std::vector<std::pair<float, int>>& group) {
    std::sort(group.begin(), group.end());  // equal distances in the model's order
    std::vector<int> order;
    for (const auto& entry : group) order.push_back(entry.second);
    return order;
  };
  return {sorted(opaque), sorted(transparent)};
}

void OnePass::SetView(const mjvScene& scene, cv::Size size) {
  const mjvGLCamera& camera = scene.camera[0];
  const float half_width = 0.5f * static_cast<float>(size.width) / static_cast<float>(size.height) *
                           (camera.frustum_top - camera.frustum_bottom);
  const Matrix4f view = LookAlong(camera.pos, camera.forward, camera.up);
  world_from_eye_ = Eigen::Isometry3f(view).inverse().matrix();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, mujoco_.offFBO);
  gl_.DrawBuffer(GL_COLOR_ATTACHMENT0);
  gl_.Viewport(0, 0, size.width, size.height);
  gl_.MatrixMode(GL_PROJECTION);
  gl_.LoadIdentity();
  gl_.Frustum(camera.frustum_center - half_width, camera.frustum_center + half_width,
              camera.frustum_bottom, camera.frustum_top, camera.frustum_near, camera.frustum_far);
  gl_.MatrixMode(GL_MODELVIEW);
  gl_.LoadMatrixf(view.data());
}

void OnePass::ClearAll(cv::Size size, bool many) const {
  gl_.ClearColor(0, 0, 0, 0);
  gl_.ClearDepth(1);
  gl_.ClearStencil(0);
  gl_.Scissor(0, 0, size.width, size.height);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | (many ? GL_STENCIL_BUFFER_BIT : 0u));
  gl_.Disable(GL_SCISSOR_TEST);
}

void OnePass::SetState() const {
  gl_.Disable(GL_LIGHTING);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_ALPHA_TEST);
  gl_.Disable(GL_STENCIL_TEST);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.DepthRange(0, 1);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.FrontFace(GL_CCW);
  gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl_.ShadeModel(GL_SMOOTH);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.ClearDepth(1);
}

void OnePass::UpdateShadows(const mjvScene& scene) {
  SetState();
  int k = 0;
  for (int i = 0; i < scene.nlight; ++i) {
    if (CastsShadow(scene, i)) shadows_.Update(k++, scene.lights[i], scene);
  }
}

void OnePass::PlaceLights(const mjvScene& scene) const {
  const float global = scene.nlight == 0 ? 0.3f : 0;
  const float ambient[4] = {global, global, global, 1};
  gl_.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  for (int i = 0; i < scene.nlight; ++i) {
    const mjvLight& light = scene.lights[i];
    const GLenum name = GL_LIGHT0 + static_cast<GLenum>(i);
    const auto set = [&](GLenum field, const float v[3], float sign, float w) {
      const float values[4] = {sign * v[0], sign * v[1], sign * v[2], w};
      gl_.Lightfv(name, field, values);
    };
    set(GL_AMBIENT, light.ambient, 1, 1);
    set(GL_DIFFUSE, light.diffuse, 1, 1);
    set(GL_SPECULAR, light.specular, 1, 1);
    if (light.directional) {
      set(GL_POSITION, light.dir, -1, 0);
      continue;
    }
    set(GL_POSITION, light.pos, 1, 1);
    set(GL_SPOT_DIRECTION, light.dir, 1, 0);
    gl_.Lightf(name, GL_SPOT_EXPONENT, light.exponent);
    gl_.Lightf(name, GL_SPOT_CUTOFF, light.cutoff);
    gl_.Lightf(name, GL_CONSTANT_ATTENUATION, light.attenuation[0]);
    gl_.Lightf(name, GL_LINEAR_ATTENUATION, light.attenuation[1]);
    gl_.Lightf(name, GL_QUADRATIC_ATTENUATION, light.attenuation[2]);
  }
}

void OnePass::SetNumber(const mjvScene& scene, int geom) const {
  if (scene.ngeom > kLowNumbers) gl_.StencilFunc(GL_ALWAYS, (geom + 1) >> 8, 0xFF);
}

const LitProgram& OnePass::ProgramFor(const mjvScene& scene, const mjvGeom& geom, bool opaque) {
  LitProgramKind kind{ImageKindOf(geom, mujoco_), geom.specular > 0, {}, own_levels_};
  for (int i = 0; i < scene.nlight; ++i) {
    kind.lights.push_back({scene.lights[i].directional != 0, opaque && CastsShadow(scene, i)});
  }
  auto& program = programs_[kind];
  if (!program) program = std::make_unique<LitProgram>(gl_, kind);
  return *program;
}

void OnePass::BindImage(const mjvGeom& geom, const LitProgram& program) const {
  const ImageKind kind = ImageKindOf(geom, mujoco_);
  if (kind == ImageKind::kNone) return;
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(kind == ImageKind::kCube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D,
                  mujoco_.texture[geom.texid]);
  if (kind == ImageKind::kCube) {
    if (geom.texuniform) {
      program.SetImageScale(geom.size[0], geom.size[1], geom.size[2]);
    } else {
      program.SetImageScale(1, 1, 1);
    }
  } else if (kind == ImageKind::kFlatGenerated) {
    float scale[2] = {geom.texrepeat[0], geom.texrepeat[1]};
    for (int k = 0; k < 2; ++k) {
      if (geom.size[k] <= 0) continue;
      if (geom.dataid >= 0) scale[k] /= geom.size[k];  // its display list has its size
      if (geom.texuniform) scale[k] *= geom.size[k];
    }
    program.SetImageScale(0.5f * scale[0], -0.5f * scale[1], 0);
  }
}

void OnePass::DrawLit(const mjvScene& scene, int index, bool opaque) {
  constexpr float kShininess = 128;
  const mjvGeom& geom = scene.geoms[index];
  const LitProgram& program = ProgramFor(scene, geom, opaque);
  if (in_use_ != &program) {
    program.Use();
    in_use_ = &program;
    int k = 0;
    for (int i = 0; opaque && i < scene.nlight; ++i) {
      if (!CastsShadow(scene, i)) continue;
      const Matrix4f from_eye = shadows_.map_from_world(k) * world_from_eye_;
      program.SetShadowMatrix(k++, from_eye.data());
    }
  }
  program.SetMaterial(geom.emission, geom.specular, geom.shininess * kShininess);
  BindImage(geom, program);
  const bool behind = SeenFromBehind(scene, geom);
  const float opacity = geom.rgba[3] * (behind ? kBackOfPlane : 1);
  program.SetAlpha(opaque ? LowNumber(index) : opacity);
  gl_.Color4f(geom.rgba[0], geom.rgba[1], geom.rgba[2], 1);
  shapes_.Draw(geom, behind);
}

void OnePass::DrawOpaque(const mjvScene& scene, const std::vector<int>& geoms) {
  int k = 0;
  for (int i = 0; i < scene.nlight; ++i) {
    if (!CastsShadow(scene, i)) continue;
    gl_.ActiveTexture(GL_TEXTURE1 + static_cast<GLenum>(k));
    gl_.BindTexture(GL_TEXTURE_2D, shadows_.texture(k++));
  }
  in_use_ = nullptr;
  for (const int i : geoms) {
    SetNumber(scene, i);
    DrawLit(scene, i, true);
  }
}

void OnePass::DrawNumbers(const mjvScene& scene, const std::vector<int>& geoms) const {
  gl_.UseProgram(0);
  for (const int i : geoms) {
    SetNumber(scene, i);
    gl_.Color4f(0, 0, 0, LowNumber(i));
    shapes_.Draw(scene.geoms[i], SeenFromBehind(scene, scene.geoms[i]));
  }
}

void OnePass::DrawSky(const mjvScene& scene) const {
  const int* types = mujoco_.textureType;
  const int* sky = std::find(types, types + mujoco_.ntexture, static_cast<int>(mjTEXTURE_SKYBOX));
  if (!scene.flags[mjRND_SKYBOX] || sky == types + mujoco_.ntexture) return;
  constexpr float kOfFarPlane = 0.7f;  // just inside it in the corners of a cylinder
  const float radius = kOfFarPlane * scene.camera[0].frustum_far;
  const float* at = scene.camera[0].pos;
  // Textures of the sky have y up: z and -y of the world are their second and third axis.
  const float axes[3][4] = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}};
  gl_.UseProgram(0);
  gl_.CullFace(GL_FRONT);
  gl_.PushMatrix();
  gl_.Translatef(at[0], at[1], at[2]);
  gl_.Scalef(radius, radius, radius);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.Enable(GL_TEXTURE_CUBE_MAP);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, mujoco_.texture[sky - types]);
  gl_.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  for (int k = 0; k < 3; ++k) {
    gl_.Enable(GL_TEXTURE_GEN_S + static_cast<GLenum>(k));
    gl_.TexGeni(GL_S + static_cast<GLenum>(k), GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    gl_.TexGenfv(GL_S + static_cast<GLenum>(k), GL_OBJECT_PLANE, axes[k]);
  }
  gl_.Color4f(1, 1, 1, 1);
  shapes_.DrawCylinder();
  gl_.Disable(GL_TEXTURE_CUBE_MAP);
  for (int k = 0; k < 3; ++k) gl_.Disable(GL_TEXTURE_GEN_S + static_cast<GLenum>(k));
  DrawHaze(scene, radius);
  gl_.PopMatrix();
  gl_.CullFace(GL_BACK);
}

void OnePass::DrawHaze(const mjvScene& scene, float radius) const {
  if (!scene.flags[mjRND_HAZE]) return;
  const mjvGeom* plane =
      std::find_if(scene.geoms, scene.geoms + scene.ngeom, [](const mjvGeom& geom) {
        return geom.type == mjGEOM_PLANE && geom.size[0] <= 0 && geom.size[1] <= 0;
      });
  if (plane == scene.geoms + scene.ngeom || SeenFromBehind(scene, *plane)) return;
  const float* R = plane->mat;
  const float rotation[16] = {R[0], R[3], R[6], 0, R[1], R[4], R[7], 0,
                              R[2], R[5], R[8], 0, 0,    0,    0,    1};
  const Vector3f above = Vector3f(scene.camera[0].pos) - Vector3f(plane->pos);
  const float elevation = above.dot(Vector3f(R[2], R[5], R[8])) / radius;
  gl_.MultMatrixf(rotation);
  gl_.Translatef(0, 0, -elevation);
  gl_.Scalef(1, 1, elevation);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  shapes_.DrawHaze();
  gl_.Disable(GL_BLEND);
}

void OnePass::DrawTransparent(const mjvScene& scene, const std::vector<int>& geoms) {
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  in_use_ = nullptr;
  // Twice, as mjr_render does: front to back, then back to front.
  for (auto i = geoms.begin(); i != geoms.end(); ++i) DrawLit(scene, *i, false);
  for (auto i = geoms.rbegin(); i != geoms.rend(); ++i) DrawLit(scene, *i, false);
  gl_.Disable(GL_BLEND);
}

void OnePass::Draw(const mjvScene& scene, cv::Size size, bool colours) {
  const bool many = scene.ngeom > kLowNumbers;
  const Order order = Sort(scene, size);
  if (colours) UpdateShadows(scene);
  SetState();
  SetView(scene, size);
  ClearAll(size, many);
  if (many) {
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  }
  if (colours) {
    PlaceLights(scene);
    DrawOpaque(scene, order.opaque);
    gl_.Disable(GL_STENCIL_TEST);
    gl_.DepthMask(GL_FALSE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // alpha keeps the numbers
    DrawSky(scene);
    DrawTransparent(scene, order.transparent);
    gl_.DepthMask(GL_TRUE);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    if (many) gl_.Enable(GL_STENCIL_TEST);
  } else {
    DrawNumbers(scene, order.opaque);
  }
  DrawNumbers(scene, order.transparent);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.Disable(GL_STENCIL_TEST);
  gl_.ActiveTexture(GL_TEXTURE0);
}

}  // namespace horopter::sim
