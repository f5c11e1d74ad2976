// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// A whole page around a body: doctype, style, title. @param title plain text
std::string HtmlPage(std::string_view title, std::string_view body);

/// The outcome as a coloured badge with a symbol and the word, so that colour is never alone.
std::string Badge(Outcome outcome);
std::string Badge(ExpectationOutcome outcome);

/// A value with its unit, escaped: "0.123 m"; a dash where there is none.
std::string Quantity(std::optional<double> value, std::string_view unit);

}  // namespace horopter::scenarios
