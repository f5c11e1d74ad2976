// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/suite_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "scenarios/format/find_scenarios.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

bool HasTag(const Scenario& scenario, const std::string& tag) {
  return std::count(scenario.tags.begin(), scenario.tags.end(), tag) > 0;
}

/// Experiments are played when they are asked for, by file or by tag: they may take long, or show
/// what fails.
bool IsAskedFor(const Scenario& scenario, const SuiteOptions& options) {
  if (!options.tags.empty()) {
    return std::any_of(options.tags.begin(), options.tags.end(),
                       [&scenario](const auto& tag) { return HasTag(scenario, tag); });
  }
  const auto names_it = [&scenario](const fs::path& input) {
    std::error_code gone;
    return fs::equivalent(input, scenario.file, gone);
  };
  return !HasTag(scenario, kOnRequestTag) ||
         std::any_of(options.inputs.begin(), options.inputs.end(), names_it);
}

/// "koala-first_waypoint" of .../scenarios/koala/first_waypoint.yaml
std::string FolderStem(const Scenario& scenario) {
  const fs::path file = fs::absolute(scenario.file);
  return file.parent_path().filename().string() + "-" + file.stem().string();
}

}  // namespace

std::vector<SuiteJob> MakeJobs(const SuiteOptions& options) {
  std::vector<Diagnostic> diagnostics;
  std::vector<SuiteJob> jobs;
  std::map<std::string, fs::path> files;  // by the stem of their results folders
  for (const fs::path& file : FindScenarios(options.inputs)) {
    try {
      Scenario scenario = ParseScenario(file, {ScenesDir()});
      if (!IsAskedFor(scenario, options)) continue;
      const std::string stem = FolderStem(scenario);
      const auto [other, fresh] = files.emplace(stem, file);
      if (!fresh) {
        Diagnostic& clash = diagnostics.emplace_back();
        clash.mark.file = file.string();
        clash.message = fmt::format(
            "its results would go where those of {} go, {}-seed*: rename one of the files",
            other->second.string(), stem);
        continue;
      }
      if (options.backend) scenario.backend = *options.backend;
      if (options.gl) scenario.gl = *options.gl;
      std::vector<std::uint64_t> seeds = options.seeds;
      if (seeds.empty()) seeds.push_back(scenario.seed);
      for (const std::uint64_t seed : seeds) {
        scenario.seed = seed;
        jobs.push_back({scenario, fmt::format("{}-seed{}", stem, seed), {}});
      }
    } catch (const ScenarioError& error) {
      diagnostics.insert(diagnostics.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  ThrowIfAny(std::move(diagnostics));
  return jobs;
}

}  // namespace horopter::scenarios
