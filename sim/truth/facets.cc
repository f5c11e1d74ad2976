// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/facets.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

constexpr int kLeafFacets = 2;

/// Facets overlap by this part of their size, so that no ray slips between two.
constexpr double kOverlap = 1e-10;

Eigen::AlignedBox3d BoxOf(const Triangle& triangle) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : {triangle.a, triangle.b, triangle.c}) box.extend(corner);
  const Vector3d margin = Vector3d::Constant(1e-9 * (1 + box.sizes().maxCoeff()));
  return {box.min() - margin, box.max() + margin};
}

std::vector<Eigen::AlignedBox3d> BoxesOf(const std::vector<Triangle>& triangles) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Triangle& triangle : triangles) boxes.push_back(BoxOf(triangle));
  return boxes;
}

}  // namespace

Facets::Facets(const std::vector<Triangle>& triangles, bool two_sided)
    : two_sided_(two_sided), tree_(BoxesOf(triangles), kLeafFacets) {
  for (const Triangle& triangle : triangles) {
    facets_.push_back({triangle.a, triangle.b - triangle.a, triangle.c - triangle.a});
    bounds_.extend(BoxOf(triangle));
  }
}

/// @return NaN when the ray misses the facet or comes from behind it
double Facets::Meet(const Ray& ray, const Facet& facet) const {
  constexpr double kMiss = std::numeric_limits<double>::quiet_NaN();
  const Vector3d across = ray.direction.cross(facet.ac);
  const double facing = facet.ab.dot(across);  // positive from outside
  if (facing == 0 || (facing < 0 && !two_sided_)) return kMiss;
  const Vector3d from_a = ray.origin - facet.a;
  const double u = from_a.dot(across) / facing;
  if (!(u >= -kOverlap && u <= 1 + kOverlap)) return kMiss;
  const Vector3d beside = from_a.cross(facet.ab);
  const double v = ray.direction.dot(beside) / facing;
  if (!(v >= -kOverlap && u + v <= 1 + kOverlap)) return kMiss;
  return facet.ac.dot(beside) / facing;
}

std::optional<FacetHit> Facets::FirstHit(const Ray& ray, double t_min, double t_max) const {
  int nearest = -1;
  double t_nearest = t_max;
  tree_.Traverse(ray, t_min, t_max, [&](int item, double t_limit) {
    const double t = Meet(ray, facets_[static_cast<std::size_t>(item)]);
    if (!(t >= t_min && t <= t_limit)) return t_limit;
    nearest = item;
    t_nearest = t;
    return t;
  });
  if (nearest < 0) return std::nullopt;
  const Facet& facet = facets_[static_cast<std::size_t>(nearest)];
  return FacetHit{t_nearest, facet.ab.cross(facet.ac).normalized()};
}

}  // namespace horopter::sim
