// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace horopter::sim {

/// Values beyond a row's end that its loops may read: rows are worked on eight at a time.
inline constexpr int kRowWidthStep = 8;

/// Steps of a pixel in which a sample's place is rounded.
inline constexpr int kPlaceBits = 7;
inline constexpr int kPlaceSteps = 1 << kPlaceBits;

/// An image of three bytes a pixel to take samples from, and how pixels of a row map into it.
struct SampleSource {
  const std::uint8_t* pixels;
  int stride;    ///< bytes from row to row, below 2^15
  float last_x;  ///< places beyond are moved here; two more bytes than a pixel's pair are readable
  float last_y;
  float h[9];  ///< homography from (x, y, 1), column by column
  float e[3];  ///< by which an inverse depth shifts
};

/// Where a row's samples lie: `width` values each, rounded up to kRowWidthStep.
struct SampleRow {
  const float* x;
  const float* y;
  const float* w;  ///< inverse depths; null: no parallax
  int width;
};

/// What a sensor makes of one row.
struct SensorRow {
  const float* loss;         ///< of the gain, per value, their number rounded up to kRowWidthStep
  float gain;                ///< less the row's share of the loss
  float light;               ///< share of it that reaches the sensor
  float shot_gain;           ///< variance of the shot noise per grey level
  float read_noise;          ///< standard deviation [grey levels]
  float digits_per_level;    ///< of the converter
  std::uint64_t shot_key{};  ///< from which all the row's shot noise follows
  std::uint64_t read_key{};  ///< likewise its read noise
};

/// The loops over the values of a row, for one instruction set. All sets give the same bits.
struct RowKernels {
  std::string_view name;
  /// Each pixel is the mean of its bilinear samples of `count` sources, rounded.
  void (*sample)(const SampleSource* from, int count, const SampleRow& row, std::uint8_t* pixels);
  /// Grey levels to the numbers of the converter, in place.
  void (*expose)(const SensorRow& sensor, int count, std::uint8_t* values);
};

/// Those that this processor can run, the fastest first.
std::span<const RowKernels* const> UsableRowKernels();
inline const RowKernels& FastestRowKernels() { return *UsableRowKernels().front(); }

}  // namespace horopter::sim
