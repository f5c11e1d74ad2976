// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/fill_in.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

#include "vision/disparity/edge_map.h"

namespace horopter::vision {
namespace {

/// Weight, weighted dx, weighted dy.
using Carried = cv::Vec3f;
using CarriedMap = cv::Mat_<Carried>;

/// Least confidence of a valid pixel: methods that report none still carry.
constexpr float kLeastWeight = 0.05F;

using Weights = std::array<float, 256>;

Weights MakeWeights(double reach_px, double colour_grey) {
  Weights weights;
  for (int difference = 0; difference < 256; ++difference) {
    const double distance = 1 + reach_px / colour_grey * difference;
    weights[difference] = static_cast<float>(std::exp(-std::numbers::sqrt2 / reach_px * distance));
  }
  return weights;
}

void CarryAlongRows(const EdgeMap& edges, const Weights& weights, CarriedMap& map) {
  cv::parallel_for_(cv::Range(0, map.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      Carried* row = map[y];
      const std::uint8_t* edge = edges.x.data() + static_cast<std::ptrdiff_t>(y) * map.cols;
      for (int x = 1; x < map.cols; ++x) row[x] += weights[edge[x]] * (row[x - 1] - row[x]);
      for (int x = map.cols - 2; x >= 0; --x) {
        row[x] += weights[edge[x + 1]] * (row[x + 1] - row[x]);
      }
    }
  });
}

void CarryAlongColumns(const EdgeMap& edges, const Weights& weights, CarriedMap& map) {
  const auto carry = [&](int y, int from, int edge_row) {
    const std::uint8_t* edge = edges.y.data() + static_cast<std::ptrdiff_t>(edge_row) * map.cols;
    for (int x = 0; x < map.cols; ++x) map(y, x) += weights[edge[x]] * (map(from, x) - map(y, x));
  };
  for (int y = 1; y < map.rows; ++y) carry(y, y - 1, y);
  for (int y = map.rows - 2; y >= 0; --y) carry(y, y + 1, y + 1);
}

CarriedMap Valid(const DisparityField& field) {
  CarriedMap map(field.valid.size(), Carried(0, 0, 0));
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      if (field.valid(y, x) == 0) continue;
      const float weight = std::max(field.confidence(y, x), kLeastWeight);
      map(y, x) = {weight, weight * field.dx(y, x), weight * field.dy(y, x)};
    }
  }
  return map;
}

}  // namespace

void FillIn(const cv::Mat& guide, const FillInConfig& config, DisparityField& field) {
  field.filled = cv::Mat1b::zeros(field.valid.size());
  if (cv::countNonZero(field.valid) == 0) return;
  EdgeMap edges;
  FindEdges(guide, 0, edges);
  CarriedMap map = Valid(field);
  for (int pass = 0; pass < config.passes; ++pass) {
    // Each pass half as far, so that rows and columns do not show (Gastal & Oliveira, eq. 14).
    const double reach = config.reach_px * std::ldexp(1.0, -pass);
    const Weights weights = MakeWeights(reach, config.colour_grey * reach / config.reach_px);
    CarryAlongRows(edges, weights, map);
    CarryAlongColumns(edges, weights, map);
  }
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const Carried& carried = map(y, x);
      if (field.valid(y, x) != 0 || !(carried[0] > 0)) continue;
      field.dx(y, x) = carried[1] / carried[0];
      field.dy(y, x) = carried[2] / carried[0];
      field.confidence(y, x) = 0;
      field.valid(y, x) = field.filled(y, x) = 255;
    }
  }
}

}  // namespace horopter::vision
