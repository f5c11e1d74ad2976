// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/ground_truth.h"

#include <Eigen/Geometry>
#include <limits>
#include <opencv2/core.hpp>
#include <utility>

#include "sim/truth/drawn_shape.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

Vector3d NormalInEye(const SceneSnapshot& scene, const SurfaceHit& hit, const EyeView& view) {
  const hardware::Pose& X_WG = scene.X_WG(hit.geom);
  const Vector3d p_G = X_WG.inverse(Eigen::Isometry) * hit.p_W;
  const Vector3d facet_G = X_WG.linear().transpose() * hit.facet_normal_W;
  Vector3d normal_W = X_WG.linear() * SurfaceNormal(scene.shapes().model(), hit.geom, p_G, facet_G);
  // A plane seen from behind shows that side's normal.
  const bool behind = hit.facet_normal_W.dot(hit.p_W - view.X_WC.translation()) > 0;
  if (behind) normal_W = -normal_W;
  return view.X_WC.linear().transpose() * normal_W;
}

void CaptureRow(const SceneSnapshot& scene, int y, EyeTruth* truth) {
  const EyeView& view = truth->view;
  int last_geom = -1;  // neighbours mostly show the same
  for (int x = 0; x < truth->depth.cols; ++x) {
    const auto ray_C = view.camera.Unproject(Eigen::Vector2d(x, y));
    if (!ray_C) continue;
    const Ray ray(view.X_WC.translation(), view.X_WC.linear() * *ray_C);
    const auto hit = scene.FirstHit(ray, view.near_m, view.far_m, last_geom);
    if (!hit) continue;
    last_geom = hit->geom;
    truth->depth(y, x) = static_cast<float>(hit->t);  // the ray's z is 1
    truth->ids(y, x) = hit->geom;
    const Eigen::Vector3f normal = NormalInEye(scene, *hit, view).cast<float>();
    truth->normals(y, x) = {normal.x(), normal.y(), normal.z()};
  }
}

}  // namespace

EyeTruth CaptureEyeTruth(const SceneSnapshot& scene, const EyeView& view) {
  const cv::Size size(view.camera.width(), view.camera.height());
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  EyeTruth truth{view, cv::Mat1f(size, std::numeric_limits<float>::infinity()), cv::Mat1i(size, -1),
                 cv::Mat3f(size, cv::Vec3f(kNone, kNone, kNone))};
  cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) CaptureRow(scene, y, &truth);
  });
  return truth;
}

GroundTruth CaptureGroundTruth(const World& world, std::shared_ptr<const SceneShapes> shapes,
                               const EyeView& left, const EyeView& right) {
  const SceneSnapshot scene(std::move(shapes), world.data());
  return {ReadWorldState(world), CaptureEyeTruth(scene, left), CaptureEyeTruth(scene, right)};
}

}  // namespace horopter::sim
