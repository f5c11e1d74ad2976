// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// A list of seeds that cannot be read; `what()` names the part and the remedy.
class SeedsError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Reads "7", "1-20" or "1,3,5-7" into seeds, in the order given. Seeds are 0 to 2^53 - 1, at most
/// 10000 of them, each once.
/// @throws SeedsError
std::vector<std::uint64_t> ParseSeeds(const std::string& text);

}  // namespace horopter::scenarios
