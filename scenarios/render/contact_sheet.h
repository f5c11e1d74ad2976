// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "scenarios/dataset/dataset_writer.h"

namespace horopter::scenarios {

/// A picture of many frames for people: a row per frame and pair, with the left image, the right
/// one, and, where there is truth, the left eye's depth and its disparity.
class ContactSheet {
 public:
  /// @param most_rows further frames are left out
  explicit ContactSheet(int most_rows = 8) : most_rows_(most_rows) {}

  void Add(const DatasetFrame& frame);

  /// Adds one of a set's frames when it is one of those that are spread over the whole set, first
  /// and last among them, and that there are rows for.
  void AddSpread(const DatasetFrame& frame, int index, int all);

  /// Empty when nothing was added.
  const cv::Mat3b& picture() const { return picture_; }

 private:
  int most_rows_;
  int rows_ = 0;
  cv::Mat3b picture_;
};

}  // namespace horopter::scenarios
