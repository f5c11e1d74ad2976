// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "scenarios/dataset/dataset_writer.h"

namespace horopter::scenarios {

/// The files of one frame, ready to be written.
struct FrameFiles {
  std::map<std::string, std::string> bytes;  ///< by name
  std::vector<std::string> images;           ///< names of the camera images among them
  std::map<std::string, int> left_out;       ///< valid pixels that did not fit, by name, where any
};

/// @param legend gives the objects; without it only parts are written
/// @throws std::invalid_argument as DatasetWriter::AddFrame()
FrameFiles EncodeFrame(const DatasetFrame& frame, const sim::SceneLegend* legend,
                       const DatasetOptions& options);

}  // namespace horopter::scenarios
