// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/matx.hpp>

#include "sim/textures/painters.h"

namespace horopter::sim {

/// A cube texture wraps every shape: MuJoCo looks a point of a geom up by its direction from the
/// geom's centre, in units of the geom's half edges. A painter that knows where on the box it is
/// can therefore paint what a cylinder or an ellipsoid shows, without seams.

/// Where a surface's point is on the box [-1, 1]^3, in body axes. A flat surface is its front.
cv::Vec3d UnitBoxPoint(const Surface& surface, double x_m, double y_m);

/// A point of an upright cylinder with the box's edges.
struct CylinderPoint {
  double angle_rad;  ///< about the axis, 0 at the front (+x), positive to the left, in [-pi, pi]
  double down;       ///< from the upper rim, 0, to the lower, 1
  double radius;     ///< from the axis, 0, to the rim, 1; less than 1 on the caps alone
};

/// The point of the cylinder that shows a surface's point. A flat surface is the wall unrolled.
CylinderPoint OnCylinder(const Surface& surface, double x_m, double y_m);

/// Radius and height of that cylinder [m]; a flat surface's width is once around.
struct CylinderSize {
  double radius_m;
  double height_m;
};
CylinderSize SizeOfCylinder(const Surface& surface);

}  // namespace horopter::sim
