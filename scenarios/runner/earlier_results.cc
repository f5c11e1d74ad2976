// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/earlier_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "scenarios/format/diagnostics.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/files.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/suite.h"
#include "scenarios/runner/stack_config.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

/// The runs that the folder's summary names; none when it cannot be read.
std::vector<RunSummary> RunsIn(const fs::path& folder) {
  try {
    return ReadSuiteSummary(folder);
  } catch (const ResultsError&) {
    return {};
  }
}

/// The run's own folder below the suite's, nothing when its summary names none that a suite makes.
std::optional<fs::path> RunFolder(const fs::path& suite, const RunSummary& run) {
  const fs::path name = run.directory;
  const bool plain = name == name.filename() && name != "." && name != "..";
  if (!plain || !fs::exists(suite / name / "scenario.yaml")) return std::nullopt;
  return suite / name;
}

void RemoveRuns(const fs::path& folder) {
  for (const RunSummary& run : RunsIn(folder)) {
    if (const auto old = RunFolder(folder, run)) {
      std::error_code reason;
      fs::remove_all(*old, reason);
      if (reason) throw ResultsError(WriteFailure(*old, reason.value()));
    }
  }
}

void RequireThatAllAreAskedFor(const fs::path& folder, const std::vector<SuiteJob>& jobs) {
  for (const RunSummary& run : RunsIn(folder)) {
    const auto old = RunFolder(folder, run);
    const bool asked = !old || std::any_of(jobs.begin(), jobs.end(), [&old](const SuiteJob& job) {
      return job.folder == *old;
    });
    if (asked) continue;
    throw UnusableResults(fmt::format(
        "--resume: {} has a run that is not asked for now, {} seed {}: ask for it too, name "
        "another folder with --out, or replace all with --overwrite",
        folder.string(), run.scenario, run.seed));
  }
}

std::string TextOf(const fs::path& file) {
  try {
    return ReadFile(file);
  } catch (const ResultsError&) {
    return "";
  }
}

/// What the job's run would write, nothing when its robot cannot be read: the run will say why.
std::optional<std::string> StackRecordOf(const SuiteJob& job) {
  try {
    return StackRecord(job.scenario,
                       LoadRobotDescription(RobotFile(ScenesDir(), job.scenario.robot)));
  } catch (const ScenarioError&) {
    return std::nullopt;
  }
}

/// The run that is already there, when it ended and was of the same resolved scenario and stack.
std::optional<FinishedRun> EndedRun(const SuiteJob& job) {
  if (TextOf(job.folder / "scenario.yaml") != ResolvedYaml(job.scenario)) return std::nullopt;
  if (TextOf(job.folder / kStackRecordFile) != StackRecordOf(job)) return std::nullopt;
  const std::vector<RunSummary> runs = RunsIn(job.folder);
  if (runs.size() != 1) return std::nullopt;
  FinishedRun run{runs.front()};
  run.summary.directory = job.folder.filename().string();
  if (run.summary.outcome == Outcome::kPassed) return run;
  run.exit_code = ExitCode::kExpectationFailed;
  if (run.summary.outcome == Outcome::kFailed) return run;
  return std::nullopt;  // never finished: play it again
}

void KeepEndedRuns(std::vector<SuiteJob>& jobs, std::ostream& err) {
  int of_other_builds = 0;
  std::string other;
  for (SuiteJob& job : jobs) {
    std::optional<FinishedRun> run = EndedRun(job);
    if (!run) continue;
    if (run->summary.versions != LibraryVersions()) {
      ++of_other_builds;
      other = DescribeBuild(run->summary.versions);
      continue;
    }
    job.finished = std::move(run);
    job.kept = true;
  }
  if (of_other_builds == 0) return;
  err << fmt::format(
      "horopter: {} ended {} played again, since another build made {}: {}, this is {}\n",
      of_other_builds, of_other_builds == 1 ? "run is" : "runs are",
      of_other_builds == 1 ? "it" : "them", other, DescribeBuild(LibraryVersions()));
}

}  // namespace

void TakeOver(const fs::path& folder, EarlierResults what, std::vector<SuiteJob>& jobs,
              std::ostream& err) {
  if (!fs::exists(folder / "summary.json")) return;
  switch (what) {
    case EarlierResults::kRefuse:
      throw UnusableResults(fmt::format(
          "--out {}: has earlier results; go on with them with --resume, replace them with "
          "--overwrite, or name another folder",
          folder.string()));
    case EarlierResults::kResume:
      RequireThatAllAreAskedFor(folder, jobs);
      KeepEndedRuns(jobs, err);
      return;
    case EarlierResults::kReplace:
      RemoveRuns(folder);
      return;
  }
}

}  // namespace horopter::scenarios
