// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/seeds.h"

#include <charconv>
#include <set>
#include <string_view>

namespace horopter::scenarios {
namespace {

constexpr std::uint64_t kLargestSeed = (std::uint64_t{1} << 53) - 1;
constexpr std::size_t kMostSeeds = 10000;

[[noreturn]] void Fail(const std::string& text, const std::string& why) {
  throw SeedsError("seeds '" + text.substr(0, 60) + "': " + why);
}

std::uint64_t ReadSeed(std::string_view word, const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  const bool number = !word.empty() && end == word.data() + word.size();
  if (number && (error == std::errc::result_out_of_range || seed > kLargestSeed)) {
    Fail(text, std::string(word) + " is too large: at most " + std::to_string(kLargestSeed));
  }
  if (!number || error != std::errc()) {
    Fail(text, "'" + std::string(word) + "' is no seed: write 7, 1-20 or 1,3,5-7");
  }
  return seed;
}

}  // namespace

std::vector<std::uint64_t> ParseSeeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  std::set<std::uint64_t> seen;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const std::size_t dash = part.find('-');
    const std::uint64_t first = ReadSeed(part.substr(0, dash), text);
    const std::uint64_t last =
        dash == std::string_view::npos ? first : ReadSeed(part.substr(dash + 1), text);
    if (last < first) {
      Fail(text, "the range " + std::string(part) + " runs backwards: write " +
                     std::to_string(last) + "-" + std::to_string(first));
    }
    if (last - first >= kMostSeeds - seeds.size()) {
      Fail(text, "more than " + std::to_string(kMostSeeds) + " seeds: play them in portions");
    }
    for (std::uint64_t seed = first; seed <= last; ++seed) {
      if (!seen.insert(seed).second) Fail(text, std::to_string(seed) + " stands twice");
      seeds.push_back(seed);
    }
    if (comma == std::string_view::npos) return seeds;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace horopter::scenarios
