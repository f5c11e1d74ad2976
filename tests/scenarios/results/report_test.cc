// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <pugixml.hpp>

#include "scenarios/results/plan_svg.h"
#include "scenarios/results/run_report.h"
#include "scenarios/results/run_writer.h"
#include "scenarios/results/suite_report.h"
#include "scenarios/results/text.h"
#include "scenarios/results/time_chart.h"
#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string ReportOf(const RunSummary& summary) {
  std::vector<FrameRecord> frames;
  for (int i = 0; i < 30; ++i) frames.push_back(ExampleFrame(i));
  return RunReportHtml({summary, ExamplePlan(), frames, {}, "name: \"<x>\"\n"});
}

RunSummary WithOutcome(Outcome outcome, const std::string& error) {
  RunSummary run = ExampleSummary();
  run.outcome = outcome;
  run.error = error;
  return run;
}

TEST(RunReport, ShowsEveryExpectationWithValueLimitAndWord) {
  const std::string html = ReportOf(ExampleSummary());
  for (const ExpectationResult& e : ExampleSummary().expectations) {
    const auto at = html.find("<tr><td>" + EscapeHtml(e.name));
    ASSERT_NE(at, std::string::npos) << e.name;
    const std::string row = html.substr(at, html.find("</tr>", at) - at);
    EXPECT_THAT(row, HasSubstr(ShortNumber(e.value)));
    EXPECT_THAT(row, HasSubstr(ShortNumber(e.limit)));
    const char* word = e.outcome == ExpectationOutcome::kPassed   ? "\u2713 pass"
                       : e.outcome == ExpectationOutcome::kFailed ? "\u2717 fail"
                                                                  : "not applicable";
    EXPECT_THAT(row, HasSubstr(word));
  }
}

TEST(RunReport, EscapesWhatComesFromOutside) {
  RunSummary run = WithOutcome(Outcome::kError, "<script>alert(1)</script>");
  const std::string evil = "<img src=x onerror=alert(1)>\"'&";
  run.scenario = run.description = run.file = run.backend = run.gl_renderer = evil;
  run.expectations[0].name = run.expectations[0].unit = run.expectations[0].detail = evil;
  run.metrics[evil] = 1;
  run.timing_ms[evil] = {1, 2, 3};
  run.versions[evil] = evil;
  run.image_hash = run.decision_hash = run.directory = evil;
  FrameRecord frame = ExampleFrame(0);
  frame.step = frame.decision = evil;
  PlanRecord plan = ExamplePlan();
  plan.shapes[4].name = plan.shapes[4].kind = evil;
  EmbeddedFrame pictured{frame, {}, {{PictureKind::kLeft, "data:image/png;base64,AA==", 1, 1}}};
  const std::string html = RunReportHtml({run, plan, {frame}, {pictured}, evil});
  EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(SuiteReportHtml({run}), Not(HasSubstr("<img src=x")));
  EXPECT_THAT(html, HasSubstr(EscapeHtml(evil)));
}

TEST(RunReport, NeedsNothingBesideIt) {
  const std::string html = ReportOf(ExampleSummary());
  for (const char* outside : {"<link", "src=\"http", "@import", "url(", "<iframe"}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
}

TEST(RunReport, SaysPlainlyHowTheRunEnded) {
  EXPECT_THAT(ReportOf(ExampleSummary()), HasSubstr("Not met:"));
  const std::string error = ReportOf(WithOutcome(Outcome::kError, "no GL context"));
  EXPECT_THAT(error, HasSubstr("stopped with an error"));
  EXPECT_THAT(error, HasSubstr("no GL context"));
  EXPECT_THAT(ReportOf(WithOutcome(Outcome::kIncomplete, "")), HasSubstr("The run is incomplete"));
  RunSummary passed = WithOutcome(Outcome::kPassed, "");
  passed.expectations.resize(1);
  EXPECT_THAT(ReportOf(passed), Not(HasSubstr("role=\"alert\"")));
}

TEST(RunReport, OfARunThatHasNothingStillSaysSo) {
  RunSummary bare;
  bare.scenario = "bare";
  bare.error = "stopped at once";
  const std::string html = RunReportHtml({bare, {}, {}, {}, ""});
  EXPECT_THAT(html, HasSubstr("No vision cycle took place"));
  EXPECT_THAT(html, HasSubstr("No frame with pictures"));
  EXPECT_THAT(html, HasSubstr("Nothing was timed"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(RunReport, NamesTheCommandThatRepeatsTheRun) {
  // Not the file that it was played from: that may have changed, as may the defaults.
  const ScratchFolder scratch;
  RunWriter writer(scratch.path(), "seed: 7\n", ExampleSummary());
  writer.Finish(ExampleSummary(), ExamplePlan());
  const std::string html = ContentOf(scratch.path() / "report.html");
  EXPECT_THAT(html, HasSubstr("<code>horopter run scenario.yaml</code>"));
  EXPECT_THAT(html, Not(HasSubstr("horopter run " + ExampleSummary().file)));
  EXPECT_EQ(ContentOf(scratch.path() / "scenario.yaml"), "seed: 7\n");
}

TEST(EmbedFrames, ShowsTwelveFramesAndTheLastWithinTheBudget) {
  const ScratchFolder scratch;
  RunWriter writer(scratch.path(), "", ExampleSummary());
  for (int i = 0; i < 30; ++i) writer.AddFrame(ExampleFrame(i), ExampleImages(i));
  writer.Finish(ExampleSummary(), ExamplePlan());
  const std::string html = ContentOf(scratch.path() / "report.html");
  EXPECT_LT(html.size(), 4'500'000u);
  std::size_t shown = 0;
  for (std::size_t at = html.find("<article"); at != std::string::npos;
       at = html.find("<article", at + 1)) {
    ++shown;
  }
  EXPECT_GE(shown, 7u);
  EXPECT_LE(shown, 13u);
  EXPECT_THAT(html, HasSubstr("id=\"frame-0\""));
  EXPECT_THAT(html, HasSubstr("id=\"frame-29\""));
  EXPECT_THAT(html, HasSubstr("href=\"#frame-29\"")) << "the plan links to the frame";
}

TEST(EmbedFrames, ShowsBothEyesOfEveryFrame) {
  const ScratchFolder scratch;
  RunWriter writer(scratch.path(), "", ExampleSummary());
  FrameImages images = ExampleImages(0);
  images.right_bgr = cv::Mat(images.left_bgr.size(), CV_8UC3, cv::Scalar(0, 0, 200));
  writer.AddFrame(ExampleFrame(0), images);
  writer.AddFrame(ExampleFrame(1), images);
  writer.Finish(ExampleSummary(), ExamplePlan());
  const std::string html = ContentOf(scratch.path() / "report.html");
  for (const char* frame : {"frame 0", "frame 1"}) {
    EXPECT_THAT(html, HasSubstr(std::string("alt=\"Left eye, ") + frame));
    EXPECT_THAT(html, HasSubstr(std::string("alt=\"Right eye, ") + frame));
  }
  const auto right_in = [&scratch](const std::string& name) {
    return EmbedFrames({{ExampleFrame(0), {}, {{PictureKind::kRight, scratch.path() / name}}}})
        .at(0)
        .pictures.at(0)
        .data_uri;
  };
  EXPECT_THAT(html, HasSubstr(right_in("frames/0000_right.png")));
  EXPECT_NE(right_in("frames/0000_right.png"), right_in("frames/0000_left.png"));
}

TEST(RunReport, SaysWhatTheDepthErrorComesTo) {
  const EmbeddedFrame pictured{
      ExampleFrame(0), {}, {{PictureKind::kDepth, "data:image/png;base64,AA==", 1, 1}}};
  const std::string html = RunReportHtml({ExampleSummary(), {}, {}, {pictured}, ""});
  EXPECT_THAT(html, HasSubstr("<dt>of the pixels have a depth</dt><dd>81 %</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>too near on average</dt><dd>0.012 m</dd>"));
  EmbeddedFrame unjudged = pictured;
  unjudged.record.depth.reset();
  EXPECT_THAT(RunReportHtml({ExampleSummary(), {}, {}, {unjudged}, ""}), HasSubstr("No truth"));
}

TEST(RunReport, NamesTheBuildAndTheMachine) {
  const std::string html = ReportOf(ExampleSummary());
  EXPECT_THAT(html, HasSubstr("0.1.0 (abc1234-dirty), program 0123456789ab"));
  EXPECT_THAT(html, HasSubstr("Example &amp; Sons 3000, 2 cores; load 0.75"));
  EXPECT_THAT(SuiteReportHtml({ExampleSummary()}), HasSubstr("0.1.0 (abc1234-dirty)"));
}

TEST(EmbedFrames, FitsEvenABudgetForOneFrameAndNamesAMissingFile) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "0000_left.png";
  cv::Mat3b noise(200, 200);
  cv::randu(noise, 0, 255);
  cv::imwrite(file.string(), noise);
  const std::vector<ReportFrame> frames(9, {{}, {}, {{PictureKind::kLeft, file}}});
  EXPECT_EQ(EmbedFrames(frames).size(), 9u);
  EXPECT_EQ(EmbedFrames(frames, 1).size(), 1u);
  const std::vector<ReportFrame> missing(1, {{}, {}, {{PictureKind::kLeft, "/nowhere/x.png"}}});
  EXPECT_THROW(EmbedFrames(missing), ResultsError);
}

TEST(EvenlySpaced, KeepsTheEndsAndTheOrder) {
  EXPECT_THAT(EvenlySpaced(30, 4), ::testing::ElementsAre(0, 10, 19, 29));
  EXPECT_THAT(EvenlySpaced(3, 13), ::testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(EvenlySpaced(5, 1), ::testing::ElementsAre(4));
  EXPECT_TRUE(EvenlySpaced(0, 3).empty());
}

TEST(PlanSvg, IsWellFormedAndHoldsAllThatWasPlanned) {
  PlanRecord plan = ExamplePlan();
  plan.shapes[4].name = "<table> & \"chairs\"";
  pugi::xml_document svg;
  const auto result = svg.load_string(PlanSvg(plan, {{{1, 0, 0}, "4", "#frame-4"}}).c_str());
  ASSERT_TRUE(result) << result.description();
  const pugi::xml_node root = svg.child("svg");
  const auto count = [&](const std::string& query) {
    return root.select_nodes(query.c_str()).size();
  };
  EXPECT_EQ(count("polygon[@class='wall']"), 4u);
  EXPECT_EQ(count("polygon[@class='obstacle']"), 2u);
  EXPECT_EQ(count("polygon[@class='furniture']"), 2u);
  EXPECT_EQ(count("polyline[@class='true']"), 1u);
  EXPECT_EQ(count("polyline[@class='odometry']"), 1u);
  EXPECT_EQ(count("polyline[@class='swept']"), 1u);
  EXPECT_EQ(count("g[title='start']"), 1u);
  EXPECT_EQ(count("g[title='end']"), 1u);
  EXPECT_EQ(count("a[@href='#frame-4']"), 1u);
}

// One metre is as long upwards as to the right, and +y is up.
TEST(PlanSvg, DrawsToScaleWithYUp) {
  PlanRecord plan;
  plan.shapes = {{"a", "obstacle", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(PlanSvg(plan).c_str()));
  const std::string points = svg.child("svg").child("polygon").attribute("points").value();
  double x[4], y[4];
  ASSERT_EQ(std::sscanf(points.c_str(), "%lf,%lf %lf,%lf %lf,%lf %lf,%lf", x, y, x + 1, y + 1,
                        x + 2, y + 2, x + 3, y + 3),
            8);
  EXPECT_GT(x[1], x[0]);
  EXPECT_LT(y[3], y[0]);
  EXPECT_NEAR(x[1] - x[0], y[0] - y[3], 0.2);
}

TEST(PlanSvg, OfAnEmptyPlanShowsTheStart) {
  pugi::xml_document svg;
  const std::string text = PlanSvg({});
  ASSERT_TRUE(svg.load_string(text.c_str()));
  EXPECT_EQ(svg.child("svg").select_nodes("g[title='start']").size(), 1u);
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(TimeChart, BreaksItsLineWhereAValueIsMissing) {
  const TimeChart chart{"Clearance",
                        "m",
                        {{"clearance", {{0, 1}, {1, 2}, {2, std::nullopt}, {3, 1}, {4, 2}}}},
                        {{"limit", 0.5}},
                        {{0, "goto"}}};
  const auto svg = TimeChartSvg(chart, 5);
  ASSERT_TRUE(svg);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg->c_str()));
  const std::string path = document.child("svg")
                               .find_child_by_attribute("path", "class", "line1")
                               .attribute("d")
                               .value();
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 2);
}

TEST(TimeChart, OfNothingIsNothing) {
  EXPECT_FALSE(TimeChartSvg({"x", "", {{"x", {{0, std::nullopt}}}}, {}, {}}, 5));
  EXPECT_FALSE(TimeChartSvg({"x", "", {}, {}, {}}, 0));
  EXPECT_TRUE(TimeChartSvg({"x", "", {{"x", {{0, 0.0}}}}, {}, {}}, 0));
}

}  // namespace
}  // namespace horopter::scenarios
