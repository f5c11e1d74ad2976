// SPDX-License-Identifier: Apache-2.0
#include "sim/render/view_frustum.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace horopter::sim {

using hardware::CameraModel;
using hardware::FieldError;
using hardware::Intrinsics;
using hardware::Pose;

mjvGLCamera FrustumOf(const Pose& X_WC, const Intrinsics& in, double near_m, double far_m) {
  const double pixel_m = near_m / in.fx;  // size of a pixel on the near plane
  mjvGLCamera camera{};
  for (int k = 0; k < 3; ++k) {
    camera.pos[k] = static_cast<float>(X_WC.translation()[k]);
    camera.forward[k] = static_cast<float>(X_WC.linear()(k, 2));
    camera.up[k] = static_cast<float>(-X_WC.linear()(k, 1));
  }
  camera.frustum_center = static_cast<float>((in.width / 2.0 - 0.5 - in.cx) * pixel_m);
  camera.frustum_top = static_cast<float>((in.cy + 0.5) * pixel_m);
  camera.frustum_bottom = static_cast<float>((in.cy + 0.5 - in.height) * pixel_m);
  camera.frustum_near = static_cast<float>(near_m);
  camera.frustum_far = static_cast<float>(far_m);
  return camera;
}

std::vector<FieldError> CheckView(const Pose& X_WC, const CameraModel& camera, cv::Size largest) {
  constexpr double kSquare = 1e-9;
  std::vector<FieldError> errors;
  const Intrinsics& in = camera.intrinsics();
  const auto check_size = [&errors](const char* field, int value, int limit, const char* option) {
    if (value <= limit) return;
    errors.push_back({field, std::to_string(value),
                      fmt::format("must be at most {}, the renderer's {}", limit, option)});
  };
  check_size("camera.width", in.width, largest.width, "width");
  check_size("camera.height", in.height, largest.height, "height");
  if (camera.distortion().any()) {
    errors.push_back({"camera.distortion", "not zero",
                      "must be zero to render: render an ideal view and resample it"});
  }
  if (std::abs(in.fx - in.fy) > kSquare * in.fx) {
    errors.push_back(
        {"camera.fy", std::to_string(in.fy),
         fmt::format("must equal fx = {} to render: render square pixels and resample", in.fx)});
  }
  if (!X_WC.matrix().allFinite()) errors.push_back({"X_WC", "not finite", "must be finite"});
  return errors;
}

}  // namespace horopter::sim
