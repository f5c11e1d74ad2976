// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/paint_textures.h"

#include <array>
#include <opencv2/core.hpp>
#include <string_view>

#include "hardware/types/config_error.h"
#include "sim/random/random_stream.h"
#include "sim/textures/paint.h"

namespace horopter::sim {

namespace {

constexpr std::string_view kPrefix = "texture:";
constexpr int kFaces = 6;
/// MuJoCo stores the faces of a cube texture below each other in OpenGL's order.
constexpr std::array<const char*, kFaces> kFaceNames = {"+x", "-x", "+y", "-y", "+z", "-z"};

struct Declared {
  int texture;
  std::string name;
  TextureRecipe recipe;
  bool cube;
};

Declared Declare(const mjModel& model, std::string_view name, std::string_view text) {
  const std::string field = std::string(kPrefix) + std::string(name);
  const int texture = mj_name2id(&model, mjOBJ_TEXTURE, std::string(name).c_str());
  if (texture < 0) {
    throw hardware::ConfigError({{field, std::string(text), "the scene has no such texture"}});
  }
  Declared declared{texture, std::string(name), ParseTextureRecipe(name, text),
                    model.tex_type[texture] == mjTEXTURE_CUBE};
  const std::size_t edges = declared.cube ? 3 : 2;
  if (declared.recipe.size_m.size() != edges) {
    throw hardware::ConfigError(
        {{field + ".size_m", std::string(text),
          declared.cube ? "a cube texture needs XxYxZ" : "a flat texture needs WxH"}});
  }
  return declared;
}

std::vector<Declared> DeclaredTextures(const mjModel& model) {
  std::vector<Declared> all;
  for (int i = 0; i < model.ntext; ++i) {
    const std::string_view name = model.names + model.name_textadr[i];
    if (!name.starts_with(kPrefix)) continue;
    all.push_back(Declare(model, name.substr(kPrefix.size()), model.text_data + model.text_adr[i]));
  }
  return all;
}

Surface FaceSurface(const std::vector<double>& box_m, int face) {
  constexpr std::array<Side, kFaces> kSides = {Side::kFront, Side::kBack, Side::kLeft,
                                               Side::kRight, Side::kTop,  Side::kBottom};
  if (face < 2) return {box_m[1], box_m[2], kSides[face], box_m[0]};
  if (face < 4) return {box_m[0], box_m[2], kSides[face], box_m[1]};
  return {box_m[0], box_m[1], kSides[face], box_m[2]};
}

/// A face of a box; the narrow edges of boards, of which nobody sees more than their colour, cost
/// one row or column of painting.
cv::Mat PaintFace(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed,
                  int edge_px) {
  constexpr double kNarrow_m = 0.02;
  const int columns = surface.width_m < kNarrow_m ? 1 : edge_px;
  const int rows = surface.height_m < kNarrow_m ? 1 : edge_px;
  const cv::Mat painted = Paint(recipe, surface, seed, columns, rows);
  return cv::repeat(painted, edge_px / rows, edge_px / columns);
}

/// Turns a picture, as seen from outside, into the texels that OpenGL's cube map shows that way
/// on a MuJoCo box.
cv::Mat FaceTexels(const cv::Mat& picture, int face) {
  cv::Mat texels;
  switch (face) {
    case 0:
      cv::rotate(picture, texels, cv::ROTATE_90_COUNTERCLOCKWISE);
      break;
    case 1:
      cv::rotate(picture, texels, cv::ROTATE_90_CLOCKWISE);
      break;
    case 2:
    case 5:
      cv::rotate(picture, texels, cv::ROTATE_180);
      break;
    default:
      texels = picture;
      break;
  }
  return texels;
}

std::vector<TexturePicture> PaintDeclared(const mjModel& model, const Declared& declared,
                                          std::uint64_t seed) {
  RandomStream stream(seed, "texture." + declared.name);
  const int width_px = model.tex_width[declared.texture];
  const int height_px = model.tex_height[declared.texture];
  if (!declared.cube) {
    const Surface surface{declared.recipe.size_m[0], declared.recipe.size_m[1]};
    return {{declared.name, Paint(declared.recipe, surface, stream.Next(), width_px, height_px)}};
  }
  std::vector<TexturePicture> faces;
  for (int face = 0; face < kFaces; ++face) {
    const Surface surface = FaceSurface(declared.recipe.size_m, face);
    faces.push_back({declared.name + kFaceNames[face],
                     PaintFace(declared.recipe, surface, stream.Next(), width_px)});
  }
  return faces;
}

void Store(mjModel& model, int texture, int first_row, const cv::Mat& bgr) {
  const int width = model.tex_width[texture];
  mjtByte* rgb = model.tex_rgb + model.tex_adr[texture] + 3 * first_row * width;
  for (int row = 0; row < bgr.rows; ++row) {
    for (int column = 0; column < bgr.cols; ++column, rgb += 3) {
      const cv::Vec3b& texel = bgr.at<cv::Vec3b>(row, column);
      for (int c = 0; c < 3; ++c) rgb[c] = texel[2 - c];
    }
  }
}

}  // namespace

std::vector<TexturePicture> PaintPictures(const mjModel& model, std::uint64_t seed) {
  std::vector<TexturePicture> pictures;
  for (const Declared& declared : DeclaredTextures(model)) {
    for (TexturePicture& picture : PaintDeclared(model, declared, seed)) {
      pictures.push_back(std::move(picture));
    }
  }
  return pictures;
}

void PaintTextures(mjModel& model, std::uint64_t seed,
                   const std::function<bool(int texture)>& wanted) {
  for (const Declared& declared : DeclaredTextures(model)) {
    if (wanted && !wanted(declared.texture)) continue;
    const std::vector<TexturePicture> pictures = PaintDeclared(model, declared, seed);
    for (int face = 0; face < static_cast<int>(pictures.size()); ++face) {
      const cv::Mat& bgr = pictures[face].bgr;
      Store(model, declared.texture, face * bgr.rows, declared.cube ? FaceTexels(bgr, face) : bgr);
    }
  }
}

}  // namespace horopter::sim
