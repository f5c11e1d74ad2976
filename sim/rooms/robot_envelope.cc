// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/robot_envelope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/variation/footprint.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

/// Corners of a geom's own bounding box, in the base frame.
Eigen::Matrix<double, 3, 8> Corners(const World& world, int geom, const hardware::Pose& X_BW) {
  const mjtNum* size = world.model().geom_size + 3 * geom;
  Vector3d half(size[0], size[1], size[2]);
  const int type = world.model().geom_type[geom];
  if (type == mjGEOM_CYLINDER) half = {size[0], size[0], size[1]};
  if (type == mjGEOM_CAPSULE) half = {size[0], size[0], size[0] + size[1]};
  if (type == mjGEOM_SPHERE || type == mjGEOM_MESH) {
    half = Vector3d::Constant(world.model().geom_rbound[geom]);
  }
  hardware::Pose X_WG = hardware::Pose::Identity();
  X_WG.translation() = Eigen::Map<const Vector3d>(world.data().geom_xpos + 3 * geom);
  X_WG.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      world.data().geom_xmat + 9 * geom);
  Eigen::Matrix<double, 3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    corners.col(i) = X_BW * (X_WG * Vector3d(sign.cwiseProduct(half)));
  }
  return corners;
}

}  // namespace

RobotEnvelope EnvelopeOf(const World& world, std::string_view base_body) {
  const mjModel& model = world.model();
  const int base = world.Id(mjOBJ_BODY, base_body);
  const hardware::Pose X_BW = world.X_WBody(base_body).inverse();
  RobotEnvelope envelope;
  envelope.outer.bottom_m = std::numeric_limits<double>::infinity();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || !RidesOn(world, geom, base)) continue;
    const Eigen::Matrix<double, 3, 8> corners = Corners(world, geom, X_BW);
    UprightCylinder& outer = envelope.outer;
    outer.radius_m = std::max(outer.radius_m, corners.topRows<2>().colwise().norm().maxCoeff());
    outer.bottom_m = std::min(outer.bottom_m, corners.row(2).minCoeff());
    outer.top_m = std::max(outer.top_m, corners.row(2).maxCoeff());
    if (model.geom_type[geom] != mjGEOM_BOX) continue;
    // Only a box whose sides are along B's axes fills its extent.
    const Eigen::Array2d low = corners.topRows<2>().rowwise().minCoeff();
    const Eigen::Array2d high = corners.topRows<2>().rowwise().maxCoeff();
    const double within = std::min((-low).minCoeff(), high.minCoeff());
    const bool aligned = std::abs((high - low).prod() - 4 * model.geom_size[3 * geom] *
                                                            model.geom_size[3 * geom + 1]) < 1e-9;
    if (aligned && within > envelope.core.radius_m) {
      envelope.core = {within, corners.row(2).minCoeff(), corners.row(2).maxCoeff()};
    }
  }
  if (envelope.core.radius_m <= 0) {
    throw SceneError(fmt::format("body '{}' has no upright box about its frame", base_body));
  }
  // Wheels reach to the floor, on which the probe must not stand: everything stands there.
  constexpr double kOffFloor_m = 0.005;
  envelope.outer.bottom_m = std::max(envelope.outer.bottom_m, kOffFloor_m);
  return envelope;
}

void AddProbe(SceneDocument& scene, const char* name, const UprightCylinder& cylinder) {
  pugi::xml_node body = scene.AppendSection("worldbody").append_child("body");
  body.append_attribute("name") = name;
  pugi::xml_node geom = body.append_child("geom");
  geom.append_attribute("type") = "cylinder";
  const double middle = (cylinder.bottom_m + cylinder.top_m) / 2;
  geom.append_attribute("size") =
      MjcfNumbers({cylinder.radius_m, (cylinder.top_m - cylinder.bottom_m) / 2}).c_str();
  geom.append_attribute("pos") = MjcfNumbers({0, 0, middle}).c_str();
  geom.append_attribute("contype") = 1;
  geom.append_attribute("conaffinity") = 2;
}

}  // namespace horopter::sim
