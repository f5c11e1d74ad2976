// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hardware/types/camera_model.h"
#include "sim/oracle/collision_oracle.h"
#include "sim/rooms/room.h"
#include "sim/truth/drawn_shape.h"
#include "sim/truth/scene_snapshot.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Pose;

constexpr double kNear_m = 0.03, kFar_m = 30;
constexpr double kBaseline_m = 0.065;  ///< for telling depth errors in pixels of disparity

bool IsFlat(const mjModel& model, int geom) {
  const int type = model.geom_type[geom];
  return type == mjGEOM_BOX || type == mjGEOM_PLANE || type == mjGEOM_MESH;
}

/// The cameras of a scene, at their own fields of view, 640 pixels wide.
struct Eye {
  std::string name;
  Pose X_WC;
  CameraModel camera;
};

std::vector<Eye> EyesOf(const World& world) {
  std::vector<Eye> eyes;
  for (int i = 0; i < world.model().ncam; ++i) {
    const std::string name = world.Name(mjOBJ_CAMERA, i);
    const double half_height = std::tan(world.model().cam_fovy[i] / 2 * M_PI / 180);
    eyes.push_back({name, world.X_WCamera(name),
                    CameraModel::FromHorizontalFov(640, 480, 2 * std::atan(half_height * 4 / 3))});
  }
  return eyes;
}

/// A Bullet world of what cameras see: either all but meshes, or the hulls that Bullet makes of
/// them.
CollisionOracle OracleOfVisible(World& world, bool meshes) {
  mjModel& model = world.mutable_model();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = IsDrawn(model, geom) && (model.geom_type[geom] == mjGEOM_MESH) == meshes;
    model.geom_contype[geom] = model.geom_conaffinity[geom] = solid ? 1 : 0;
  }
  CollisionOracle oracle(model);
  oracle.Sync(world.data());
  return oracle;
}

/// How far two answers to the same rays lie apart.
struct Disagreement {
  double relative = 0;               ///< of depth, the largest
  std::vector<double> disparity_px;  ///< of a point's place in an eye kBaseline_m to the right

  void Add(double depth, double other, double focal_px) {
    relative = std::max(relative, std::abs(depth - other) / other);
    disparity_px.push_back(focal_px * kBaseline_m * std::abs(1 / depth - 1 / other));
  }
  /// The value that this part of the rays stays below.
  double Disparity(double part) const {
    if (disparity_px.empty()) return 0;
    std::vector<double> sorted = disparity_px;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
  }
};

struct SceneRays {
  Disagreement drawn_flat, drawn_round, bullet_flat, bullet_round;
  Disagreement hull;           ///< of Bullet's hulls with the meshes they are around
  double deepest_hull_m = 0;   ///< by which a mesh lies behind its hull, along a ray
  double farthest_hull_m = 0;  ///< by which a hull lies behind its mesh, which it must not
  int rays = 0;
  int other_geom = 0;         ///< drawn and analytic meet different things: silhouettes
  int other_geom_bullet = 0;  ///< likewise Bullet
};

/// A ray that meets a mesh at `t` against the hulls: none is met later, and the mesh's own is met
/// at the mesh or before.
void AddHull(const CollisionOracle& hulls, const Vector3d& from, const Vector3d& along, double t,
             int geom, double focal_px, SceneRays& result) {
  const auto hit = hulls.CastRay(from, from + (kFar_m + 1) * along);
  if (!hit) {
    ++result.other_geom_bullet;
    return;
  }
  const double depth = hit->distance_m / along.norm();
  result.farthest_hull_m = std::max(result.farthest_hull_m, (depth - t) * along.norm());
  if (hit->geom != geom) return;  // another hull before it
  result.hull.Add(kNear_m + depth, kNear_m + t, focal_px);
  result.deepest_hull_m = std::max(result.deepest_hull_m, (t - depth) * along.norm());
}

/// Casts rays from every camera three ways: at what the renderer draws, at MuJoCo's analytic
/// shapes, and at Bullet's. All begin kNear_m deep, so that no eye looks at its own housing from
/// inside.
SceneRays CastAll(World& world) {
  const SceneSnapshot drawn(std::make_shared<SceneShapes>(world.model()), world.data());
  const std::vector<Eye> eyes = EyesOf(world);
  const CollisionOracle bullet = OracleOfVisible(world, false);
  const CollisionOracle hulls = OracleOfVisible(world, true);
  constexpr mjtByte kGroups[mjNGROUP] = {1, 1, 1, 0, 0, 0};
  SceneRays result;
  for (const Eye& eye : eyes) {
    const double focal_px = eye.camera.intrinsics().fx;
    for (int y = 4; y < 480; y += 16) {
      for (int x = 4; x < 640; x += 16) {
        const Vector3d along = eye.X_WC.linear() * *eye.camera.Unproject(Vector2d(x, y));
        const Vector3d from = eye.X_WC.translation() + kNear_m * along;
        int geom = -1;
        const double t =
            mj_ray(&world.model(), &world.data(), from.data(), along.data(), kGroups, 1, -1, &geom);
        if (t <= 0 || t > kFar_m) continue;
        ++result.rays;
        const bool flat = IsFlat(world.model(), geom);
        const auto seen = drawn.FirstHit(Ray(from, along), 0, kFar_m + 1);
        if (seen && seen->geom == geom) {
          (flat ? result.drawn_flat : result.drawn_round)
              .Add(kNear_m + seen->t, kNear_m + t, focal_px);
        } else {
          ++result.other_geom;
        }
        const bool skipped = (x / 16 + y / 16) % 2 == 1;  // Bullet's are slow
        if (world.model().geom_type[geom] == mjGEOM_MESH) {
          AddHull(hulls, from, along, t, geom, focal_px, result);
          continue;
        }
        if (skipped) continue;
        const auto hit = bullet.CastRay(from, from + (kFar_m + 1) * along);
        if (hit && hit->geom == geom) {
          (flat ? result.bullet_flat : result.bullet_round)
              .Add(kNear_m + hit->distance_m / along.norm(), kNear_m + t, focal_px);
        } else {
          ++result.other_geom_bullet;
        }
      }
    }
  }
  return result;
}

/// A shipped scene, or "rooms/N.xml": the room that the seed N makes.
std::unique_ptr<World> Load(const std::string& name) {
  const std::filesystem::path scenes = std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes";
  const std::string rooms = "rooms/";
  if (name.rfind(rooms, 0) != 0) return std::make_unique<World>(scenes / name);
  RoomConfig config;
  config.scene = scenes / "koala" / "empty_room.xml";
  config.goals_m = {{2.6, 0.2}};
  return World::FromXml(GenerateRoom(config, std::stoull(name.substr(rooms.size()))).mjcf);
}

std::vector<std::string> Scenes() {
  return {"koala/room.xml",  "koala/chessboard_room.xml", "nao/workspace.xml",
          "nao/outdoor.xml", "yorick/tabletop.xml",       "rooms/1.xml",
          "rooms/2.xml"};
}

class SceneRay : public testing::TestWithParam<std::string> {};

std::string TestName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(0, info.param.rfind('.'));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

TEST_P(SceneRay, MujocoBulletAndTheRendererAgreeOnDepth) {
  const std::unique_ptr<World> world = Load(GetParam());
  const SceneRays rays = CastAll(*world);
  const auto record = [](const char* name, const Disagreement& d) {
    testing::Test::RecordProperty(
        name, fmt::format("{:.1e} of depth, {:.4f} px at most, {:.4f} px for 95 %, {} rays",
                          d.relative, d.Disparity(1), d.Disparity(0.95), d.disparity_px.size()));
  };
  record("drawn flat", rays.drawn_flat);
  record("drawn round", rays.drawn_round);
  record("bullet flat", rays.bullet_flat);
  record("bullet round", rays.bullet_round);
  record("bullet hulls of meshes", rays.hull);
  RecordProperty("mesh behind its hull at most [m]", fmt::format("{:.4f}", rays.deepest_hull_m));
  RecordProperty("rays", rays.rays);
  RecordProperty("other geom", rays.other_geom);
  RecordProperty("other geom by bullet", rays.other_geom_bullet);

  EXPECT_GT(rays.drawn_flat.disparity_px.size(), 1000u);
  EXPECT_LT(rays.drawn_flat.relative, 1e-6);
  EXPECT_LT(rays.bullet_flat.relative, 1e-4);
  // Bullet's 1e-6 m off a round surface are more along a ray that grazes it.
  EXPECT_LT(rays.bullet_round.relative, 1e-3);
  // A hull holds its mesh; how far the mesh lies behind it is in the properties.
  EXPECT_LT(rays.farthest_hull_m, 1e-4);
  // What facets leave of round shapes, the most where rays graze them; the numbers of each scene
  // are in the test's properties.
  EXPECT_LT(rays.drawn_round.relative, 0.03);
  EXPECT_LT(rays.drawn_round.Disparity(1), 0.3);
  EXPECT_LT(rays.drawn_round.Disparity(0.95), 0.06);
  EXPECT_LT(rays.other_geom, 0.01 * rays.rays);
  EXPECT_LT(rays.other_geom_bullet, 0.002 * rays.rays + 2);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneRay, testing::ValuesIn(Scenes()), TestName);

}  // namespace
}  // namespace horopter::sim
