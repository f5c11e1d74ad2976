// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/camera_models.h"

#include <cmath>

#include "scenarios/render/render_request.h"

namespace horopter::scenarios {

hardware::CameraModel CameraModelOf(const CameraSpec& asked, const CameraPairDescription& native) {
  const bool own = asked.width == RenderRequest::kNative;
  const double fov_deg =
      asked.horizontal_fov_deg == kRobotsOwn ? native.horizontal_fov_deg : asked.horizontal_fov_deg;
  return asked.profile.lens.Model(own ? native.width_px : asked.width,
                                  own ? native.height_px : asked.height, fov_deg * M_PI / 180);
}

}  // namespace horopter::scenarios
