// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>
#include <vector>

namespace horopter::sim {

/// A ray with its reciprocal direction. Parameters t are in units of the direction's length.
struct Ray {
  Ray(const Eigen::Vector3d& from, const Eigen::Vector3d& along);

  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
  Eigen::Vector3d inverse;  ///< of the direction, component by component; finite
};

/// Axis-aligned boxes in a binary tree, for finding those that a ray passes through.
class BoxTree {
 public:
  /// Splits at the median of the longest axis; ties by index, so that the tree is a function of the
  /// boxes alone.
  /// @param leaf_items up to as many boxes share a leaf and are not tested one by one: 1 where a
  ///        visit is dear, several where it costs no more than a test
  BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes, int leaf_items);

  /// Calls `visit(item, t_max)` for every box that the ray meets in [t_min, t_max], nearer ones
  /// roughly first; what it returns is the new t_max.
  template <typename Visit>
  void Traverse(const Ray& ray, double t_min, double t_max, Visit visit) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0;  ///< of a leaf: into items_; of a fork: its left child; the right comes after
    int count = 0;  ///< items of a leaf; 0 = fork
    int axis = 0;   ///< of a fork's split
  };
  static constexpr int kDepthLimit = 64;  ///< a tree halved at the median is never that deep

  void Build(int node, int first, int count, const std::vector<Eigen::AlignedBox3d>& boxes);
  static bool Meets(const Ray& ray, const Eigen::AlignedBox3d& box, double t_min, double t_max);

  int leaf_items_;
  std::vector<Node> nodes_;
  std::vector<int> items_;
};

inline bool BoxTree::Meets(const Ray& ray, const Eigen::AlignedBox3d& box, double t_min,
                           double t_max) {
  for (int axis = 0; axis < 3; ++axis) {
    double enter = (box.min()[axis] - ray.origin[axis]) * ray.inverse[axis];
    double leave = (box.max()[axis] - ray.origin[axis]) * ray.inverse[axis];
    if (enter > leave) std::swap(enter, leave);
    t_min = enter > t_min ? enter : t_min;
    t_max = leave < t_max ? leave : t_max;
  }
  return t_min <= t_max;
}

template <typename Visit>
void BoxTree::Traverse(const Ray& ray, double t_min, double t_max, Visit visit) const {
  if (nodes_.empty()) return;
  int stack[kDepthLimit];
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--waiting])];
    if (!Meets(ray, node.box, t_min, t_max)) continue;
    if (node.count == 0) {
      const int near = ray.direction[node.axis] < 0 ? 1 : 0;
      stack[waiting++] = node.first + 1 - near;
      stack[waiting++] = node.first + near;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      t_max = visit(items_[static_cast<std::size_t>(i)], t_max);
    }
  }
}

}  // namespace horopter::sim
