// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "hardware/types/config_error.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// How obstacle points are remembered.
struct ObstacleMemoryConfig {
  double cell_m = 0.04;      ///< side of a cell
  double keep_s = 20;        ///< a cell is forgotten when not seen for so long; 0: at the next view
  int min_pixels = 8;        ///< in one view, for a cell to count as seen
  double max_range_m = 2;    ///< points further away are not remembered
  double clear_min_m = 0.8;  ///< nearer cells are not cleared by a view that sees something beyond:
                             ///< what stands there may be below the image

  std::vector<hardware::FieldError> Validate() const;
};

/// Cells of the ground in which obstacle points have been seen lately, in the odometry frame.
///
/// A cell that a later view looks past (everything it sees in that direction is clearly further
/// away) is cleared, so that a passing mismatch does not stay. Ordered containers throughout: the
/// same views give the same cells.
class ObstacleMemory {
 public:
  /// @throws hardware::ConfigError
  explicit ObstacleMemory(const ObstacleMemoryConfig& config);

  /// @param obstacles_B points that could be hit, in the base at t; NaN where there is none
  void Add(hardware::Time t, const cv::Mat3f& obstacles_B, const hardware::Pose2& X_OB);

  /// Centres of the remembered cells, in the base frame at pose `X_OB` [m].
  std::vector<Eigen::Vector2d> PointsInBase(const hardware::Pose2& X_OB) const;

  std::size_t size() const { return cells_.size(); }

 private:
  using Cell = std::pair<std::int32_t, std::int32_t>;

  Cell CellOf(double x_O, double y_O) const;
  void MarkSeen(hardware::Time t, const cv::Mat3f& obstacles_B, const hardware::Pose2& X_OB);
  void ClearSeenPast(hardware::Time t, const cv::Mat3f& obstacles_B, const hardware::Pose2& X_OB);

  ObstacleMemoryConfig config_;
  std::map<Cell, hardware::Time> cells_;  ///< when each was last seen
};

}  // namespace horopter::control
