// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/run_scenario.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "scenarios/format/fault_fields.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/statistics.h"
#include "scenarios/runner/machine.h"
#include "scenarios/runner/stack_config.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

Outcome OutcomeOf(const std::vector<ExpectationResult>& expectations) {
  const bool failed = std::any_of(expectations.begin(), expectations.end(), [](const auto& e) {
    return e.outcome == ExpectationOutcome::kFailed;
  });
  return failed ? Outcome::kFailed : Outcome::kPassed;
}

ExitCode CodeOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPassed:
      return ExitCode::kPassed;
    case Outcome::kFailed:
      return ExitCode::kExpectationFailed;
    case Outcome::kError:
    case Outcome::kIncomplete:
      break;
  }
  return ExitCode::kInfrastructure;
}

/// Plays the scenario and fills in what came of it.
void Play(const Scenario& scenario, const RunHooks& hooks, RunWriter& writer, RunSummary& summary,
          PlanRecord& plan) {
  const RobotDescription robot = LoadRobotDescription(RobotFile(ScenesDir(), scenario.robot));
  writer.AddRecord(kStackRecordFile, StackRecord(scenario, robot));
  hardware::StageTimes times;
  const auto backend = CreateBackend(scenario, robot, times);
  summary.gl_renderer = backend->gl_renderer();
  for (const auto& [name, text] : backend->records()) writer.AddRecord(name, text);

  Session session(scenario, robot, *backend, writer, times, hooks);
  const auto book_results = [&] {
    plan = session.plan();
    summary.sim_s = hardware::ToSeconds(backend->clock().Now());
    summary.image_hash = session.image_hash();
    summary.decision_hash = session.decision_hash();
    summary.timing_ms = Summarise(times);
    if (const auto cycle = summary.timing_ms.find(kCycleStage); cycle != summary.timing_ms.end()) {
      cycle->second.modelled_ms = 1000 * scenario.vision.latency_s;
    }
    summary.metrics = session.book().Metrics();
  };
  Session::Ending ending;
  try {
    ending = session.Run();
  } catch (...) {
    book_results();
    throw;
  }
  book_results();
  for (const Expectation& expectation : scenario.expect) {
    summary.expectations.push_back(
        Evaluate(expectation, session.book(), summary.metrics, backend->truth() != nullptr));
  }
  summary.outcome = OutcomeOf(summary.expectations);
  summary.error = ending.failure;
  if (ending.interrupted) {
    summary.outcome = Outcome::kIncomplete;
    summary.error = "interrupted";
  } else if (!ending.failure.empty()) {
    summary.outcome = Outcome::kFailed;
  }
}

}  // namespace

RunSummary IdentityOf(const Scenario& scenario) {
  RunSummary summary;
  summary.scenario = scenario.name;
  summary.description = scenario.description;
  summary.file = scenario.file.string();
  summary.seed = scenario.seed;
  summary.backend = scenario.backend;
  for (const FaultSpec& fault : scenario.faults) summary.faults.push_back(DescribeFault(fault));
  summary.versions = LibraryVersions();
  return summary;
}

FinishedRun RunScenario(const Scenario& scenario, const std::filesystem::path& folder,
                        const RunHooks& hooks) {
  const auto start = std::chrono::steady_clock::now();
  FinishedRun run{IdentityOf(scenario)};
  run.summary.directory = folder.filename().string();
  run.summary.machine = ThisMachine();
  RunWriter writer(folder, ResolvedYaml(scenario), run.summary);
  PlanRecord plan;
  try {
    Play(scenario, hooks, writer, run.summary, plan);
    run.exit_code = CodeOf(run.summary.outcome);
  } catch (const ResultsError&) {
    throw;
  } catch (const std::exception& error) {
    run.summary.outcome = Outcome::kError;
    run.summary.error = error.what();
    run.exit_code = ExitCodeOf(error);
  }
  run.summary.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writer.Finish(run.summary, plan);
  return run;
}

}  // namespace horopter::scenarios
