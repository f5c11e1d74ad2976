// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenarios/results/report_frame.h"

namespace horopter::scenarios {

/// A frame with its pictures as data URIs, so that a page holding them needs no other file.
struct EmbeddedFrame {
  struct Picture {
    PictureKind kind;
    std::string data_uri;
    int width = 0;
    int height = 0;
  };

  FrameRecord record;
  ColourScales scales;
  std::vector<Picture> pictures;
};

/// At most twelve frames, evenly spread, and the last, with every picture they have, scaled down to
/// at most 360 px of width: photographs as JPEG, coloured maps as PNG. Beyond the budget the maps
/// become JPEG too, and then there are fewer frames.
/// @param budget_bytes of all data URIs together; one frame stays whatever it takes
/// @throws ResultsError when a picture's file cannot be read
std::vector<EmbeddedFrame> EmbedFrames(const std::vector<ReportFrame>& frames,
                                       std::size_t budget_bytes = 3'500'000);

}  // namespace horopter::scenarios
