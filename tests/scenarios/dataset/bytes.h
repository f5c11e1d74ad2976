// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <initializer_list>
#include <string>

#include "scenarios/dataset/format_error.h"

namespace horopter::scenarios {

inline std::string Bytes(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

/// The message of the FormatError that a call throws; "" when it throws none.
inline std::string FormatComplaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const FormatError& e) {
    return e.what();
  }
  return "";
}

}  // namespace horopter::scenarios
