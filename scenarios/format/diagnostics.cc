// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/diagnostics.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace horopter::scenarios {
namespace {

constexpr std::size_t kLongestExcerpt = 60;

std::vector<Diagnostic> InFileOrder(std::vector<Diagnostic> diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const auto& a, const auto& b) {
    return std::tie(a.mark.line, a.mark.column) < std::tie(b.mark.line, b.mark.column);
  });
  return diagnostics;
}

std::string Lines(const std::vector<Diagnostic>& diagnostics) {
  std::string lines;
  for (const Diagnostic& d : diagnostics) {
    if (!lines.empty()) lines += '\n';
    lines += d.ToString();
  }
  return lines;
}

}  // namespace

std::string SourceMark::ToString() const {
  if (line == 0) return file;
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

std::string Diagnostic::ToString() const {
  std::string text = mark.ToString() + ": " + message;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

ScenarioError::ScenarioError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(Lines(InFileOrder(diagnostics))),
      diagnostics_(InFileOrder(std::move(diagnostics))) {}

void Fail(SourceMark mark, std::string message) {
  std::vector<Diagnostic> one;
  one.push_back({std::move(mark), std::move(message)});
  throw ScenarioError(std::move(one));
}

void ThrowIfAny(std::vector<Diagnostic> diagnostics) {
  if (!diagnostics.empty()) throw ScenarioError(std::move(diagnostics));
}

std::string Excerpt(const std::string& text) {
  std::string excerpt = text.substr(0, kLongestExcerpt);
  for (char& c : excerpt) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  if (text.size() <= kLongestExcerpt) return excerpt;
  // Do not cut a UTF-8 sequence in two.
  while (!excerpt.empty() && (static_cast<unsigned char>(excerpt.back()) & 0xc0) == 0x80) {
    excerpt.pop_back();
  }
  if (!excerpt.empty() && static_cast<unsigned char>(excerpt.back()) >= 0xc0) excerpt.pop_back();
  return excerpt + "...";
}

}  // namespace horopter::scenarios
