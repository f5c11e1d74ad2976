// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/koala_truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/oracle/bullet_geometry.h"
#include "sim/truth/fixation_error.h"

namespace horopter::scenarios {
namespace {

constexpr double kDegrees = 180 / M_PI;

std::string NameOf(const mjModel& model, int type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name == nullptr ? "" : name;
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
    case mjGEOM_PLANE:  // an upright one is a line on a plan
      points.emplace_back(-size[0], 0, 0);
      points.emplace_back(size[0], 0, 0);
      break;
    default:  // the bounding sphere's equator: meshes, spheres and ellipsoids are round on a plan
      for (int i = 0; i < 24; ++i) {
        const double a = 2 * M_PI * i / 24, r = model.geom_rbound[geom];
        points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
      }
  }
  return points;
}

std::string KindOf(std::string_view name) {
  if (name.starts_with("obstacle")) return "obstacle";
  if (name.ends_with("wall")) return "wall";
  if (name.starts_with("board")) return "board";
  return "furniture";
}

/// The oracle refuses shapes that it does not know, and those come with the scene.
sim::CollisionOracle OracleOf(const sim::World& world) {
  try {
    return sim::CollisionOracle(world.model());
  } catch (const std::invalid_argument& error) {
    throw sim::SceneError(world.path().string() + ": " + error.what());
  }
}

}  // namespace

double WorseEye(double left, double right) {
  return std::isnan(left) || std::isnan(right) ? std::nan("") : std::max(left, right);
}

KoalaTruth::KoalaTruth(sim::KoalaSimulation& simulation, hardware::StageTimes& times)
    : simulation_(simulation),
      times_(times),
      oracle_(OracleOf(simulation.world())),
      shapes_(std::make_shared<sim::SceneShapes>(simulation.world().model())) {
  const mjModel& model = simulation.world().model();
  robot_body_ = simulation.world().Id(mjOBJ_BODY, "base");
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.body_rootid[model.geom_bodyid[geom]] == robot_body_) robot_geoms_.insert(geom);
    if (sim::IsFloor(model, geom)) floor_geoms_.insert(geom);
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
  return hardware::ToPose2(simulation_.X_WO().inverse() * simulation_.world().X_WBody("base"));
}

double KoalaTruth::Clearance() {
  return times_.Measure("truth", [this] {
    oracle_.Sync(simulation_.world().data());
    return oracle_.ClearanceOf(robot_body_).distance_m;
  });
}

double KoalaTruth::FixationErrorDeg(const Eigen::Vector3d& p_OT) {
  const Eigen::Vector3d p_WT = simulation_.X_WO() * p_OT;
  const auto error = [&](hardware::Eye eye) {
    return sim::FixationError(simulation_.world().X_WCamera(ToString(eye)), p_WT);
  };
  return WorseEye(error(hardware::Eye::kLeft), error(hardware::Eye::kRight)) * kDegrees;
}

FrameTruth KoalaTruth::AtCapture() {
  return times_.Measure("truth", [this] {
    FrameTruth truth;
    simulation_.AtCapture(hardware::Eye::kLeft, [&] {
      const sim::World& world = simulation_.world();
      const sim::EyeTruth seen = sim::CaptureEyeTruth(
          sim::SceneSnapshot(shapes_, world.data()),
          {world.X_WCamera(ToString(hardware::Eye::kLeft)), simulation_.camera_model()});
      truth = {seen.depth, BoardPixels(seen)};
    });
    return truth;
  });
}

cv::Mat1b KoalaTruth::BoardPixels(const sim::EyeTruth& seen) const {
  const sim::World& world = simulation_.world();
  const int board = mj_name2id(&world.model(), mjOBJ_GEOM, "board");
  const int pattern = mj_name2id(&world.model(), mjOBJ_SITE, "board_pattern");
  if (board < 0 || pattern < 0) return {};
  const hardware::Pose X_WS = sim::PoseFromMujoco(world.data().site_xpos + 3 * pattern,
                                                  world.data().site_xmat + 9 * pattern);
  const hardware::Pose X_SC = X_WS.inverse() * seen.view.X_WC;
  const Eigen::Map<const Eigen::Vector3d> half(world.model().site_size + 3 * pattern);
  cv::Mat1b pixels = cv::Mat1b::zeros(seen.ids.size());
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      if (seen.ids(y, x) != board) continue;
      const auto ray_C = seen.view.camera.Unproject(Eigen::Vector2d(x, y));
      const Eigen::Vector3d p_S = X_SC * Eigen::Vector3d(seen.depth(y, x) * *ray_C);
      const bool inside = (p_S.cwiseAbs().tail<2>() - half.tail<2>()).maxCoeff() <= 0;
      pixels(y, x) = inside ? 255 : 0;
    }
  }
  return pixels;
}

PlanRecord KoalaTruth::Plan() {
  const mjModel& model = simulation_.world().model();
  const mjData& data = simulation_.world().data();
  const hardware::Pose X_OW = simulation_.X_WO().inverse();
  // Geoms of one body are one thing; those of the world itself stand alone.
  std::map<std::pair<int, int>, std::vector<cv::Point2f>> things;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || robot_geoms_.count(geom) > 0 || floor_geoms_.count(geom) > 0) continue;
    const int body = model.geom_bodyid[geom];
    auto& outline = things[{body, body == 0 ? geom : -1}];
    const hardware::Pose X_OG =
        X_OW * sim::PoseFromMujoco(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom);
    for (const Eigen::Vector3d& p_GP : OutlinePoints(model, geom)) {
      const Eigen::Vector3d p_O = X_OG * p_GP;
      outline.emplace_back(static_cast<float>(p_O.x()), static_cast<float>(p_O.y()));
    }
  }
  PlanRecord plan;
  for (const auto& [thing, points] : things) {
    const auto [body, geom] = thing;
    const std::string name =
        geom >= 0 ? NameOf(model, mjOBJ_GEOM, geom) : NameOf(model, mjOBJ_BODY, body);
    std::vector<cv::Point2f> hull;
    cv::convexHull(points, hull);
    PlanShape shape{name, KindOf(name), {}};
    for (const cv::Point2f& p : hull) shape.outline_m.emplace_back(p.x, p.y);
    plan.shapes.push_back(std::move(shape));
  }
  return plan;
}

}  // namespace horopter::scenarios
