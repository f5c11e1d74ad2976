// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::sim {

/// The candidate a misspelt name most likely meant, by Levenshtein distance; the first of equals.
/// @return nothing when the best differs in more than a third of its letters (at least two are
///         forgiven): a far-fetched guess helps nobody.
std::optional<std::string> NearestName(std::string_view wanted,
                                       const std::vector<std::string>& candidates);

}  // namespace horopter::sim
