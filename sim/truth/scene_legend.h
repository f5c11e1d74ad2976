// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace horopter::sim {

/// What ids mean: parts and the objects that they belong to.
///
/// A part is a geom; its id is MuJoCo's. An object is what a person would call one thing: going
/// down from the world, the first body with a name or a joint, with all that hangs on it; a geom
/// fixed to the world itself (a wall, the floor) is an object of its own. Objects are numbered from
/// 0 in the order of their first parts.
class SceneLegend {
 public:
  explicit SceneLegend(const mjModel& model);

  int part_count() const { return static_cast<int>(part_names_.size()); }
  int object_count() const { return static_cast<int>(object_names_.size()); }
  /// Its name, or where to find it when it has none: "geom 12 of table". @pre 0 <= part <
  /// part_count
  const std::string& PartName(int part) const { return part_names_.at(part); }
  const std::string& ObjectName(int object) const { return object_names_.at(object); }
  /// -1 for -1, which is nothing.
  int ObjectOf(int part) const { return part < 0 ? -1 : object_of_.at(part); }
  /// A map of objects of a map of parts; -1 = nothing there.
  cv::Mat1i Objects(const cv::Mat1i& parts) const;

 private:
  std::vector<std::string> part_names_;
  std::vector<std::string> object_names_;
  std::vector<int> object_of_;  ///< of each part
};

}  // namespace horopter::sim
