// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/drawn_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

constexpr int kVisibleGroups = 3;

void AddQuad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
             std::vector<Triangle>* triangles) {
  triangles->push_back({a, b, c});
  triangles->push_back({a, c, d});
}

/// A stack of rings of corners around z, from the lowest to the highest, with a tip below and
/// above: what every round geom is drawn as.
class Turned {
 public:
  explicit Turned(int slices) : slices_(slices) {}

  void AddRing(double radius_x, double radius_y, double z) {
    std::vector<Vector3d> ring;
    for (int j = 0; j < slices_; ++j) {
      const double azimuth = 2 * M_PI * j / slices_;
      ring.emplace_back(radius_x * std::cos(azimuth), radius_y * std::sin(azimuth), z);
    }
    rings_.push_back(std::move(ring));
  }

  std::vector<Triangle> Close(double lowest_z, double highest_z) const {
    std::vector<Triangle> triangles;
    const Vector3d lowest(0, 0, lowest_z), highest(0, 0, highest_z);
    for (int j = 0; j < slices_; ++j) {
      const int k = (j + 1) % slices_;
      triangles.push_back({lowest, At(0, k), At(0, j)});
      const int last = static_cast<int>(rings_.size()) - 1;
      for (int i = 0; i < last; ++i) {
        AddQuad(At(i, j), At(i, k), At(i + 1, k), At(i + 1, j), &triangles);
      }
      triangles.push_back({At(last, j), At(last, k), highest});
    }
    return triangles;
  }

 private:
  const Vector3d& At(int ring, int corner) const {
    return rings_[static_cast<std::size_t>(ring)][static_cast<std::size_t>(corner)];
  }

  int slices_;
  std::vector<std::vector<Vector3d>> rings_;
};

std::vector<Triangle> Ellipsoid(const mjVisual& visual, const Vector3d& size) {
  const int half = visual.quality.numstacks / 2;
  Turned solid(visual.quality.numslices);
  for (int i = 1 - half; i < half; ++i) {
    const double elevation = M_PI / 2 * i / half;
    const double r = std::cos(elevation);
    solid.AddRing(size.x() * r, size.y() * r, size.z() * std::sin(elevation));
  }
  return solid.Close(-size.z(), size.z());
}

std::vector<Triangle> Capsule(const mjVisual& visual, double radius, double half_length) {
  const int half = visual.quality.numstacks / 2;
  Turned solid(visual.quality.numslices);
  for (const int end : {-1, 1}) {
    for (int i = 0; i < half; ++i) {
      const double elevation = M_PI / 2 * (end < 0 ? i + 1 - half : i) / half;
      const double r = radius * std::cos(elevation);
      solid.AddRing(r, r, end * half_length + radius * std::sin(elevation));
    }
  }
  return solid.Close(-half_length - radius, half_length + radius);
}

std::vector<Triangle> Cylinder(const mjVisual& visual, double radius, double half_length) {
  Turned solid(visual.quality.numslices);
  for (const double z : {-half_length, half_length}) solid.AddRing(radius, radius, z);
  return solid.Close(-half_length, half_length);
}

std::vector<Triangle> Box(const Vector3d& size) {
  const auto corner = [&size](int x, int y, int z) {
    return Vector3d(x * size.x(), y * size.y(), z * size.z());
  };
  std::vector<Triangle> triangles;
  AddQuad(corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1), &triangles);
  AddQuad(corner(-1, 1, -1), corner(1, 1, -1), corner(1, -1, -1), corner(-1, -1, -1), &triangles);
  AddQuad(corner(1, -1, -1), corner(1, 1, -1), corner(1, 1, 1), corner(1, -1, 1), &triangles);
  AddQuad(corner(-1, 1, -1), corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), &triangles);
  AddQuad(corner(-1, -1, -1), corner(1, -1, -1), corner(1, -1, 1), corner(-1, -1, 1), &triangles);
  AddQuad(corner(1, 1, -1), corner(-1, 1, -1), corner(-1, 1, 1), corner(1, 1, 1), &triangles);
  return triangles;
}

/// A plane without end in a direction has size 0 there; it is drawn beyond any camera's far plane.
std::vector<Triangle> Plane(const Vector3d& size) {
  constexpr double kEndless_m = 1e4;
  const double x = size.x() > 0 ? size.x() : kEndless_m;
  const double y = size.y() > 0 ? size.y() : kEndless_m;
  std::vector<Triangle> triangles;
  AddQuad({-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}, &triangles);
  return triangles;
}

std::vector<Triangle> Mesh(const mjModel& model, int mesh) {
  const float* vertices = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
  const int* faces = model.mesh_face + 3 * model.mesh_faceadr[mesh];
  const auto corner = [vertices](int index) {
    return Vector3d(Eigen::Map<const Eigen::Vector3f>(vertices + 3 * index).cast<double>());
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < model.mesh_facenum[mesh]; ++i) {
    triangles.push_back({corner(faces[3 * i]), corner(faces[3 * i + 1]), corner(faces[3 * i + 2])});
  }
  return triangles;
}

}  // namespace

bool IsDrawn(const mjModel& model, int geom) {
  const float* rgba = model.geom_rgba + 4 * geom;
  const int material = model.geom_matid[geom];
  const bool own_colour =
      material < 0 || rgba[0] != 0.5f || rgba[1] != 0.5f || rgba[2] != 0.5f || rgba[3] != 1.0f;
  const float alpha = own_colour ? rgba[3] : model.mat_rgba[4 * material + 3];
  return model.geom_group[geom] < kVisibleGroups && alpha > 0;
}

std::vector<Triangle> DrawnTriangles(const mjModel& model, int geom) {
  const Eigen::Map<const Vector3d> size(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_PLANE:
      return Plane(size);
    case mjGEOM_SPHERE:
      return Ellipsoid(model.vis, Vector3d::Constant(size[0]));
    case mjGEOM_ELLIPSOID:
      return Ellipsoid(model.vis, size);
    case mjGEOM_CAPSULE:
      return Capsule(model.vis, size[0], size[1]);
    case mjGEOM_CYLINDER:
      return Cylinder(model.vis, size[0], size[1]);
    case mjGEOM_BOX:
      return Box(size);
    case mjGEOM_MESH:
      return Mesh(model, model.geom_dataid[geom]);
    default:
      throw SceneError(
          fmt::format("geom {}: truth knows no height fields; make it of boxes or a "
                      "mesh, or move it to a group above 2",
                      geom));
  }
}

bool IsTwoSided(const mjModel& model, int geom) { return model.geom_type[geom] == mjGEOM_PLANE; }

Vector3d SurfaceNormal(const mjModel& model, int geom, const Vector3d& p_G,
                       const Vector3d& facet_normal) {
  const Eigen::Map<const Vector3d> size(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return p_G.normalized();
    case mjGEOM_ELLIPSOID:
      return p_G.cwiseQuotient(size.cwiseAbs2()).normalized();
    case mjGEOM_CAPSULE:
      return (p_G - Vector3d(0, 0, std::clamp(p_G.z(), -size[1], size[1]))).normalized();
    case mjGEOM_CYLINDER:
      if (std::abs(facet_normal.z()) > 0.5) return facet_normal;  // an end
      return Vector3d(p_G.x(), p_G.y(), 0).normalized();
    default:
      return facet_normal;
  }
}

}  // namespace horopter::sim
