// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// Parses a sentence that says what must hold of a run:
///
///     reached within D UNIT before T UNIT     e.g. reached within 0.15 m before 60 s
///     METRIC [OP] VALUE [UNIT]                e.g. contacts 0, clearance >= 5 cm
///
/// OP is one of <= >= < > ==, and == where it is left out. METRIC is one of Metrics(); VALUE is
/// converted to the metric's own unit, which is also what a missing UNIT means. Numbers are
/// decimal and finite.
/// @return the expectation without its mark, or what is wrong with the sentence and the remedy
std::variant<Expectation, std::string> ParseExpectation(const std::string& sentence);

/// ECMAScript pattern of the sentences above, for the JSON Schema. It accepts what ParseExpectation
/// does but for limits beyond what the metric can reach (a share above 1), which it cannot see.
std::string ExpectationPattern();

/// "<=" and so on.
const char* ToString(Comparison comparison);

}  // namespace horopter::scenarios
