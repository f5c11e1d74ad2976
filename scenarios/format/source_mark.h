// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace horopter::scenarios {

/// Where a thing of the scenario file was written, for messages: "file:line:column".
struct SourceMark {
  std::string file;
  int line = 0;    ///< from 1; 0 = not from a file
  int column = 0;  ///< from 1

  std::string ToString() const;
  bool operator==(const SourceMark&) const = default;
};

}  // namespace horopter::scenarios
