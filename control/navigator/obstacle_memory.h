// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "control/navigator/scene_view.h"
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
  /// Cells further than this from the robot count only once two views have seen something there, or
  /// within two cells of it: a mismatch hardly falls on the same place twice. Infinite: all count.
  double confirm_beyond_m = std::numeric_limits<double>::infinity();

  std::vector<hardware::FieldError> Validate() const;
};

/// Cells of the ground in which obstacle points have been seen lately, in the odometry frame.
///
/// In one view, a cell with `min_pixels` obstacle pixels, and at least half as many as it has floor
/// pixels, is occupied; one with as many floor pixels and no such obstacle is free. A cell that a
/// later view looks past (everything that stands in that direction is clearly further away) is
/// cleared too, so that a passing mismatch does not stay. Ordered containers throughout: the
/// same views give the same cells.
class ObstacleMemory {
 public:
  /// @throws hardware::ConfigError
  explicit ObstacleMemory(const ObstacleMemoryConfig& config);

  /// @param X_OB where the base was when the view was taken
  void Add(const SceneView& view, const hardware::Pose2& X_OB);

  /// Which cells to go by.
  enum class Certainty {
    kConfirmed,  ///< those that count (confirm_beyond_m): to act upon
    kAny,        ///< all: to keep clear of
  };

  /// Centres of the remembered cells, in the base frame at pose `X_OB` [m].
  std::vector<Eigen::Vector2d> PointsInBase(const hardware::Pose2& X_OB,
                                            Certainty certainty = Certainty::kConfirmed) const;

  std::size_t size() const { return cells_.size(); }

 private:
  using Cell = std::pair<std::int32_t, std::int32_t>;

  Cell CellOf(double x_O, double y_O) const;
  /// Pixels of each cell of a square window round the robot.
  struct Window {
    Cell corner;
    int side = 0;
    std::vector<int> pixels;  ///< [i * side + j] is cell (corner.first + i, corner.second + j)
  };
  Window CountPixels(const cv::Mat3f& points_B, const hardware::Pose2& X_OB) const;
  void UpdateSeen(const SceneView& view, const hardware::Pose2& X_OB);
  void ClearSeenPast(const SceneView& view, const hardware::Pose2& X_OB);

  ObstacleMemoryConfig config_;
  struct Seen {
    hardware::Time first{};
    hardware::Time last{};
    bool confirmed = false;  ///< by two views
  };
  /// Whether an earlier view has seen something in or about a cell.
  bool SeenBefore(const Cell& cell, hardware::Time now) const;

  std::map<Cell, Seen> cells_;
};

}  // namespace horopter::control
