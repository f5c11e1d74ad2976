// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/option_text.h"

#include <charconv>
#include <cmath>

#include "hardware/types/config_error.h"

namespace horopter::scenarios {

void RefuseOption(const std::string& option, const std::string& value, const std::string& why) {
  throw hardware::ConfigError({{option, value, why}});
}

std::vector<double> Numbers(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const std::string_view piece = text.substr(0, text.find(','));
    double number = 0;
    const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), number);
    if (error != std::errc() || end != piece.data() + piece.size() || !std::isfinite(number)) {
      return {};
    }
    numbers.push_back(number);
    if (piece.size() == text.size()) return numbers;
    text.remove_prefix(piece.size() + 1);
  }
}

std::pair<std::string, std::vector<double>> NamedNumbers(const std::string& option,
                                                         const std::string& text,
                                                         const std::string& form) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals > 0) {
    auto numbers = Numbers(std::string_view(text).substr(equals + 1));
    if (!numbers.empty()) return {text.substr(0, equals), std::move(numbers)};
  }
  RefuseOption(option, text, "must be " + form);
}

}  // namespace horopter::scenarios
