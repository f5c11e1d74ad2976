// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;

constexpr double kGap_m = 0.08;        ///< between any two things
constexpr double kScreenGap_m = 0.06;  ///< between two screens: nothing of a robot's size passes
constexpr double kLongestScreen_m = 1.3;

/// A place about the way, or anywhere; the first obstacle's is right in the way.
Vector2d DrawPlace(RandomStream& random, const FloorPlan& plan, const Scatter& scatter,
                   bool first) {
  const double about = random.Uniform(0, 1), along = random.Uniform(0, 1);
  const double aside = random.Gaussian();
  const Vector2d anywhere(random.Uniform(plan.floor.min().x(), plan.floor.max().x()),
                          random.Uniform(plan.floor.min().y(), plan.floor.max().y()));
  constexpr double kShareAboutTheWay = 0.6;
  if (!scatter.in_the_way || (!first && about > kShareAboutTheWay)) return anywhere;
  const auto leg = static_cast<std::size_t>(random.Uniform(0, scatter.way.size() - 1.0));
  const Vector2d from = scatter.way[leg], way = scatter.way[leg + 1] - from;
  const Vector2d left = Vector2d(-way.y(), way.x()).normalized();
  if (first) return from + (0.35 + 0.3 * along) * way + 0.08 * aside * left;
  return from + (0.2 + 1.0 * along) * way + 0.75 * aside * left;
}

bool PlaceOne(Obstacle& obstacle, const FloorPlan& plan, const Scatter& scatter, bool first,
              RandomStream& random) {
  constexpr int kMostDraws = 100;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Vector2d p = DrawPlace(random, plan, scatter, first && draw < kMostDraws / 2);
    const double heading = random.Uniform(-M_PI, M_PI);
    if (!plan.Fits({p, obstacle.radius_m()}, kGap_m)) continue;
    obstacle.X_WO = {p.x(), p.y(), heading};
    return true;
  }
  return false;
}

struct Interval {
  double low;
  double high;
};

/// What a strip across the room leaves free between its walls and the furniture in it; nothing when
/// something in it is no barrier: does not reach from the floor to `height_m`.
std::optional<std::vector<Interval>> GapsAcross(const FloorPlan& plan, int along, double line,
                                                double half_width_m, double height_m) {
  constexpr double kOnTheWall_m = 0.1;    // pictures and doors leave no way past a screen
  constexpr double kNarrow_m = 0.22;      // nothing of a robot's size passes
  constexpr double kUnderneath_m = 0.05;  // likewise
  const int across = 1 - along;
  const double low = plan.floor.min()[across], high = plan.floor.max()[across];
  std::vector<Interval> taken{{high, high}};
  for (const Furniture& thing : plan.furniture) {
    const Footprint& f = thing.footprint;
    if (f.max()[along] < line - half_width_m || f.min()[along] > line + half_width_m) continue;
    const bool hung = f.max()[across] < low + kOnTheWall_m || f.min()[across] > high - kOnTheWall_m;
    if (hung) continue;
    if (thing.bottom_m > kUnderneath_m || thing.top_m < height_m) return std::nullopt;
    taken.push_back({f.min()[across], f.max()[across]});
  }
  std::sort(taken.begin(), taken.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::vector<Interval> gaps;
  double reached = low;
  for (const Interval& t : taken) {
    if (t.low - reached > kNarrow_m) gaps.push_back({reached, t.low});
    reached = std::max(reached, t.high);
  }
  return gaps;
}

double HalfHeight(const World& world, int geom) {
  const mjtNum* size = world.model().geom_size + 3 * geom;
  const mjtNum* R = world.data().geom_xmat + 9 * geom;
  switch (world.model().geom_type[geom]) {
    case mjGEOM_BOX:
      return std::abs(R[6]) * size[0] + std::abs(R[7]) * size[1] + std::abs(R[8]) * size[2];
    case mjGEOM_CYLINDER:
      return std::sqrt(std::max(0.0, 1 - R[8] * R[8])) * size[0] + std::abs(R[8]) * size[1];
    default:
      return world.model().geom_rbound[geom];
  }
}

}  // namespace

bool FloorPlan::Fits(const Disc& disc, double gap_m) const {
  const double reach = disc.radius_m + gap_m;
  const Vector2d margin = Vector2d::Constant(reach);
  const Footprint inner(floor.min() + margin, floor.max() - margin);
  if (!inner.contains(disc.centre_m)) return false;
  for (const Furniture& thing : furniture) {
    if (thing.footprint.exteriorDistance(disc.centre_m) < reach) return false;
  }
  return std::all_of(discs.begin(), discs.end(), [&](const Disc& other) {
    return (other.centre_m - disc.centre_m).norm() >= reach + other.radius_m;
  });
}

FloorPlan PlanOf(const World& world, int robot, const std::vector<int>& others) {
  const mjModel& model = world.model();
  FloorPlan plan;
  const int floor = world.Id(mjOBJ_GEOM, "floor");
  const Vector2d middle(world.data().geom_xpos[3 * floor], world.data().geom_xpos[3 * floor + 1]);
  const Vector2d half(model.geom_size[3 * floor], model.geom_size[3 * floor + 1]);
  plan.floor = Footprint(middle - half, middle + half);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || model.geom_type[geom] == mjGEOM_PLANE || RidesOn(world, geom, robot)) continue;
    const bool left_out = std::any_of(others.begin(), others.end(),
                                      [&](int body) { return RidesOn(world, geom, body); });
    if (left_out) continue;
    const double z = world.data().geom_xpos[3 * geom + 2], half_m = HalfHeight(world, geom);
    plan.furniture.push_back({FootprintOf(world, geom), z - half_m, z + half_m});
  }
  return plan;
}

bool Place(std::vector<Obstacle>& obstacles, FloorPlan plan, const Scatter& scatter,
           std::uint64_t seed, int attempt) {
  RandomStream random(seed, fmt::format("room.places.{}", attempt));
  for (const Vector2d& p : scatter.way) plan.discs.push_back({p, scatter.keep_out_m});
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!PlaceOne(obstacles[i], plan, scatter, i == 0, random)) return false;
    const hardware::Pose2& X = obstacles[i].X_WO;
    plan.discs.push_back({{X.x_m, X.y_m}, obstacles[i].radius_m()});
  }
  return true;
}

Footprint FootprintOf(const Obstacle& screen) {
  const double c = std::abs(std::cos(screen.X_WO.heading_rad));
  const double s = std::abs(std::sin(screen.X_WO.heading_rad));
  const Vector2d half(c * screen.size_m.x() + s * screen.size_m.y(),
                      s * screen.size_m.x() + c * screen.size_m.y());
  const Vector2d middle(screen.X_WO.x_m, screen.X_WO.y_m);
  return Footprint(middle - half / 2, middle + half / 2);
}

std::vector<Obstacle> DrawBarrier(const FloorPlan& plan, const Scatter& scatter, double height_m,
                                  int index, std::uint64_t seed, int attempt) {
  RandomStream random(seed, fmt::format("room.barrier.{}", attempt));
  const Vector2d start = scatter.way.at(0), way = scatter.way.at(1) - start;
  const int along = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1, across = 1 - along;
  const double half_depth_m = DrawScreen(index, kLongestScreen_m, seed).size_m.y() / 2;
  const double least = scatter.keep_out_m + half_depth_m, most = std::abs(way[along]) - least;
  constexpr int kMostDraws = 100;
  for (int draw = 0; draw < kMostDraws && least < most; ++draw) {
    const double line = start[along] + std::copysign(random.Uniform(least, most), way[along]);
    const auto gaps = GapsAcross(plan, along, line, half_depth_m + kScreenGap_m, height_m);
    if (!gaps) continue;
    std::vector<Obstacle> screens;
    for (const Interval& gap : *gaps) {
      const int count = static_cast<int>(std::ceil((gap.high - gap.low) / kLongestScreen_m));
      const double length_m = (gap.high - gap.low - (count + 1) * kScreenGap_m) / count;
      for (int i = 0; i < count; ++i) {
        Obstacle screen = DrawScreen(index + static_cast<int>(screens.size()), length_m, seed);
        Vector2d middle;
        middle[along] = line;
        middle[across] = gap.low + kScreenGap_m + length_m / 2 + i * (length_m + kScreenGap_m);
        screen.X_WO = {middle.x(), middle.y(), along == 0 ? M_PI / 2 : 0};
        screens.push_back(screen);
      }
    }
    return screens;
  }
  return {};
}

}  // namespace horopter::sim
