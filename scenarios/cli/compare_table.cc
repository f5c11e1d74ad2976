// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/compare_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace horopter::scenarios {
namespace {

const char* Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kSame:
      return "same";
    case Verdict::kWithinNoise:
      return "noise";
    case Verdict::kBetter:
      return "better";
    case Verdict::kWorse:
      return "WORSE";
  }
  return "?";
}

using Row = std::vector<std::string>;

/// Columns padded to their widest cell.
std::string Aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format(" {:<{}}", row[i], widths[i]);
    while (line.ends_with(' ')) line.pop_back();
    text += line + "\n";
  }
  return text;
}

/// The rows worth showing, worst first; the order is otherwise kept.
template <typename Change>
std::vector<Change> Shown(std::vector<Change> changes, bool all) {
  if (!all) {
    std::erase_if(changes, [](const Change& c) {
      return c.verdict == Verdict::kSame || c.verdict == Verdict::kWithinNoise;
    });
  }
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return (a.verdict == Verdict::kWorse) > (b.verdict == Verdict::kWorse);
  });
  return changes;
}

std::string Hidden(std::size_t hidden, const char* what) {
  return hidden == 0 ? "" : fmt::format("  {} {} the same or within noise\n", hidden, what);
}

std::string List(const char* heading, const std::vector<std::string>& runs) {
  std::string text;
  if (!runs.empty()) text += fmt::format("{}\n", heading);
  for (const std::string& run : runs) text += "  " + run + "\n";
  return text;
}

std::string Outcomes(const std::vector<OutcomeChange>& changes) {
  if (changes.empty()) return "";
  std::vector<Row> rows = {{"verdict", "run", "expectation", "before", "after"}};
  for (const OutcomeChange& c : Shown(changes, true)) {
    rows.push_back({Name(c.verdict), c.run, c.expectation.empty() ? "(run)" : c.expectation,
                    c.before, c.after});
  }
  return "Outcomes\n" + Aligned(rows);
}

/// "seed 4: 0.324 -> 0.051, worse by 0.273, noise 0.16"
std::string WorstPair(const SeedChange& worst) {
  return fmt::format("seed {}: {:.4g} -> {:.4g}, {} {:.3g}, noise {:.2g}", worst.seed, worst.before,
                     worst.after, worst.verdict == Verdict::kWorse ? "WORSE by" : "worse by",
                     worst.worsening, worst.noise);
}

std::string MetricRows(const std::vector<MetricChange>& changes, bool all) {
  if (changes.empty()) return "";
  const auto shown = Shown(changes, all);
  std::vector<Row> rows = {{"verdict", "scenario", "backend", "metric", "before", "after", "unit",
                            "worse by", "noise", "seeds", "worst seed"}};
  for (const MetricChange& c : shown) {
    rows.push_back({Name(c.verdict), c.scenario, c.backend, c.metric,
                    fmt::format("{:.4g}", c.before), fmt::format("{:.4g}", c.after), c.unit,
                    fmt::format("{:+.3g}", c.worsening), fmt::format("{:.2g}", c.noise),
                    std::to_string(c.pairs), WorstPair(c.worst)});
  }
  return "Metrics (medians over seeds)\n" + (shown.empty() ? "" : Aligned(rows)) +
         Hidden(changes.size() - shown.size(), "metrics");
}

std::string TimingRows(const std::vector<TimingChange>& changes, bool all) {
  if (changes.empty()) return "";
  const auto shown = Shown(changes, all);
  std::vector<Row> rows = {
      {"verdict", "scenario", "backend", "stage", "before ms", "after ms", "ratio", "noise"}};
  for (const TimingChange& c : shown) {
    rows.push_back({Name(c.verdict), c.scenario, c.backend, c.stage,
                    fmt::format("{:.3g}", c.before_ms), fmt::format("{:.3g}", c.after_ms),
                    fmt::format("{:.2f}", c.ratio), fmt::format("+-{:.0f} %", 100 * c.noise)});
  }
  return "Timings (medians over seeds)\n" + (shown.empty() ? "" : Aligned(rows)) +
         Hidden(changes.size() - shown.size(), "stages");
}

}  // namespace

std::string CompareTable(const SuiteComparison& c, bool all) {
  return fmt::format("{} runs on both sides\nold: horopter {}\nnew: horopter {}\n", c.pairs,
                     fmt::join(c.builds_before, " and "), fmt::join(c.builds_after, " and ")) +
         List("Only in the old results:", c.missing) + List("Only in the new results:", c.added) +
         Outcomes(c.outcomes) + MetricRows(c.metrics, all) + TimingRows(c.timings, all);
}

}  // namespace horopter::scenarios
