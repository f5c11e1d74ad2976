// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/timing_notice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/results/run_report.h"
#include "scenarios/results/summary_json.h"
#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

RunSummary Timed(std::uint64_t seed, double p95_ms, std::optional<double> modelled_ms) {
  RunSummary run = ExampleSummary();
  run.seed = seed;
  run.timing_ms = {{"vision, a cycle", {p95_ms / 2, p95_ms, 10, modelled_ms}}};
  return run;
}

TEST(TimingNotices, TellOfStagesThatAreSlowerThanModelled) {
  EXPECT_THAT(TimingNotices({Timed(1, 399, 400), Timed(2, 900, std::nullopt)}), IsEmpty());
  const auto notices = TimingNotices({Timed(1, 450, 400), Timed(2, 700, 400), Timed(3, 390, 400)});
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_THAT(notices[0], HasSubstr("seed 2 (the slowest of 2 such runs)"));
  EXPECT_THAT(notices[0], HasSubstr("700 ms"));
  EXPECT_THAT(notices[0], HasSubstr("400 ms"));
}

TEST(TimingNotices, AreInTheReportAndReadBackFromTheSummary) {
  const RunSummary slow = Timed(1, 450, 400), fast = Timed(1, 300, 400);
  EXPECT_THAT(RunReportHtml({slow, {}, {}, {}, ""}), HasSubstr("450 ms at its 95th percentile"));
  EXPECT_THAT(RunReportHtml({fast, {}, {}, {}, ""}), Not(HasSubstr("at its 95th percentile")));
  EXPECT_EQ(TimingNotices(ParseSummaryText(RunSummaryText(slow))), TimingNotices({slow}));
}

TEST(TimingNotices, ChangeNothingThatIsCompared) {
  RunSummary slow = Timed(1, 450, 400), fast = Timed(1, 300, 400);
  EXPECT_EQ(slow.outcome, fast.outcome);
  slow.timing_ms.clear();
  fast.timing_ms.clear();
  EXPECT_EQ(RunSummaryText(slow), RunSummaryText(fast));
}

}  // namespace
}  // namespace horopter::scenarios
