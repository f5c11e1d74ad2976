// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/html.h"

#include <fmt/format.h>

#include "scenarios/results/report_style.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

std::string MakeBadge(std::string_view kind, std::string_view symbol, std::string_view word) {
  return fmt::format("<span class=\"badge {}\">{} {}</span>", kind, symbol, word);
}

}  // namespace

std::string HtmlPage(std::string_view title, std::string_view body) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"horopter\">\n";
  page += fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
                      EscapeHtml(title), ReportStyle());
  page += body;
  return page + "</main>\n</body>\n</html>\n";
}

std::string Badge(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPassed:
      return MakeBadge("passed", "\u2713", "passed");
    case Outcome::kFailed:
      return MakeBadge("failed", "\u2717", "failed");
    case Outcome::kError:
      return MakeBadge("error", "!", "error");
    case Outcome::kIncomplete:
      return MakeBadge("incomplete", "\u2026", "incomplete");
  }
  return "";
}

std::string Badge(ExpectationOutcome outcome) {
  switch (outcome) {
    case ExpectationOutcome::kPassed:
      return MakeBadge("passed", "\u2713", "pass");
    case ExpectationOutcome::kFailed:
      return MakeBadge("failed", "\u2717", "fail");
    case ExpectationOutcome::kNotApplicable:
      return MakeBadge("not_applicable", "\u2013", "not applicable");
  }
  return "";
}

std::string Quantity(std::optional<double> value, std::string_view unit) {
  const std::string number = ShortNumber(value);
  return unit.empty() || number == ShortNumber(std::nullopt)
             ? number
             : fmt::format("{} {}", number, EscapeHtml(unit));
}

}  // namespace horopter::scenarios
