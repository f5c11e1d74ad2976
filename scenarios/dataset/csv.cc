// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "scenarios/dataset/format_error.h"

namespace horopter::scenarios {
namespace {

/// Takes one record off the front of `text`, counting the line ends in it.
std::vector<std::string> TakeRecord(std::string_view* text, const std::string& name, int* line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  const int begun = *line;
  for (std::size_t i = 0; i < text->size(); ++i) {
    const char c = (*text)[i];
    if (c == '\n') ++*line;
    if (quoted) {
      if (c != '"') {
        fields.back() += c;
      } else if (i + 1 < text->size() && (*text)[i + 1] == '"') {
        fields.back() += (*text)[++i];
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      fields.emplace_back();
    } else if (c == '\n') {
      text->remove_prefix(i + 1);
      return fields;
    } else {
      fields.back() += c;
    }
  }
  throw FormatError(fmt::format("{}:{}: truncated: the last line has no end{}", name, begun,
                                quoted ? ", nor has its quote" : ""));
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string_view header, std::string name)
    : name_(std::move(name)) {
  if (text.substr(0, header.size()) != header || text.size() <= header.size() ||
      text[header.size()] != '\n') {
    throw FormatError(fmt::format("{}:1: the first line is not '{}'", name_, header));
  }
  const auto columns = static_cast<std::size_t>(1 + std::count(header.begin(), header.end(), ','));
  text.remove_prefix(header.size() + 1);
  for (int line = 2; !text.empty();) {
    const int begun = line;
    rows_.push_back({TakeRecord(&text, name_, &line), begun});
    if (rows_.back().fields.size() == columns) continue;
    throw FormatError(fmt::format("{}:{}: {} fields, the header names {}", name_, begun,
                                  rows_.back().fields.size(), columns));
  }
}

double CsvTable::Number(std::size_t row, std::size_t column) const {
  const std::string& text = Text(row, column);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw FormatError(At(row, column, "is no number"));
  }
  return number;
}

std::string CsvTable::At(std::size_t row, std::size_t column, std::string_view what) const {
  return fmt::format("{}:{}: '{}' {}", name_, rows_.at(row).line, Text(row, column), what);
}

}  // namespace horopter::scenarios
