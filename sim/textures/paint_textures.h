// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace horopter::sim {

/// One painted picture of a texture: the texture itself, or one face of a cube texture.
struct TexturePicture {
  std::string name;  ///< texture name, for a cube face followed by "+x", "-x", ... "-z"
  cv::Mat bgr;       ///< as seen from outside the box; sides with z up, +-z with x to the right
};

/// Paints every picture of a scene's recipes, in the order of the model's textures.
///
/// A scene declares a texture as `builtin="flat"` of some size, and beside it
/// `<custom><text name="texture:NAME" data="RECIPE,size_m=..."/></custom>`. Textures without such a
/// text have no picture here. Faces of a cube texture are painted independently.
/// @throws hardware::ConfigError for a bad recipe, or one whose texture does not exist
std::vector<TexturePicture> PaintPictures(const mjModel& model, std::uint64_t seed);

/// Paints the scene's recipes into the model's texture data, from where a renderer uploads them
/// when it is created. Each texture has its own random stream.
/// @param wanted by MuJoCo's texture id: those to paint, where nobody will see the others; all when
///        empty
/// @throws hardware::ConfigError as PaintPictures does
void PaintTextures(mjModel& model, std::uint64_t seed,
                   const std::function<bool(int texture)>& wanted = {});

}  // namespace horopter::sim
