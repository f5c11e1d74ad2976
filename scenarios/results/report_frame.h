// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace horopter::scenarios
