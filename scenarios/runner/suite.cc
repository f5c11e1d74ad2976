// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/suite.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <list>
#include <map>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include "scenarios/format/find_scenarios.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/suite.h"
#include "scenarios/results/timing_notice.h"
#include "scenarios/runner/expected_time.h"
#include "scenarios/runner/progress.h"
#include "scenarios/runner/results_folder.h"
#include "scenarios/runner/run_process.h"
#include "scenarios/runner/table.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using WallClock = RunProcess::WallClock;

/// One (scenario, seed) of the suite.
struct Job {
  Scenario scenario;
  fs::path folder;  ///< below the suite's
  std::optional<FinishedRun> finished;
  bool kept = false;  ///< finished by an earlier suite
};

bool HasTag(const Scenario& scenario, const std::vector<std::string>& tags) {
  return tags.empty() || std::any_of(tags.begin(), tags.end(), [&scenario](const auto& tag) {
           return std::count(scenario.tags.begin(), scenario.tags.end(), tag) > 0;
         });
}

/// "koala-first_waypoint" of .../scenarios/koala/first_waypoint.yaml
std::string FolderStem(const Scenario& scenario) {
  const fs::path file = fs::absolute(scenario.file);
  return file.parent_path().filename().string() + "-" + file.stem().string();
}

std::vector<Job> MakeJobs(const SuiteOptions& options) {
  std::vector<Diagnostic> diagnostics;
  std::vector<Job> jobs;
  std::map<std::string, fs::path> files;  // by the stem of their results folders
  for (const fs::path& file : FindScenarios(options.inputs)) {
    try {
      Scenario scenario = ParseScenario(file, {ScenesDir()});
      if (!HasTag(scenario, options.tags)) continue;
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

std::string ReadText(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The run that is already there, when it ended and was of the same resolved scenario.
std::optional<FinishedRun> EarlierRun(const Job& job) {
  if (ReadText(job.folder / "scenario.yaml") != ResolvedYaml(job.scenario)) return std::nullopt;
  try {
    FinishedRun run{ReadSuiteSummary(job.folder).at(0)};
    run.summary.directory = job.folder.filename().string();
    if (run.summary.outcome == Outcome::kPassed) return run;
    run.exit_code = ExitCode::kExpectationFailed;
    if (run.summary.outcome == Outcome::kFailed) return run;
  } catch (const ResultsError&) {  // never finished: play it again
  }
  return std::nullopt;
}

std::vector<RunSummary> Summaries(const std::vector<Job>& jobs) {
  std::vector<RunSummary> summaries;
  for (const Job& job : jobs) {
    summaries.push_back(job.finished ? job.finished->summary : IdentityOf(job.scenario));
    summaries.back().directory = job.folder.filename().string();
  }
  return summaries;
}

/// Plays the jobs that are not finished, up to `at_once` beside each other.
class Pool {
 public:
  Pool(std::vector<Job>& jobs, int at_once, std::optional<WallClock::time_point> deadline,
       const fs::path& out, Progress& progress)
      : jobs_(jobs), at_once_(at_once), deadline_(deadline), out_(out), progress_(progress) {
    for (const Job& job : jobs_) {
      if (job.finished) times_.Learn(job.finished->summary);
    }
  }

  void Run() {
    while (true) {
      StartDue();
      if (running_.empty()) return;
      WaitAndTake();
      Show();
    }
  }

 private:
  struct Running {
    Job* job;
    std::unique_ptr<RunProcess> process;
  };

  bool Over() const { return StopRequested() || (deadline_ && WallClock::now() > *deadline_); }

  void StartDue() {
    while (static_cast<int>(running_.size()) < at_once_ && next_ < jobs_.size() && !Over()) {
      Job& job = jobs_[next_++];
      if (job.finished) continue;
      running_.push_back({&job, std::make_unique<RunProcess>(job.scenario, job.folder, deadline_)});
    }
  }

  void WaitAndTake() {
    std::vector<pollfd> fds;
    for (const Running& r : running_) fds.push_back({r.process->fd(), POLLIN, 0});
    constexpr int kWaitMs = 500;
    poll(fds.data(), fds.size(), kWaitMs);
    if (StopRequested()) {
      for (const Running& r : running_) r.process->Stop();
    }
    std::size_t i = 0;
    for (auto r = running_.begin(); r != running_.end(); ++i) {
      if (fds[i].revents == 0 || r->process->Poll()) {
        ++r;
        continue;
      }
      r->job->finished = r->process->Finish();
      progress_.Ended(r->job->finished->summary);
      times_.Learn(r->job->finished->summary);
      r = running_.erase(r);
      WriteSuite(out_, Summaries(jobs_));
    }
  }

  bool IsUnderWay(const Job& job) const {
    return std::any_of(running_.begin(), running_.end(),
                       [&job](const Running& r) { return r.job == &job; });
  }

  void Show() const {
    Progress::State state;
    for (const Job& job : jobs_) {
      if (job.kept) {
        state.AddKept();
      } else if (job.finished) {
        state.AddEnded(job.finished->summary);
      } else if (!IsUnderWay(job)) {
        state.AddWaiting(times_.Of(job.scenario));
      }
    }
    for (const Running& r : running_) {
      state.AddUnderWay(r.process->sim_s(), times_.Of(r.job->scenario),
                        fmt::format("{} seed {}: {} at {:.1f} s", r.job->scenario.name,
                                    r.job->scenario.seed, r.process->doing(), r.process->sim_s()));
    }
    progress_.Show(state);
  }

  std::vector<Job>& jobs_;
  int at_once_;
  std::optional<WallClock::time_point> deadline_;
  fs::path out_;
  Progress& progress_;
  ExpectedTimes times_;
  std::list<Running> running_;
  std::size_t next_ = 0;
};

/// "20260131-235959"
std::string LocalTime() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y%m%d-%H%M%S}", fmt::localtime(now));
}

ExitCode Play(const SuiteOptions& options, std::ostream& out, std::ostream& err) {
  std::vector<Job> jobs = MakeJobs(options);
  if (jobs.empty()) {
    err << "horopter: no scenario matches; `horopter list` shows them with their tags\n";
    return ExitCode::kBadInput;
  }
  const ResultsFolder results =
      options.out.empty() ? ResultsFolder::New("results", LocalTime()) : ResultsFolder(options.out);
  const fs::path& folder = results.path();
  for (Job& job : jobs) job.folder = folder / job.folder;
  if (options.resume) {
    for (Job& job : jobs) {
      job.finished = EarlierRun(job);
      job.kept = job.finished.has_value();
    }
  }
  InstallStopHandler();
  std::optional<WallClock::time_point> deadline;
  if (options.wall_limit_s) {
    deadline = WallClock::now() + std::chrono::duration_cast<WallClock::duration>(
                                      std::chrono::duration<double>(*options.wall_limit_s));
  }
  Progress progress(err, isatty(STDERR_FILENO) != 0);
  WriteSuite(folder, Summaries(jobs));
  Pool(jobs, std::max(1, options.jobs), deadline, folder, progress).Run();
  progress.Clear();

  const std::vector<RunSummary> summaries = Summaries(jobs);
  WriteSuite(folder, summaries);
  PrintTable(summaries, out);
  for (const std::string& notice : TimingNotices(summaries)) out << "notice: " << notice << '\n';
  out << "report: " << fs::absolute(folder / "report.html").lexically_normal().string() << '\n';
  ExitCode code = ExitCode::kPassed;
  for (const Job& job : jobs) {
    code = std::max(code, job.finished ? job.finished->exit_code : ExitCode::kInfrastructure);
  }
  return code;
}

}  // namespace

ExitCode RunSuite(const SuiteOptions& options, std::ostream& out, std::ostream& err) {
  try {
    return Play(options, out, err);
  } catch (const ScenarioError& error) {
    err << error.what() << '\n';
    return ExitCode::kBadInput;
  } catch (const std::exception& error) {
    err << "horopter: " << error.what() << '\n';
    return ExitCodeOf(error);
  }
}

}  // namespace horopter::scenarios
