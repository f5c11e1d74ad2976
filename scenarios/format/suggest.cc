// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/suggest.h"

#include <algorithm>
#include <vector>

namespace horopter::scenarios {
namespace {

// Beyond this no edit distance is worth its quadratic cost.
constexpr std::size_t kLongestName = 128;
constexpr std::size_t kMostListed = 12;

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace

std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::optional<std::string> NearestName(std::string_view name, std::span<const std::string> names) {
  if (name.empty() || name.size() > kLongestName) return std::nullopt;
  const std::string wanted = Lower(name);
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string& candidate : names) {
    if (candidate.size() > kLongestName) continue;
    const std::size_t edits = EditDistance(wanted, Lower(candidate));
    const std::size_t allowed =
        std::max<std::size_t>(1, std::max(name.size(), candidate.size()) / 3);
    if (edits <= allowed && (!nearest || edits < least)) {
      nearest = candidate;
      least = edits;
    }
  }
  if (nearest || wanted.size() < 3) return nearest;
  const auto abbreviated = std::find_if(names.begin(), names.end(), [&](const std::string& n) {
    return Lower(n).starts_with(wanted);
  });
  if (abbreviated != names.end()) nearest = *abbreviated;
  return nearest;
}

std::string DidYouMean(std::string_view name, std::span<const std::string> names) {
  if (names.empty()) return "";
  if (const auto nearest = NearestName(name, names)) return "; did you mean '" + *nearest + "'?";
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i) {
    list += (i == 0 ? "; known: " : ", ") + names[i];
  }
  if (names.size() > kMostListed) list += ", ...";
  return list;
}

}  // namespace horopter::scenarios
