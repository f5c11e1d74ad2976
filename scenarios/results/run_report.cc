// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/run_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/results/frame_section.h"
#include "scenarios/results/html.h"
#include "scenarios/results/plan_svg.h"
#include "scenarios/results/text.h"
#include "scenarios/results/time_chart.h"
#include "scenarios/results/timing_notice.h"

namespace horopter::scenarios {
namespace {

std::string Header(const RunSummary& run) {
  std::string html =
      fmt::format("<header>{}<div><h1>{}</h1>", Badge(run.outcome), EscapeHtml(run.scenario));
  if (!run.description.empty()) {
    html += fmt::format("<p class=\"lead\">{}</p>", EscapeHtml(run.description));
  }
  for (const std::string& fault : run.faults) {
    html += fmt::format("<p>Fault injected on purpose: {}</p>", EscapeHtml(fault));
  }
  html += fmt::format(
      "<ul class=\"facts\"><li><span>seed</span> <b>{}</b></li><li><span>backend</span> <b>{}</b>"
      "</li><li><span>simulated</span> <b>{}</b></li><li><span>took</span> <b>{}</b></li>"
      "<li><span>build</span> <b>{}</b></li></ul>",
      run.seed, EscapeHtml(run.backend), Quantity(run.sim_s, "s"), Quantity(run.wall_s, "s"),
      EscapeHtml(DescribeBuild(run.versions)));
  return html + "</div></header>\n";
}

/// Why the run is not a pass, before anything else.
std::string Notice(const RunSummary& run) {
  if (run.outcome == Outcome::kPassed) return "";
  std::string html = fmt::format("<div class=\"notice {}\" role=\"alert\">", ToString(run.outcome));
  if (run.outcome == Outcome::kError) {
    html += "<p><b>The run stopped with an error.</b> What follows is what it had until then.</p>";
  } else if (run.outcome == Outcome::kIncomplete) {
    html += "<p><b>The run is incomplete.</b> What follows is what it had when it ended.</p>";
  }
  if (!run.error.empty()) html += fmt::format("<p>{}</p>", EscapeHtml(run.error));
  std::string failures;
  for (const ExpectationResult& e : run.expectations) {
    if (e.outcome != ExpectationOutcome::kFailed) continue;
    failures +=
        fmt::format("<li><b>{}</b>: {}</li>", EscapeHtml(e.name),
                    e.detail.empty() ? "was " + Quantity(e.value, e.unit) : EscapeHtml(e.detail));
  }
  if (!failures.empty()) html += "<p><b>Not met:</b></p><ul>" + failures + "</ul>";
  return html + "</div>\n";
}

std::string SlowerThanModelled(const RunSummary& run) {
  std::string html;
  for (const std::string& notice : TimingNotices({run})) {
    html += fmt::format("<p><b>Slower than modelled.</b> {}.</p>", EscapeHtml(notice));
  }
  return html.empty() ? "" : "<div class=\"notice incomplete\">" + html + "</div>\n";
}

std::string ExpectationRow(const ExpectationResult& e) {
  const bool explained = !e.detail.empty() && e.outcome != ExpectationOutcome::kPassed;
  return fmt::format(
      "<tr><td>{}{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
      EscapeHtml(e.name), explained ? "<small>" + EscapeHtml(e.detail) + "</small>" : "",
      Quantity(e.value, e.unit), Quantity(e.limit, e.unit), Badge(e.outcome));
}

std::string Expectations(const RunSummary& run) {
  std::string html = "<section class=\"card\"><h2>Expectations</h2>";
  if (run.expectations.empty()) {
    return html + "<p class=\"empty\">The scenario expects nothing.</p></section>\n";
  }
  html +=
      "<div class=\"scroll\"><table><thead><tr><th>expected</th><th class=\"number\">value</th>"
      "<th class=\"number\">limit</th><th>outcome</th></tr></thead><tbody>\n";
  for (const ExpectationResult& e : run.expectations) html += ExpectationRow(e);
  return html + "</tbody></table></div></section>\n";
}

std::vector<PlanMark> Marks(const std::vector<EmbeddedFrame>& pictures) {
  std::vector<PlanMark> marks;
  for (const EmbeddedFrame& frame : pictures) {
    const FrameRecord& record = frame.record;
    marks.push_back({record.true_pose.value_or(record.odometry), std::to_string(record.index),
                     fmt::format("#frame-{}", record.index)});
  }
  return marks;
}

std::string Where(const RunReport& report) {
  return "<section class=\"card\"><h2>Where it went</h2>\n" +
         PlanSvg(report.plan, Marks(report.pictures)) + "</section>\n";
}

/// The starts of the run's steps, as the frames tell them.
std::vector<std::pair<double, std::string>> Steps(const std::vector<FrameRecord>& frames) {
  std::vector<std::pair<double, std::string>> steps;
  for (const FrameRecord& frame : frames) {
    if (!frame.step.empty() && (steps.empty() || steps.back().second != frame.step)) {
      steps.emplace_back(hardware::ToSeconds(frame.t_capture), frame.step);
    }
  }
  return steps;
}

template <typename Value>
TimeSeries Series(const std::string& name, const std::vector<FrameRecord>& frames, Value&& value) {
  TimeSeries series{name, {}};
  for (const FrameRecord& frame : frames) {
    series.points.emplace_back(hardware::ToSeconds(frame.t_capture), value(frame));
  }
  return series;
}

std::vector<ChartLimit> LimitsOf(const RunSummary& run, const std::string& metric, double factor) {
  std::vector<ChartLimit> limits;
  for (const ExpectationResult& e : run.expectations) {
    const bool drawn = e.metric.compare(0, metric.size(), metric) == 0 && std::isfinite(e.limit);
    if (!e.metric.empty() && drawn) limits.push_back({e.name, e.limit * factor});
  }
  return limits;
}

std::optional<double> Percent(std::optional<double> fraction) {
  return fraction ? std::optional(100 * *fraction) : std::nullopt;
}

std::vector<TimeChart> ChartsOf(const RunReport& report) {
  const auto& frames = report.frames;
  TimeChart depth{"Depth error |Z \u2212 Z*| / Z*", "%", {}, {}, {}};
  depth.series.push_back(Series("median", frames, [](const FrameRecord& f) {
    return f.depth ? Percent(f.depth->abs_rel_median) : std::nullopt;
  }));
  depth.series.push_back(Series("mean", frames, [](const FrameRecord& f) {
    return f.depth ? Percent(f.depth->abs_rel_mean) : std::nullopt;
  }));
  depth.limits = LimitsOf(report.summary, "depth.abs_rel", 100);
  TimeChart clearance{"Clearance", "m", {}, LimitsOf(report.summary, "clearance", 1), {}};
  clearance.series.push_back(
      Series("clearance", frames, [](const FrameRecord& f) { return f.clearance_m; }));
  TimeChart fixation{
      "Fixation error", "deg", {}, LimitsOf(report.summary, "fixation.error_deg", 1), {}};
  fixation.series.push_back(
      Series("fixation error", frames, [](const FrameRecord& f) { return f.fixation_error_deg; }));
  TimeChart density{"Pixels with a disparity", "%", {}, {}, {}};
  density.series.push_back(Series("density", frames, [](const FrameRecord& f) {
    return std::optional(100 * f.disparity_density);
  }));
  std::vector<TimeChart> charts = {depth, clearance, fixation, density};
  for (TimeChart& chart : charts) chart.steps = Steps(frames);
  return charts;
}

std::string OverTime(const RunReport& report) {
  const double end_s = report.summary.sim_s.value_or(0);
  std::string svg;
  for (const TimeChart& chart : ChartsOf(report)) svg += TimeChartSvg(chart, end_s).value_or("");
  if (svg.empty()) svg = "<p class=\"empty\">No vision cycle took place.</p>";
  return "<section class=\"card\"><h2>Over the run</h2>\n" + svg + "</section>\n";
}

std::string NumberOrDash(std::optional<double> value) {
  return value ? ShortNumber(*value) : "\u2013";
}

std::string TimingRow(const std::string& stage, const StageTiming& timing, double longest_ms) {
  const double scale = longest_ms > 0 ? 100 / longest_ms : 0;
  return fmt::format(
      "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td aria-hidden=\"true\"><div class=\"bar\" "
      "style=\"width:{:.1f}%\"></div><div class=\"bar\" style=\"width:{:.1f}%\"></div></td></tr>\n",
      EscapeHtml(stage), NumberOrDash(timing.median_ms), NumberOrDash(timing.p95_ms), timing.n,
      timing.median_ms.value_or(0) * scale, timing.p95_ms.value_or(0) * scale);
}

std::string Timing(const RunSummary& run) {
  std::string html = "<section class=\"card\"><h2>Time per stage</h2>";
  if (run.timing_ms.empty()) {
    return html + "<p class=\"empty\">Nothing was timed.</p></section>\n";
  }
  double longest_ms = 0;
  for (const auto& [stage, timing] : run.timing_ms) {
    longest_ms = std::max({longest_ms, timing.median_ms.value_or(0), timing.p95_ms.value_or(0)});
  }
  html +=
      "<div class=\"scroll\"><table><thead><tr><th>stage</th><th class=\"number\">median ms</th>"
      "<th class=\"number\">95 % ms</th><th class=\"number\">times</th>"
      "<th style=\"width:30%\">median, 95 %</th></tr></thead><tbody>\n";
  for (const auto& [stage, timing] : run.timing_ms) html += TimingRow(stage, timing, longest_ms);
  return html + "</tbody></table></div></section>\n";
}

std::string Key(const std::string& name, const std::string& html) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", EscapeHtml(name), html);
}

std::string CodeOrDash(const std::string& text) {
  return text.empty() ? "\u2013" : "<code>" + EscapeHtml(text) + "</code>";
}

/// By the resolved scenario, which has the seed, the backend and every default as they were.
std::string Repeat(const RunReport& report) {
  const RunSummary& run = report.summary;
  std::string html =
      "<section class=\"card\"><h2>To repeat it</h2>\n<p>In the folder of this page, with the "
      "scenario as it was then:</p>\n<pre><code>horopter run scenario.yaml</code></pre>\n"
      "<dl class=\"keys\">\n";
  if (!run.file.empty()) html += Key("played from", CodeOrDash(run.file));
  html += Key("image hash", CodeOrDash(run.image_hash));
  html += Key("decision hash", CodeOrDash(run.decision_hash));
  html += Key("GL renderer", run.gl_renderer.empty() ? "\u2013" : EscapeHtml(run.gl_renderer));
  html +=
      Key("machine", EscapeHtml(DescribeMachine(run.machine)) +
                         (run.machine.load ? fmt::format("; load {:.2f}", *run.machine.load) : ""));
  for (const auto& [name, version] : run.versions) html += Key(name, EscapeHtml(version));
  html += "</dl>\n";
  if (!report.resolved_scenario.empty()) {
    html += "<details><summary>The scenario with all defaults filled in</summary><pre><code>" +
            EscapeHtml(report.resolved_scenario) + "</code></pre></details>\n";
  }
  return html + "</section>\n";
}

std::string Metrics(const RunSummary& run) {
  if (run.metrics.empty()) return "";
  std::string rows;
  for (const auto& [name, value] : run.metrics) {
    rows += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td></tr>\n", EscapeHtml(name),
                        ShortNumber(value));
  }
  return fmt::format(
      "<details><summary>All {} metrics</summary><table><tbody>\n{}</tbody></table>"
      "</details>\n",
      run.metrics.size(), rows);
}

}  // namespace

std::string RunReportHtml(const RunReport& report) {
  const RunSummary& run = report.summary;
  const std::string title =
      fmt::format("{}: {} seed {}", ToString(run.outcome), run.scenario, run.seed);
  std::string body = Header(run) + Notice(run) + SlowerThanModelled(run);
  body += "<div class=\"columns\">\n" + Where(report) + Expectations(run) + "</div>\n";
  body += FrameSection(report.pictures);
  body += "<div class=\"columns\">\n" + OverTime(report) + "<div>\n" + Timing(run) +
          Repeat(report) + "</div></div>\n";
  body += "<footer>" + Metrics(run) +
          "Beside this page: summary.json, junit.xml, frames.csv, trajectory.csv, plan.json, "
          "plan.svg, scenario.yaml, stack.json and frames/.</footer>\n";
  return HtmlPage(title, body);
}

}  // namespace horopter::scenarios
