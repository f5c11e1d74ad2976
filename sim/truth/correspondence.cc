// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/correspondence.h"

#include <Eigen/Geometry>
#include <cassert>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::Pose;

/// Relative difference in depth below which two surfaces count as one: far above what double
/// precision leaves of a point that was projected and met again.
constexpr double kSameDepth = 1e-7;

/// A point of a surface, and where that surface faces, in the world of the other instant.
struct SurfacePoint {
  Vector3d p_W;
  Vector3d facet_normal_W;
  int geom = -1;
};

/// The point that the pixel's ray met, carried along with its geom.
std::optional<SurfacePoint> Carry(const SceneSnapshot& from_scene, const EyeTruth& from, int y,
                                  int x, const SceneSnapshot& to_scene) {
  const int geom = from.ids(y, x);
  const auto ray_C = from.view.camera.Unproject(Eigen::Vector2d(x, y));
  if (geom < 0 || !ray_C) return std::nullopt;
  const Pose& X_WC = from.view.X_WC;
  const Ray ray(X_WC.translation(), X_WC.linear() * *ray_C);
  const auto hit = from_scene.HitOf(geom, ray, from.view.near_m, from.view.far_m);
  if (!hit) return std::nullopt;
  const Pose X_to_from = to_scene.X_WG(geom) * from_scene.X_WG(geom).inverse(Eigen::Isometry);
  return SurfacePoint{X_to_from * hit->p_W, X_to_from.linear() * hit->facet_normal_W, geom};
}

/// Whether the eye sees the point, which projects into its image at depth z.
bool IsSeen(const SceneSnapshot& scene, const EyeView& eye, const SurfacePoint& point, double z) {
  const Vector3d origin = eye.X_WC.translation();
  const Vector3d direction = (point.p_W - origin) / z;  // so that the ray's t is depth
  const bool faces_away = point.facet_normal_W.dot(direction) >= 0;
  if (faces_away && !scene.shapes().At(point.geom)->two_sided()) return false;
  const double before = z * (1 - kSameDepth);
  return !scene.FirstHit(Ray(origin, direction), eye.near_m, before).has_value();
}

void MatchRow(const SceneSnapshot& from_scene, const EyeTruth& from, const SceneSnapshot& to_scene,
              const EyeView& to, int y, CorrespondenceField* field) {
  const Pose X_CW = to.X_WC.inverse(Eigen::Isometry);
  for (int x = 0; x < from.ids.cols; ++x) {
    const auto point = Carry(from_scene, from, y, x, to_scene);
    if (!point) continue;
    Visibility visibility = Visibility::kOutOfView;
    const Vector3d p_C = X_CW * point->p_W;
    if (const auto pixel = to.camera.Project(p_C)) {
      field->dx(y, x) = static_cast<float>(pixel->x() - x);
      field->dy(y, x) = static_cast<float>(pixel->y() - y);
      const bool in_range = p_C.z() >= to.near_m && p_C.z() <= to.far_m;
      if (in_range && to.camera.Contains(*pixel)) {
        visibility =
            IsSeen(to_scene, to, *point, p_C.z()) ? Visibility::kVisible : Visibility::kOccluded;
      }
    }
    field->visibility(y, x) = static_cast<std::uint8_t>(visibility);
  }
}

}  // namespace

cv::Mat1b CorrespondenceField::Mask(Visibility which) const {
  return visibility == static_cast<int>(which);
}

CorrespondenceField TrueCorrespondence(const SceneSnapshot& from_scene, const EyeTruth& from,
                                       const SceneSnapshot& to_scene, const EyeView& to) {
  assert(&from_scene.shapes() == &to_scene.shapes());
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const cv::Size size = from.ids.size();
  CorrespondenceField field{cv::Mat1f(size, kNone), cv::Mat1f(size, kNone),
                            cv::Mat1b(size, static_cast<std::uint8_t>(Visibility::kNoSurface))};
  cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      MatchRow(from_scene, from, to_scene, to, y, &field);
    }
  });
  return field;
}

}  // namespace horopter::sim
