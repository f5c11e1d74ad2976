// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/disparity/disparity_field.h"

namespace horopter::scenarios {

/// The files that `horopter disparity` leaves; "" = not asked for.
struct DisparityOutput {
  std::string field;       ///< .flo, .pfm or .png (WriteDisparity)
  std::string confidence;  ///< .pfm, or .png where 255 is 1
  std::string picture;     ///< .png (DisparityPicture)

  /// To be called before the work. @throws std::invalid_argument naming the option: an extension
  /// that is not known, or a folder that is not there
  void Validate() const;

  /// @return notes for the user, a line each @throws ResultsError
  std::vector<std::string> Write(const vision::DisparityField& estimate) const;
};

}  // namespace horopter::scenarios
