// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// The text with everything replaced by U+FFFD that XML 1.0 and HTML cannot hold: bytes that are
/// not UTF-8, and control characters other than tab and line ends.
std::string CleanText(std::string_view text);

/// CleanText() with & < > " ' as entities: safe between tags and in quoted attributes.
std::string EscapeHtml(std::string_view text);

/// A relative path as it stands in an href: percent-encoded but for unreserved characters and '/'.
std::string UrlPath(std::string_view path);

/// A field of RFC 4180 CSV; line breaks become spaces, so that a row stays a line.
std::string CsvField(std::string_view text);

/// Shortest text that reads back as the same number; empty for NaN and for nothing.
std::string ExactNumber(std::optional<double> value);

/// For people: four significant digits without exponent noise; a dash for NaN and for nothing.
std::string ShortNumber(std::optional<double> value);

/// RFC 4648 base64 with padding. @pre less than 2 GiB
std::string Base64(std::span<const std::uint8_t> bytes);

}  // namespace horopter::scenarios
