// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// Edits that turn `a` into `b`: insertions, deletions, substitutions and swaps of two neighbours,
/// each counted once (the restricted Damerau-Levenshtein distance). Bytes, case matters.
std::size_t EditDistance(std::string_view a, std::string_view b);

/// The name that was probably meant: the nearest within a third of the longer length (at least
/// one edit), ignoring case, the first of equals; or one that `name` abbreviates (at least three
/// letters). Nothing when no name is near.
std::optional<std::string> NearestName(std::string_view name, std::span<const std::string> names);

/// "; did you mean 'width'?" when a name is near; otherwise "; known: a, b, c" (the first twelve);
/// empty without names.
std::string DidYouMean(std::string_view name, std::span<const std::string> names);

}  // namespace horopter::scenarios
