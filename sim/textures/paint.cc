// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/paint.h"

#include <opencv2/core/utility.hpp>

#include "hardware/types/config_error.h"

namespace horopter::sim {

cv::Mat Paint(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed, int width_px,
              int height_px) {
  std::vector<hardware::FieldError> errors;
  if (width_px < 1) errors.push_back({"width_px", std::to_string(width_px), "must be positive"});
  if (height_px < 1) errors.push_back({"height_px", std::to_string(height_px), "must be positive"});
  hardware::ThrowIfAny(std::move(errors));

  const Painter painter = MakePainter(recipe, surface, seed);
  cv::Mat image(height_px, width_px, CV_8UC3);
  cv::parallel_for_(cv::Range(0, height_px), [&](const cv::Range& rows) {
    for (int row = rows.start; row < rows.end; ++row) {
      const double y_m = (row + 0.5) / height_px * surface.height_m;
      cv::Vec3b* texels = image.ptr<cv::Vec3b>(row);
      for (int column = 0; column < width_px; ++column) {
        const cv::Vec3f bgr = painter((column + 0.5) / width_px * surface.width_m, y_m);
        for (int c = 0; c < 3; ++c) texels[column][c] = cv::saturate_cast<uchar>(bgr[c]);
      }
    }
  });
  return image;
}

}  // namespace horopter::sim
