// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/suite_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scenarios/results/html.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

int CountOf(const std::vector<RunSummary>& runs, Outcome outcome) {
  return static_cast<int>(std::count_if(
      runs.begin(), runs.end(), [&](const RunSummary& run) { return run.outcome == outcome; }));
}

/// The worst thing that happened, as far as it goes.
Outcome Overall(const std::vector<RunSummary>& runs) {
  for (const Outcome outcome : {Outcome::kError, Outcome::kFailed, Outcome::kIncomplete}) {
    if (CountOf(runs, outcome) > 0) return outcome;
  }
  return runs.empty() ? Outcome::kIncomplete : Outcome::kPassed;
}

std::string Header(const std::vector<RunSummary>& runs) {
  std::string html =
      fmt::format("<header>{}<div><h1>{} of {} runs passed</h1><ul class=\"facts\">",
                  Badge(Overall(runs)), CountOf(runs, Outcome::kPassed), runs.size());
  for (const Outcome outcome : {Outcome::kFailed, Outcome::kError, Outcome::kIncomplete}) {
    const int count = CountOf(runs, outcome);
    if (count > 0) {
      html += fmt::format("<li><b>{}</b> <span>{}</span></li>", count, ToString(outcome));
    }
  }
  return html + "</ul></div></header>\n";
}

/// Whether the run has written its own report: only a run that was finished has.
bool HasReport(const RunSummary& run) {
  return run.outcome != Outcome::kIncomplete || run.sim_s.has_value();
}

std::string Link(const RunSummary& run) {
  const std::string name = EscapeHtml(run.scenario);
  if (run.directory.empty()) return name;
  const std::string target = UrlPath(run.directory) + (HasReport(run) ? "/report.html" : "/");
  return fmt::format("<a href=\"{}\">{}</a>", EscapeHtml(target), name);
}

std::string Trouble(const RunSummary& run) {
  std::string html;
  if (!run.error.empty()) html += "<small>" + EscapeHtml(run.error) + "</small>";
  for (const ExpectationResult& e : run.expectations) {
    if (e.outcome != ExpectationOutcome::kFailed) continue;
    html +=
        fmt::format("<small>\u2717 {}: {}</small>", EscapeHtml(e.name),
                    e.detail.empty() ? "was " + Quantity(e.value, e.unit) : EscapeHtml(e.detail));
  }
  return html;
}

std::string Met(const RunSummary& run) {
  const auto count = [&](ExpectationOutcome outcome) {
    return std::count_if(run.expectations.begin(), run.expectations.end(),
                         [&](const ExpectationResult& e) { return e.outcome == outcome; });
  };
  return fmt::format("{} of {}", count(ExpectationOutcome::kPassed), run.expectations.size());
}

std::string Row(const RunSummary& run) {
  return fmt::format(
      "<tr><td>{}</td><td>{}{}</td><td class=\"number\">{}</td><td>{}</td><td class=\"number\">{}"
      "</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
      Badge(run.outcome), Link(run), Trouble(run), run.seed, EscapeHtml(run.backend), Met(run),
      Quantity(run.sim_s, "s"), Quantity(run.wall_s, "s"));
}

/// Which builds played the runs; usually one.
std::string Builds(const std::vector<RunSummary>& runs) {
  std::set<std::string> builds;
  for (const RunSummary& run : runs) builds.insert(DescribeBuild(run.versions));
  std::string html;
  for (const std::string& build : builds) {
    html += fmt::format("Played by horopter {}. ", EscapeHtml(build));
  }
  return html;
}

}  // namespace

std::string SuiteReportHtml(const std::vector<RunSummary>& runs) {
  std::string body = Header(runs);
  body +=
      "<section class=\"card\"><div class=\"scroll\"><table><thead><tr><th>outcome</th>"
      "<th>scenario</th><th class=\"number\">seed</th><th>backend</th>"
      "<th class=\"number\">met</th><th class=\"number\">simulated</th>"
      "<th class=\"number\">took</th></tr></thead><tbody>\n";
  for (const RunSummary& run : runs) body += Row(run);
  body += "</tbody></table></div></section>\n<footer>" + Builds(runs) +
          "Beside this page: summary.json and junit.xml of all runs.</footer>\n";
  return HtmlPage(fmt::format("{} of {} runs passed", CountOf(runs, Outcome::kPassed), runs.size()),
                  body);
}

}  // namespace horopter::scenarios
