// SPDX-License-Identifier: Apache-2.0
#include "sim/render/look_along.h"

#include <cmath>

namespace horopter::sim {
namespace {

using Eigen::Vector3f;

// The order of these operations counts; Eigen's own may be another.
float Dot(const Vector3f& a, const Vector3f& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3f Cross(const Vector3f& a, const Vector3f& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3f Unit(const Vector3f& v) {
  const float scale = 1.0f / std::sqrt(Dot(v, v));
  return {v[0] * scale, v[1] * scale, v[2] * scale};
}

}  // namespace

Eigen::Matrix4f LookAlong(const float from[3], const float forward[3], const float up[3]) {
  const Vector3f at(from);
  const Vector3f ahead = Unit(Vector3f(forward));
  const Vector3f side = Unit(Cross(ahead, Vector3f(up)));
  const Vector3f upright = Unit(Cross(side, ahead));
  Eigen::Matrix4f view = Eigen::Matrix4f::Identity();
  for (int k = 0; k < 3; ++k) {
    view(0, k) = side[k];
    view(1, k) = upright[k];
    view(2, k) = -ahead[k];
  }
  view(0, 3) = -Dot(side, at);
  view(1, 3) = -Dot(upright, at);
  view(2, 3) = Dot(ahead, at);
  return view;
}

Eigen::Vector3f UprightFor(const float forward[3]) {
  constexpr float kAlongX = 0.01f;
  const Vector3f ahead(forward);
  const Vector3f up = Cross(ahead, -Vector3f::UnitX());
  return Unit(Dot(up, up) > kAlongX ? up : Cross(ahead, Vector3f::UnitY()));
}

}  // namespace horopter::sim
