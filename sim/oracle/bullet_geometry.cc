// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/bullet_geometry.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <LinearMath/btConvexHullComputer.h>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

static_assert(sizeof(btScalar) == sizeof(double),
              "the oracle needs Bullet in double precision: link bullet-float64");

namespace horopter::sim {
namespace {

/// Bullet has no ellipsoid; its support mapping is closed: A^2 d / |A d|, A = diag(semi-axes).
class EllipsoidShape final : public btConvexInternalShape {
 public:
  explicit EllipsoidShape(const btVector3& semi_axes) : semi_axes_(semi_axes) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0;
  }

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    const btVector3 stretched = semi_axes_ * direction;
    const btScalar length = stretched.length();
    if (length < SIMD_EPSILON) return {0, 0, semi_axes_.z()};
    return semi_axes_ * stretched / length;
  }

  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* vectors,
                                                         btVector3* supports,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) supports[i] = localGetSupportingVertexWithoutMargin(vectors[i]);
  }

  void getAabb(const btTransform& X_WG, btVector3& lower, btVector3& upper) const override {
    btVector3 reach;
    for (int i = 0; i < 3; ++i) reach[i] = (X_WG.getBasis()[i] * semi_axes_).length();
    lower = X_WG.getOrigin() - reach;
    upper = X_WG.getOrigin() + reach;
  }

  /// Of a homogeneous solid; the oracle has no dynamics, but Bullet's interface asks.
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override {
    const btVector3 s = semi_axes_ * semi_axes_;
    inertia = btVector3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()) * (mass / 5);
  }

  const char* getName() const override { return "Ellipsoid"; }

 private:
  btVector3 semi_axes_;
};

std::unique_ptr<btConvexShape> MakeHull(const mjModel& model, int mesh) {
  const float* vertices = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
  btConvexHullComputer hull;
  hull.compute(vertices, 3 * sizeof(float), model.mesh_vertnum[mesh], 0, 0);
  auto shape = std::make_unique<btConvexHullShape>();
  for (int i = 0; i < hull.vertices.size(); ++i) shape->addPoint(hull.vertices[i], false);
  shape->setMargin(0);
  shape->recalcLocalAabb();
  return shape;
}

template <typename Shape, typename... Arguments>
std::unique_ptr<btConvexShape> WithoutMargin(Arguments&&... arguments) {
  auto shape = std::make_unique<Shape>(std::forward<Arguments>(arguments)...);
  shape->setMargin(0);  // also gives back what the default margin took from the half extents
  return shape;
}

}  // namespace

btTransform ToBullet(const hardware::Pose& X_AB) {
  const Eigen::Matrix3d R = X_AB.linear();
  const btMatrix3x3 basis(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                          R(2, 2));
  return btTransform(basis, ToBullet(Eigen::Vector3d(X_AB.translation())));
}

btVector3 ToBullet(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Eigen::Vector3d FromBullet(const btVector3& p) { return {p.x(), p.y(), p.z()}; }

hardware::Pose PoseFromMujoco(const mjtNum position[3], const mjtNum rotation[9]) {
  hardware::Pose X = hardware::Pose::Identity();
  X.translation() = Eigen::Map<const Eigen::Vector3d>(position);
  X.linear() = Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(rotation);
  return X;
}

std::unique_ptr<btConvexShape> MakeConvexShape(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_PLANE:
      return nullptr;
    // The margin of these two *is* the radius around an exact core.
    case mjGEOM_SPHERE:
      return std::make_unique<btSphereShape>(size[0]);
    case mjGEOM_CAPSULE:
      return std::make_unique<btCapsuleShapeZ>(size[0], 2 * size[1]);
    case mjGEOM_CYLINDER:
      return WithoutMargin<btCylinderShapeZ>(btVector3(size[0], size[0], size[1]));
    case mjGEOM_BOX:
      return WithoutMargin<btBoxShape>(btVector3(size[0], size[1], size[2]));
    case mjGEOM_ELLIPSOID:
      return std::make_unique<EllipsoidShape>(btVector3(size[0], size[1], size[2]));
    case mjGEOM_MESH:
      return MakeHull(model, model.geom_dataid[geom]);
    default:
      throw std::invalid_argument(
          fmt::format("collision oracle: {} is a height field or another type that is not convex; "
                      "build it from boxes or meshes, or give it contype=\"0\" conaffinity=\"0\"",
                      GeomLabel(model, geom)));
  }
}

std::string GeomLabel(const mjModel& model, int geom) {
  if (const char* name = mj_id2name(&model, mjOBJ_GEOM, geom)) return name;
  const int body = model.geom_bodyid[geom];
  const char* body_name = mj_id2name(&model, mjOBJ_BODY, body);
  return fmt::format("geom {} of body {}", geom,
                     body_name ? fmt::format("'{}'", body_name) : fmt::format("{}", body));
}

bool IsFloor(const mjModel& model, int geom) {
  const auto named_floor = [&model](int type, int id) {
    const char* name = mj_id2name(&model, type, id);
    return name != nullptr && std::string_view(name) == "floor";
  };
  if (named_floor(mjOBJ_GEOM, geom) || named_floor(mjOBJ_BODY, model.geom_bodyid[geom]))
    return true;
  if (model.geom_type[geom] != mjGEOM_PLANE || model.geom_bodyid[geom] != 0) return false;
  mjtNum rotation[9];
  mju_quat2Mat(rotation, model.geom_quat + 4 * geom);
  constexpr double kCosTenDegrees = 0.9848;
  return rotation[8] > kCosTenDegrees;
}

}  // namespace horopter::sim
