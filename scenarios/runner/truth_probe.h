// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>

#include "hardware/types/pose.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// The truth about one frame. Maps have the left image's size.
struct FrameTruth {
  cv::Mat1f depth_m;  ///< along the left optical axis; +inf where nothing is
  cv::Mat1b board;    ///< 255 on the squares of the scene's chessboard; empty when it has none
};

/// What scoring may ask of the world. Scoring alone holds one; a backend without truth has none.
class TruthProbe {
 public:
  virtual ~TruthProbe() = default;

  /// True pose of the base now, in the robot's true starting frame.
  virtual hardware::Pose2 X_OB() = 0;

  /// Smallest distance between the robot and anything but the floor, by the collision oracle [m];
  /// negative when they overlap.
  virtual double Clearance() = 0;

  /// How often the robot has begun to touch something besides the floor, by the physics.
  virtual int contacts() const = 0;

  /// Angle between each eye's optical axis and the way to a point, the larger of both [deg]; NaN
  /// when the point is an eye's optical centre.
  /// @param p_OT in the robot's true starting frame
  virtual double FixationErrorDeg(const Eigen::Vector3d& p_OT) = 0;

  /// The truth about the newest grabbed frame, at the instant it was taken.
  virtual FrameTruth AtCapture() = 0;

  /// Outlines of what stands in the room, in the robot's true starting frame.
  virtual PlanRecord Plan() = 0;
};

}  // namespace horopter::scenarios
