// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "sim/world/world.h"

namespace horopter::sim {

/// The board of data/spot_board.xml: smooth bright spots on black, whose centroids in an image can
/// be held against where the camera model puts them.
class SpotBoard {
 public:
  /// Paints the board, before a renderer takes the textures, and hides every other geom.
  explicit SpotBoard(World& world) {
    mjModel& model = world.mutable_model();
    const int board = world.Id(mjOBJ_GEOM, "spot_board");
    for (int geom = 0; geom < model.ngeom; ++geom) {
      if (geom != board) model.geom_group[geom] = 4;
    }
    const int texture = world.Id(mjOBJ_TEXTURE, "spots");
    mjtByte* texels = model.tex_rgb + model.tex_adr[texture];
    for (int row = 0; row < kTexels; ++row) {
      for (int column = 0; column < kTexels; ++column) {
        const double light = LightAt(row, column);
        for (int k = 0; k < 3; ++k) {
          texels[3 * (row * kTexels + column) + k] = static_cast<mjtByte>(std::lround(light));
        }
      }
    }
  }

  /// Centres of the spots in the board's frame [m].
  static std::vector<Eigen::Vector3d> Centres() {
    std::vector<Eigen::Vector3d> centres;
    for (int row = 0; row < kSpots; ++row) {
      for (int column = 0; column < kSpots; ++column) {
        centres.emplace_back(((column + 0.5) / kSpots - 0.5) * 1.5,
                             ((row + 0.5) / kSpots - 0.5) * 1.2, 0);
      }
    }
    return centres;
  }

 private:
  static constexpr int kTexels = 1024;
  static constexpr int kSpots = 16;  ///< in a row and in a column
  static constexpr double kSigma_texels = 3.5;

  static double LightAt(int row, int column) {
    constexpr int kPitch = kTexels / kSpots;
    const double dx = column % kPitch + 0.5 - kPitch / 2.0, dy = row % kPitch + 0.5 - kPitch / 2.0;
    return 240 * std::exp(-(dx * dx + dy * dy) / (2 * kSigma_texels * kSigma_texels));
  }
};

}  // namespace horopter::sim
