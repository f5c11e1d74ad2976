// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// The pictures that a frame can have, in the order in which they are shown.
enum class PictureKind { kLeft, kRight, kRegions, kDisparity, kDepth, kTrueDepth, kDepthError };

/// Suffix of the picture's file: frames/0007_true_depth.png.
const char* FileSuffix(PictureKind kind);

/// A frame that has pictures, for the report.
struct ReportFrame {
  struct Picture {
    PictureKind kind;
    std::filesystem::path file;
  };

  FrameRecord record;
  ColourScales scales;
  std::vector<Picture> pictures;
};

/// Indices of at most `most` of `count` things, evenly spread, the first and the last among them
/// (the last alone when most is 1). @pre most >= 1
std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most);

}  // namespace horopter::scenarios
