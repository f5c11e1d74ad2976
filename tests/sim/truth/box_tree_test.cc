// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/box_tree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace horopter::sim {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::vector<AlignedBox3d> RandomBoxes(int count, std::mt19937* random) {
  std::uniform_real_distribution<double> place(-1, 1), size(0, 0.4);
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < count; ++i) {
    const Vector3d p(place(*random), place(*random), place(*random));
    boxes.emplace_back(p, p + Vector3d(size(*random), size(*random), size(*random)));
  }
  return boxes;
}

std::set<int> Visited(const BoxTree& tree, const Ray& ray, double t_max) {
  std::set<int> visited;
  tree.Traverse(ray, 0, t_max, [&visited](int item, double limit) {
    EXPECT_TRUE(visited.insert(item).second) << "each item once";
    return limit;
  });
  return visited;
}

bool Meets(const Ray& ray, const AlignedBox3d& box, double t_max) {
  double t_min = 0;
  for (int i = 0; i < 3; ++i) {
    const double a = (box.min()[i] - ray.origin[i]) / ray.direction[i];
    const double b = (box.max()[i] - ray.origin[i]) / ray.direction[i];
    t_min = std::max(t_min, std::min(a, b));
    t_max = std::min(t_max, std::max(a, b));
  }
  return t_min <= t_max;
}

TEST(BoxTree, VisitsEveryBoxThatTheRayMeets) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  int met = 0;
  for (const int count : {1, 3, 4, 5, 17, 200}) {
    const auto boxes = RandomBoxes(count, &random);
    const BoxTree tree(boxes, count % 5 + 1);
    for (int i = 0; i < 1000; ++i) {
      const Ray ray({place(random), place(random), place(random)},
                    {place(random), place(random), place(random)});
      const auto visited = Visited(tree, ray, 1.2);
      for (int item = 0; item < count; ++item) {
        if (!Meets(ray, boxes[item], 1.2)) continue;
        ++met;
        EXPECT_TRUE(visited.count(item)) << count << " boxes, item " << item;
      }
    }
  }
  EXPECT_GT(met, 500);
}

TEST(BoxTree, LeavesOutWhatIsFarFromTheRay) {
  std::mt19937 random(6);
  const auto boxes = RandomBoxes(1000, &random);
  const BoxTree tree(boxes, 4);
  EXPECT_LT(Visited(tree, Ray({-2, 0, 0}, {1, 0.1, 0.05}), 10).size(), 200u);
}

TEST(BoxTree, FollowsAnAxisExactly) {
  const std::vector<AlignedBox3d> boxes = {{Vector3d(1, -1, -1), Vector3d(2, 1, 1)},
                                           {Vector3d(-2, 3, 0), Vector3d(2, 4, 1)}};
  const BoxTree single(boxes, 1), shared(boxes, 2);
  EXPECT_EQ(Visited(single, Ray({0, 0, 0}, {1, 0, 0}), 10), (std::set<int>{0}));
  EXPECT_EQ(Visited(shared, Ray({0, 0, 0}, {1, 0, 0}), 10), (std::set<int>{0, 1}))
      << "a leaf is visited as a whole";
  EXPECT_TRUE(Visited(single, Ray({0, 0, 5}, {1, 0, 0}), 10).empty());
  EXPECT_TRUE(Visited(single, Ray({0, 0, 0}, {1, 0, 0}), 0.5).empty()) << "it ends before";
  EXPECT_TRUE(Visited(single, Ray({0, 0, 0}, {-1, 0, 0}), 10).empty()) << "it goes away";
}

TEST(BoxTree, OfNothingVisitsNothing) {
  EXPECT_TRUE(Visited(BoxTree({}, 1), Ray({0, 0, 0}, {1, 0, 0}), 10).empty());
}

TEST(BoxTree, StopsAtTheLimitThatAVisitSets) {
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < 100; ++i) boxes.emplace_back(Vector3d(i, -1, -1), Vector3d(i + 0.5, 1, 1));
  const BoxTree tree(boxes, 4);
  std::set<int> visited;
  tree.Traverse(Ray({-1, 0, 0}, {1, 0, 0}), 0, 1000, [&visited](int item, double limit) {
    visited.insert(item);
    return std::min(limit, item + 1.0);  // where the ray enters it
  });
  EXPECT_TRUE(visited.count(0));
  EXPECT_LT(visited.size(), 8u) << "only the nearest leaf";
}

}  // namespace
}  // namespace horopter::sim
