// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/point_field.h"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

/// Calls `write(row, column, point)` for every pixel. NaN runs through all arithmetic, so that
/// pixels without a point need no case of their own.
template <typename Write>
void ForEachPoint(const cv::Mat3f& points, const Write& write) {
  cv::parallel_for_(cv::Range(0, points.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      const cv::Vec3f* row = points[v];
      for (int u = 0; u < points.cols; ++u) {
        write(v, u, Eigen::Vector3d(row[u][0], row[u][1], row[u][2]));
      }
    }
  });
}

}  // namespace

PointField Transformed(const PointField& field_B, const hardware::Pose& X_AB) {
  PointField field_A{cv::Mat3f(field_B.points.size()), field_B.residual_m.clone()};
  ForEachPoint(field_B.points, [&](int v, int u, const Eigen::Vector3d& p_B) {
    const Eigen::Vector3f p_A = (X_AB * p_B).cast<float>();
    field_A.points(v, u) = {p_A.x(), p_A.y(), p_A.z()};
  });
  return field_A;
}

cv::Mat1f DepthAlongOptical(const PointField& field_B, const hardware::Pose& X_BC) {
  const Eigen::Vector3d axis = X_BC.linear().col(2);
  const Eigen::Vector3d centre = X_BC.translation();
  cv::Mat1f depth(field_B.points.size());
  ForEachPoint(field_B.points, [&](int v, int u, const Eigen::Vector3d& p_B) {
    depth(v, u) = static_cast<float>(axis.dot(p_B - centre));
  });
  return depth;
}

}  // namespace horopter::vision
