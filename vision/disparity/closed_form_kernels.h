// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace horopter::vision {

/// Columns that keep_best and solve take at once.
inline constexpr int kColumnsAtOnce = 64;
/// Lanes of a pixel: as many hypotheses are scored at once, and as many numbers pooled.
inline constexpr int kLanes = 16;
/// Orientations a cell can hold; their real parts are bytes 0 to 7, the imaginary ones 8 to 15.
inline constexpr int kMaxCellOrientations = 8;
/// Power of a textured cell, the sum of |F|^2 over orientations, in units of kCellOne squared.
inline constexpr double kCellPower = 3;
inline constexpr double kCellOne = 127;
/// Steps of a hypothesis in a pixel.
inline constexpr int kHypothesisSteps = 16;
/// A score is a sum of products of a cell, a cell and a rotation, divided by 2^kScoreShift.
inline constexpr int kScoreShift = 9;
/// The score of equal cells.
inline constexpr double kScoreOne =
    kCellPower * kCellOne * kCellOne * kCellOne / (1 << kScoreShift);

/// The simple cells of an image: 16 bytes a pixel, row by row, then one cell of zeros that stands
/// for everything outside.
struct CellView {
  const std::int8_t* cells;
  int width;
  int height;

  const std::int8_t* at(std::int64_t pixel) const { return cells + pixel * kLanes; }
  std::int32_t outside() const { return width * height; }
};

/// Rotations of the phase of every orientation. An entry of 2 x 16 lanes turns a cell F by
/// F * first + swapped F * second.
struct PhaseTables {
  /// By fractions -8/16 to 7/16 px: entry 16 * (fraction of y + 8) + fraction of x + 8.
  alignas(32) std::array<std::int8_t, 256 * 2 * kLanes> turn;
  /// By 0/64 to 64/64 px along one axis, 15 bits after the point.
  alignas(32) std::array<std::int16_t, 65 * 2 * kLanes> turn_x, turn_y;
  /// From the pixels (1, 0), (0, 1), (1, 1) to (0, 0), 15 bits after the point.
  alignas(32) std::array<std::int16_t, 3 * 2 * kLanes> from_corner;
};

/// How much of a neighbour's value a pixel takes: a table over the difference of colour between the
/// two (EdgeMap), 15 bits after the point.
using PoolingWeights = std::array<std::int16_t, 256>;

/// The linear stage: an image through the Gabor bank into normalised cells.
struct FilterTask {
  const float* grey;  ///< width x height
  int width, height;
  std::int8_t* cells;
  int orientations;  ///< even, or the bank has no vertical filter to share
  int radius;
  const float* even;  ///< Gaussian times cosine, per frequency 0..orientations/2: radius + 1 taps
                      ///< from the centre
  const float* odd;   ///< Gaussian times sine
  const float* across_even;  ///< the same, for the frequencies along x
  const float* across_odd;
  const float* balance;  ///< share of the blurred image that a constant one needs taken off
  float saturation2;     ///< of |F|^2 [grey^2]
  float floor;           ///< of the cell's power, so that textureless cells stay small
};

/// Sixteen hypotheses a pixel: those of itself and its neighbours, each moved a little.
struct Candidates {
  std::array<int, kLanes> from_x, from_y;  ///< where the hypothesis is taken from, relative [px]
  std::array<int, kLanes> move_x, move_y;  ///< added to it [1/16 px]
};

struct NeighbourTask {
  CellView left, right;
  const std::int16_t *hypothesis_x, *hypothesis_y;  ///< [1/16 px]
  const PhaseTables* tables;
  const Candidates* candidates;
  std::int16_t* scores;  ///< kLanes a pixel
};

/// Sixteen whole disparities along x, from first_dx on, at the pixel's own dy and `move_y` more.
struct ShiftTask {
  CellView left, right;
  const std::int16_t* hypothesis_y;  ///< [1/16 px]; null = 0
  const PhaseTables* tables;
  int first_dx;
  int move_y;            ///< [1/16 px]
  std::int16_t* scores;  ///< kLanes a pixel
};

/// Binocular products of every orientation at the field's disparities, between pixels.
struct ProductTask {
  CellView left, right;
  const float *dx, *dy;
  const PhaseTables* tables;
  std::int16_t* products;  ///< L conj(R): real parts, imaginary parts; 0 outside
};

/// Lanes pooled along rows and down the columns; the way back up is the consumer's, which has each
/// pixel's final lanes at hand then and writes none of them back.
struct ColumnPool {
  std::int16_t* lanes;
  int width, height;
  const std::uint8_t* edge_y;  ///< colour difference to the pixel above
  const PoolingWeights* weights;
};

/// Notes, for every pixel, the best of the pooled hypotheses if it beats the best so far.
struct KeepTask {
  ColumnPool pool;
  int lanes;                ///< how many of the hypotheses count
  bool first;               ///< nothing to beat yet
  std::int16_t favour_own;  ///< added to lane 0
  std::int32_t lane_0;      ///< the number of the first hypothesis; the others follow
  std::int16_t* best;
  std::int32_t* winner;  ///< number of the best hypothesis
};

/// Moves the field by the intersection of the constraints that the pooled products' phases give.
struct SolveTask {
  ColumnPool pool;
  int orientations;
  std::array<float, kMaxCellOrientations> nx, ny;
  float px_per_rad;
  float ridge;
  float max_step_px;
  float *dx, *dy;
};

/// Means of a field over the neighbours of a row or a column that lie close to the pixel's own.
struct SmoothTask {
  const float *dx, *dy;
  float *out_dx, *out_dy;
  int width, height;
  int radius;
  float max_difference_px;
};

/// Floats of a row with `radius` more at either end, in whole vectors.
inline constexpr int PaddedRow(int width, int radius) { return (width + 2 * radius + 16) / 8 * 8; }

/// The inner loops of the closed form for one instruction set. Rows and column blocks are
/// independent of each other, keep_best and solve take kColumnsAtOnce at most; all sets give the
/// same bits.
/// Scratch is PaddedRow(width, radius) floats, times orientations + 2 for filter_row, 2 for
/// smooth_row. Maps that kernels read end with 8 more values than pixels.
struct ClosedFormKernels {
  std::string_view name;
  void (*filter_row)(const FilterTask&, int y, float* scratch);
  void (*score_neighbours)(const NeighbourTask&, int y);
  void (*score_shifts)(const ShiftTask&, int y);
  void (*multiply_row)(const ProductTask&, int y);
  void (*pool_row)(std::int16_t* row, const std::uint8_t* edge_x, const PoolingWeights&, int width);
  void (*pool_down)(const ColumnPool&, int y_begin, int y_end, int x_begin, int x_end);
  void (*keep_best)(const KeepTask&, int x_begin, int x_end);
  void (*solve)(const SolveTask&, int x_begin, int x_end);
  void (*smooth_row)(const SmoothTask&, int y, float* scratch);
  void (*smooth_across_rows)(const SmoothTask&, int y);
};

/// Those of "avx512", "avx2" or "portable"; "" = the best that this processor has.
/// @throws std::invalid_argument for another name, or one that this processor cannot run
const ClosedFormKernels& SelectKernels(std::string_view name = "");

/// Names that SelectKernels takes here, best first.
std::vector<std::string_view> UsableKernels();

}  // namespace horopter::vision
