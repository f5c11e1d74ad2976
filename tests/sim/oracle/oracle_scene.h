// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <memory>
#include <random>
#include <string>

#include "sim/oracle/collision_oracle.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// A world of geoms written as MJCF, and the oracle of it.
class OracleScene {
 public:
  /// @param worldbody what stands between <worldbody> tags
  /// @param asset what stands between <asset> tags
  explicit OracleScene(const std::string& worldbody, const std::string& asset = "")
      : world_(World::FromXml(fmt::format(
            "<mujoco><asset>{}</asset><worldbody>{}</worldbody></mujoco>", asset, worldbody))),
        oracle_(world_->model()) {
    Sync();
  }

  World& world() { return *world_; }
  CollisionOracle& oracle() { return oracle_; }
  int Geom(const std::string& name) const { return world_->Id(mjOBJ_GEOM, name); }
  int Body(const std::string& name) const { return world_->Id(mjOBJ_BODY, name); }
  double Distance(const std::string& a, const std::string& b) const {
    return oracle_.Distance(Geom(a), Geom(b));
  }

  void Sync() {
    world_->Forward();
    oracle_.Sync(world_->data());
  }

 private:
  std::unique_ptr<World> world_;
  CollisionOracle oracle_;
};

inline Eigen::Quaterniond RandomRotation(std::mt19937* random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(*random), normal(*random), normal(*random), normal(*random))
      .normalized();
}

inline Eigen::Vector3d RandomPoint(std::mt19937* random, double half_width) {
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  return {uniform(*random), uniform(*random), uniform(*random)};
}

/// `pos="x y z" quat="w x y z"`.
inline std::string PoseAttributes(const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
  return fmt::format("pos=\"{:.17g} {:.17g} {:.17g}\" quat=\"{:.17g} {:.17g} {:.17g} {:.17g}\"",
                     p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
}

}  // namespace horopter::sim
