// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/koala_truth.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "sim/truth/fixation_error.h"

namespace horopter::scenarios {
namespace {

constexpr double kDegrees = 180 / M_PI;

std::string NameOf(const mjModel& model, int type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name == nullptr ? "" : name;
}

bool IsFloor(const mjModel& model, int geom) {
  return model.geom_type[geom] == mjGEOM_PLANE || NameOf(model, mjOBJ_GEOM, geom) == "floor" ||
         NameOf(model, mjOBJ_BODY, model.geom_bodyid[geom]) == "floor";
}

/// Points of a geom whose hull, seen from above, is the geom's outline.
std::vector<Eigen::Vector3d> OutlinePoints(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  std::vector<Eigen::Vector3d> points;
  switch (model.geom_type[geom]) {
    case mjGEOM_BOX:
      for (int corner = 0; corner < 8; ++corner) {
        points.emplace_back(corner & 1 ? size[0] : -size[0], corner & 2 ? size[1] : -size[1],
                            corner & 4 ? size[2] : -size[2]);
      }
      break;
    case mjGEOM_CYLINDER:
    case mjGEOM_CAPSULE: {
      constexpr int kSides = 24;
      for (int i = 0; i < kSides; ++i) {
        const double a = 2 * M_PI * i / kSides;
        for (const double z : {-size[1], size[1]}) {
          points.emplace_back(size[0] * std::cos(a), size[0] * std::sin(a), z);
        }
      }
      break;
    }
    default:  // the bounding sphere's equator: meshes, spheres and ellipsoids are round on a plan
      for (int i = 0; i < 24; ++i) {
        const double a = 2 * M_PI * i / 24, r = model.geom_rbound[geom];
        points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
      }
  }
  return points;
}

std::string KindOf(std::string_view body, std::string_view geom) {
  const auto begins = [&](std::string_view prefix) {
    return body.substr(0, prefix.size()) == prefix || geom.substr(0, prefix.size()) == prefix;
  };
  if (begins("obstacle")) return "obstacle";
  if (begins("wall")) return "wall";
  if (begins("board")) return "board";
  return "furniture";
}

}  // namespace

KoalaTruth::KoalaTruth(sim::KoalaSimulation& simulation, hardware::StageTimes& times)
    : simulation_(simulation), times_(times), oracle_(simulation.world().model()) {
  const mjModel& model = simulation.world().model();
  robot_body_ = simulation.world().Id(mjOBJ_BODY, "base");
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.body_rootid[model.geom_bodyid[geom]] == robot_body_) robot_geoms_.insert(geom);
    if (IsFloor(model, geom)) floor_geoms_.insert(geom);
  }
  simulation_.OnStep([this](const sim::World& world) { CountContacts(world); });
}

void KoalaTruth::CountContacts(const sim::World& world) {
  std::set<GeomPair> touching;
  for (int i = 0; i < world.data().ncon; ++i) {
    const mjContact& contact = world.data().contact[i];
    const bool first = robot_geoms_.count(contact.geom1) > 0;
    const bool second = robot_geoms_.count(contact.geom2) > 0;
    const int other = first ? contact.geom2 : contact.geom1;
    if (first == second || floor_geoms_.count(other) > 0 || contact.dist > 0) continue;
    touching.emplace(contact.geom1, contact.geom2);
  }
  for (const GeomPair& pair : touching) contacts_ += touching_.count(pair) == 0;
  touching_ = std::move(touching);
}

hardware::Pose2 KoalaTruth::X_OB() {
  const hardware::Pose X = simulation_.X_WO().inverse() * simulation_.world().X_WBody("base");
  return {X.translation().x(), X.translation().y(), std::atan2(X(1, 0), X(0, 0))};
}

double KoalaTruth::Clearance() {
  return times_.Measure("truth", [this] {
    oracle_.Sync(simulation_.world().data());
    return oracle_.ClearanceOf(robot_body_).distance_m;
  });
}

double KoalaTruth::FixationErrorDeg(const Eigen::Vector3d& p_OT) {
  const Eigen::Vector3d p_WT = simulation_.X_WO() * p_OT;
  double worst = 0;
  for (const hardware::Eye eye : hardware::kBothEyes) {
    const hardware::Pose X_WC = simulation_.world().X_WCamera(ToString(eye));
    worst = std::max(worst, sim::FixationError(X_WC, p_WT));
  }
  return worst * kDegrees;
}

FrameTruth KoalaTruth::AtCapture(const hardware::StereoFrame&) {
  return times_.Measure("truth", [this] {
    const sim::RenderedView view = simulation_.RenderTruth(hardware::Eye::kLeft);
    FrameTruth truth;
    truth.depth_m = view.depth;
    const mjModel& model = simulation_.world().model();
    const int board = mj_name2id(&model, mjOBJ_GEOM, "board");
    if (board >= 0) truth.board = view.ids == board;
    return truth;
  });
}

PlanRecord KoalaTruth::Plan() {
  PlanRecord plan;
  const mjModel& model = simulation_.world().model();
  const mjData& data = simulation_.world().data();
  const hardware::Pose X_OW = simulation_.X_WO().inverse();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || robot_geoms_.count(geom) > 0 || floor_geoms_.count(geom) > 0) continue;
    const Eigen::Map<const Eigen::Vector3d> p_WG(data.geom_xpos + 3 * geom);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R_WG(data.geom_xmat +
                                                                              9 * geom);
    std::vector<cv::Point2f> points, hull;
    for (const Eigen::Vector3d& p_GP : OutlinePoints(model, geom)) {
      const Eigen::Vector3d p_O = X_OW * Eigen::Vector3d(R_WG * p_GP + p_WG);
      points.emplace_back(static_cast<float>(p_O.x()), static_cast<float>(p_O.y()));
    }
    cv::convexHull(points, hull);
    const std::string geom_name = NameOf(model, mjOBJ_GEOM, geom);
    const std::string body_name = NameOf(model, mjOBJ_BODY, model.geom_bodyid[geom]);
    PlanShape shape{geom_name.empty() ? body_name : geom_name, KindOf(body_name, geom_name), {}};
    for (const cv::Point2f& p : hull) shape.outline_m.emplace_back(p.x, p.y);
    plan.shapes.push_back(std::move(shape));
  }
  return plan;
}

}  // namespace horopter::scenarios
