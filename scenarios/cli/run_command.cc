// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/format/backends.h"
#include "scenarios/format/seeds.h"
#include "scenarios/format/suggest.h"
#include "scenarios/runner/suite.h"

namespace horopter::scenarios {
namespace {

constexpr int kMostJobs = 256;

/// As written on the command line.
struct RunArguments {
  std::vector<std::string> inputs;
  std::string backend;
  std::string gl;
  std::string seed;
  std::string seeds;
  std::vector<std::string> tags;
  std::string out;
  int jobs = 1;
  bool resume = false;
  bool overwrite = false;
  double time_limit_s = 0;
};

SuiteOptions ToOptions(const RunArguments& a) {
  SuiteOptions options;
  options.inputs.assign(a.inputs.begin(), a.inputs.end());
  if (options.inputs.empty()) options.inputs.emplace_back(HOROPTER_SCENARIOS_DIR);
  if (!a.backend.empty()) options.backend = a.backend;
  if (!a.gl.empty()) options.gl = a.gl;
  if (!a.seed.empty()) {
    options.seeds = ParseSeeds(a.seed);
    if (options.seeds.size() != 1) {
      throw std::invalid_argument("--seed takes a single seed: write --seeds " + a.seed);
    }
  }
  if (!a.seeds.empty()) options.seeds = ParseSeeds(a.seeds);
  options.tags = a.tags;
  options.out = a.out;
  options.jobs = a.jobs;
  if (a.resume) options.earlier = EarlierResults::kResume;
  if (a.overwrite) options.earlier = EarlierResults::kReplace;
  if (a.time_limit_s > 0) options.wall_limit_s = a.time_limit_s;
  return options;
}

/// @return false when the backend is known but this build cannot use it, having said why
/// @throws std::invalid_argument when it is unknown
bool BackendIsThere(const std::string& name) {
  if (name.empty()) return true;
  const BackendInfo* backend = FindBackend(name);
  if (backend == nullptr) {
    std::string list;
    for (const std::string& known : BackendNames()) list += (list.empty() ? "" : ", ") + known;
    const auto nearest = NearestName(name, BackendNames());
    throw std::invalid_argument("unknown backend '" + name + "': one of " + list +
                                (nearest ? "; did you mean '" + *nearest + "'?" : ""));
  }
  if (backend->missing.empty()) return true;
  std::cerr << "horopter run: backend '" << name << "' is not available: " << backend->missing
            << "\n";
  return false;
}

}  // namespace

Command AddRunCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("run", "Play scenarios and judge them");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<RunArguments>();
  app->add_option("INPUT", a->inputs, "Scenario files, and folders of them [the shipped ones]");
  app->add_option("--backend", a->backend, "sim, emulated, hardware or replay, for all scenarios");
  app->add_option("--gl", a->gl, "osmesa or egl: what simulated images are rendered with")
      ->check(CLI::IsMember({"osmesa", "egl"}));
  auto* seed = app->add_option("--seed", a->seed, "Seed instead of each scenario's own");
  app->add_option("--seeds", a->seeds, "Several: 1-20 or 1,3,5-7")->excludes(seed);
  app->add_option(
         "--tag", a->tags,
         "Only scenarios with this tag; may stand several times. Those tagged \"experiment\" are "
         "played from a folder only so")
      ->allow_extra_args(false);  // or it would swallow the inputs behind it
  app->add_option("--out", a->out, "Results folder [results/run-<date>-<time>]");
  app->add_option("--jobs", a->jobs, "Runs beside each other [1]")->check(CLI::Range(1, kMostJobs));
  auto* resume = app->add_flag("--resume", a->resume,
                               "Go on in --out, keeping the runs that ended with the same scenario "
                               "and the same build");
  app->add_flag("--overwrite", a->overwrite, "Replace the results that --out already has")
      ->excludes(resume);
  app->add_option("--time-limit", a->time_limit_s, "Wall-clock seconds for everything")
      ->check(CLI::PositiveNumber);
  app->footer(
      "\nExamples:\n"
      "  horopter run scenarios/koala/first_waypoint.yaml --seed 3\n"
      "  horopter run scenarios/ --tag navigation --seeds 1-20 --jobs 2 --out results/nightly\n"
      "  horopter run scenarios/ --seeds 1-20 --out results/nightly --resume");
  return {
      app, [a] {
        if (!BackendIsThere(a->backend)) {
          return static_cast<int>(ExitCode::kHardwareUnavailable);
        }
        if (a->out.empty() && (a->resume || a->overwrite)) {
          throw std::invalid_argument(std::string(a->resume ? "--resume" : "--overwrite") +
                                      " needs the folder of the earlier results: add --out DIR");
        }
        return static_cast<int>(RunSuite(ToOptions(*a), std::cout, std::cerr));
      }};
}

}  // namespace horopter::scenarios
