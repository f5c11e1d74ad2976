// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/text_check.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace horopter::scenarios {
namespace {

constexpr std::size_t kMaxBytes = 1 << 20;

/// Length of the UTF-8 sequence at the front of `rest`, 0 when there is none (RFC 3629: no
/// overlong forms, no surrogates, nothing beyond U+10FFFF).
std::size_t SequenceLength(std::string_view rest) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(rest[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || rest.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
  const bool too_large = lead == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || too_large ? 0 : length;
}

std::optional<std::string> LineFault(std::string_view line, std::size_t* column) {
  const std::size_t indent = line.find_first_not_of(" ");
  if (indent != std::string_view::npos && line[indent] == '\t' &&
      line.find_first_not_of(" \t\r") != std::string_view::npos) {
    *column = indent + 1;
    return "a tab in the indentation: YAML indents with spaces";
  }
  for (std::size_t i = 0; i < line.size();) {
    *column = i + 1;
    const std::size_t length = SequenceLength(line.substr(i));
    if (length == 0) return "a byte that is not UTF-8: save the file as UTF-8";
    const auto c = static_cast<std::uint8_t>(line[i]);
    if ((c < 0x20 && c != '\t' && c != '\r') || c == 0x7f) {
      return "a control character: remove it";
    }
    i += length;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Diagnostic> CheckText(const std::string& text, const std::string& file) {
  std::vector<Diagnostic> faults;
  if (text.size() > kMaxBytes) {
    SourceMark start{file, 1, 1};
    faults.push_back({std::move(start), "larger than 1 MiB: this is no scenario"});
    return faults;
  }
  std::string_view rest = text;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::size_t column = 1;
    if (auto fault = LineFault(rest.substr(0, end), &column)) {
      faults.push_back({{file, line, static_cast<int>(column)}, std::move(*fault)});
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return faults;
}

std::size_t CodePoints(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<std::uint8_t>(c) & 0xc0) != 0x80;
  }));
}

}  // namespace horopter::scenarios
