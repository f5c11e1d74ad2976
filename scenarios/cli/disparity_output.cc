// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/disparity_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "scenarios/dataset/disparity_files.h"
#include "scenarios/dataset/image_file.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/results/disparity_picture.h"

namespace horopter::scenarios {
namespace {

void RequirePlace(const char* option, const std::string& file,
                  const std::vector<std::string>& extensions) {
  if (file.empty()) return;
  const std::string extension = ExtensionOf(file);
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
    throw std::invalid_argument(fmt::format("{} {}: unknown format '{}': known are {}", option,
                                            file, extension, fmt::join(extensions, ", ")));
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw std::invalid_argument(
        fmt::format("{} {}: there is no folder {}: make it first", option, file, folder.string()));
  }
}

}  // namespace

void DisparityOutput::Validate() const {
  RequirePlace("--out", field, {".flo", ".pfm", ".png"});
  RequirePlace("--confidence", confidence, {".pfm", ".png"});
  RequirePlace("--viz", picture, {".png"});
}

std::vector<std::string> DisparityOutput::Write(const vision::DisparityField& estimate) const {
  std::vector<std::string> notes;
  if (!field.empty()) {
    const int left_out = WriteDisparity(field, estimate);
    if (left_out > 0) {
      notes.push_back(
          fmt::format("{}: {} disparities are not positive, or 256 px and more: KITTI's "
                      "16 bits cannot hold them; .flo can",
                      field, left_out));
    }
  }
  if (!confidence.empty() && ExtensionOf(confidence) == ".pfm") {
    WritePfm(confidence, estimate.confidence);
  } else if (!confidence.empty()) {
    cv::Mat1b levels;
    estimate.confidence.convertTo(levels, CV_8U, 255);
    WritePng(confidence, levels);
  }
  if (!picture.empty()) WritePng(picture, DisparityPicture(estimate));
  return notes;
}

}  // namespace horopter::scenarios
