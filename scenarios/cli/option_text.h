// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace horopter::scenarios {

/// @throws hardware::ConfigError with these words
[[noreturn]] void RefuseOption(const std::string& option, const std::string& value,
                               const std::string& why);

/// Numbers with commas between them; empty when a piece is none.
std::vector<double> Numbers(std::string_view text);

/// "NAME=VALUES" in its two halves.
/// @param form that an option's text must have, for messages
/// @throws hardware::ConfigError
std::pair<std::string, std::vector<double>> NamedNumbers(const std::string& option,
                                                         const std::string& text,
                                                         const std::string& form);

}  // namespace horopter::scenarios
