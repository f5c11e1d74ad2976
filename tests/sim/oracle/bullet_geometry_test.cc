// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/bullet_geometry.h"

#include <gtest/gtest.h>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::Pose;

TEST(BulletPose, MapsPointsAsTheEigenPoseDoesAndAsMujocoMeansItsQuaternion) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Quaterniond q = RandomRotation(&random);
    const Vector3d position = RandomPoint(&random, 2), p = RandomPoint(&random, 2);
    const mjtNum wxyz[4] = {q.w(), q.x(), q.y(), q.z()};
    mjtNum matrix[9], rotated[3];
    mju_quat2Mat(matrix, wxyz);
    mju_rotVecQuat(rotated, p.data(), wxyz);
    const Vector3d expected = position + Vector3d(rotated[0], rotated[1], rotated[2]);

    const Pose X = PoseFromMujoco(position.data(), matrix);
    EXPECT_LT((X * p - expected).norm(), 1e-12);
    EXPECT_LT((FromBullet(ToBullet(X) * ToBullet(p)) - expected).norm(), 1e-12);
    // Bullet's own reading of the rotation: its quaternions are xyzw.
    const btQuaternion b = ToBullet(X).getRotation();
    EXPECT_NEAR(std::abs(b.x() * q.x() + b.y() * q.y() + b.z() * q.z() + b.w() * q.w()), 1, 1e-12);
  }
}

/// Farthest extent of a shape along each of its own axes.
Vector3d HalfExtents(const btConvexShape& shape) {
  Vector3d extents;
  for (int axis = 0; axis < 3; ++axis) {
    const btVector3 direction = ToBullet(Vector3d(Vector3d::Unit(axis)));
    extents[axis] = shape.localGetSupportingVertex(direction)[axis];
  }
  return extents;
}

TEST(BulletShape, EveryTypeHasMujocosAxesAndSizesWithoutAMargin) {
  OracleScene scene(R"(
      <geom name="sphere" type="sphere" size="0.3"/>
      <geom name="capsule" type="capsule" size="0.1 0.4"/>
      <geom name="cylinder" type="cylinder" size="0.1 0.4"/>
      <geom name="box" type="box" size="0.1 0.2 0.4"/>
      <geom name="ellipsoid" type="ellipsoid" size="0.1 0.2 0.4"/>
      <geom name="plane" type="plane" size="1 1 1"/>)");
  const auto extents = [&](const std::string& name) {
    return HalfExtents(*MakeConvexShape(scene.world().model(), scene.Geom(name)));
  };
  EXPECT_LT((extents("sphere") - Vector3d(0.3, 0.3, 0.3)).norm(), 1e-12);
  EXPECT_LT((extents("capsule") - Vector3d(0.1, 0.1, 0.5)).norm(), 1e-12);
  EXPECT_LT((extents("cylinder") - Vector3d(0.1, 0.1, 0.4)).norm(), 1e-12);
  EXPECT_LT((extents("box") - Vector3d(0.1, 0.2, 0.4)).norm(), 1e-12);
  EXPECT_LT((extents("ellipsoid") - Vector3d(0.1, 0.2, 0.4)).norm(), 1e-12);
  EXPECT_EQ(MakeConvexShape(scene.world().model(), scene.Geom("plane")), nullptr);
}

TEST(BulletShape, SupportOfAnEllipsoidIsOnItsSurfaceWhereTheNormalIsTheDirection) {
  OracleScene scene(R"(<geom name="e" type="ellipsoid" size="0.1 0.2 0.4"/>)");
  const auto shape = MakeConvexShape(scene.world().model(), scene.Geom("e"));
  const Eigen::Array3d semi_axes(0.1, 0.2, 0.4);
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    const Vector3d direction = RandomPoint(&random, 1).normalized();
    const Vector3d p = FromBullet(shape->localGetSupportingVertex(ToBullet(direction)));
    EXPECT_NEAR((p.array() / semi_axes).square().sum(), 1, 1e-12);
    const Vector3d normal = (p.array() / semi_axes.square()).matrix().normalized();
    EXPECT_LT((normal - direction).norm(), 1e-12);
  }
}

TEST(BulletShape, AMeshIsItsConvexHull) {
  // An L-shaped outline, extruded: the hull cuts off the notch.
  const std::string vertices =
      "0 0 0  2 0 0  2 1 0  1 1 0  1 2 0  0 2 0  0 0 1  2 0 1  2 1 1  1 1 1  1 2 1  0 2 1";
  OracleScene scene(R"(<geom name="mesh" type="mesh" mesh="l"/>)",
                    "<mesh name=\"l\" vertex=\"" + vertices + "\"/>");
  const mjModel& model = scene.world().model();
  const auto shape = MakeConvexShape(model, scene.Geom("mesh"));
  ASSERT_NE(shape, nullptr);
  for (int i = 0; i < model.mesh_vertnum[0]; ++i) {
    const float* v = model.mesh_vert + 3 * i;
    for (const Vector3d& d : {Vector3d(1, 2, 3), Vector3d(-1, 0.5, 0), Vector3d(0, 0, -1)}) {
      const double support = d.dot(FromBullet(shape->localGetSupportingVertex(ToBullet(d))));
      EXPECT_GE(support, d.dot(Vector3d(v[0], v[1], v[2])) - 1e-9);
    }
  }
}

TEST(GeomLabel, SaysWhereANamelessGeomIs) {
  OracleScene scene(R"(<body name="shelf"><geom size="1"/><geom name="board" size="1"/></body>)");
  EXPECT_EQ(GeomLabel(scene.world().model(), 0), "geom 0 of body 'shelf'");
  EXPECT_EQ(GeomLabel(scene.world().model(), 1), "board");
}

}  // namespace
}  // namespace horopter::sim
