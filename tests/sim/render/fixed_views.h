// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "sim/render/renderer.h"

namespace horopter::sim::testing {

/// A scene with all that the renderer knows: two shadow lights, textures on planes, boxes and round
/// shapes, glass, a sky, a floor without end and a body that moves.
extern const char* const kShowroomXml;

/// Poses around it, seen by cameras of several sizes, fields of view and principal points.
std::vector<PosedCamera> FixedViews();

/// One 64-bit FNV-1a hash of all that was rendered.
std::uint64_t Hash(const RenderedView& view, std::uint64_t seed = 14695981039346656037ull);
std::uint64_t Hash(const cv::Mat& image, std::uint64_t seed);

}  // namespace horopter::sim::testing
