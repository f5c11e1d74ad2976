// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace horopter::sim {

Ray::Ray(const Eigen::Vector3d& from, const Eigen::Vector3d& along)
    : origin(from), direction(along) {
  // Zero would give infinity, and infinity times zero is no number.
  constexpr double kAlmostZero = 1e-200;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = along[axis];
    inverse[axis] = 1 / (std::abs(d) < kAlmostZero ? std::copysign(kAlmostZero, d) : d);
  }
}

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes, int leaf_items)
    : leaf_items_(leaf_items), items_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0);
  nodes_.emplace_back();
  Build(0, 0, static_cast<int>(boxes.size()), boxes);
}

void BoxTree::Build(int node, int first, int count, const std::vector<Eigen::AlignedBox3d>& boxes) {
  const auto begin = items_.begin() + first, end = begin + count;
  Eigen::AlignedBox3d box, centres;
  for (auto item = begin; item != end; ++item) {
    box.extend(boxes[static_cast<std::size_t>(*item)]);
    centres.extend(boxes[static_cast<std::size_t>(*item)].center());
  }
  Node& here = nodes_[static_cast<std::size_t>(node)];
  here.box = box;
  if (count <= leaf_items_) {
    here.first = first;
    here.count = count;
    return;
  }
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const auto before = [&boxes, axis](int a, int b) {
    const double ca = boxes[static_cast<std::size_t>(a)].center()[axis];
    const double cb = boxes[static_cast<std::size_t>(b)].center()[axis];
    return ca != cb ? ca < cb : a < b;
  };
  std::nth_element(begin, begin + count / 2, end, before);
  const int left = static_cast<int>(nodes_.size());
  here.axis = axis;
  here.first = left;
  nodes_.resize(nodes_.size() + 2);  // `here` is no longer valid
  Build(left, first, count / 2, boxes);
  Build(left + 1, first + count / 2, count - count / 2, boxes);
}

}  // namespace horopter::sim
