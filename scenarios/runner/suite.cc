// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/suite.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <memory>
#include <utility>

#include "scenarios/results/suite.h"
#include "scenarios/results/timing_notice.h"
#include "scenarios/runner/earlier_results.h"
#include "scenarios/runner/expected_time.h"
#include "scenarios/runner/progress.h"
#include "scenarios/runner/results_folder.h"
#include "scenarios/runner/run_process.h"
#include "scenarios/runner/suite_jobs.h"
#include "scenarios/runner/table.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using WallClock = RunProcess::WallClock;

std::vector<RunSummary> Summaries(const std::vector<SuiteJob>& jobs) {
  std::vector<RunSummary> summaries;
  for (const SuiteJob& job : jobs) {
    summaries.push_back(job.finished ? job.finished->summary : IdentityOf(job.scenario));
    summaries.back().directory = job.folder.filename().string();
  }
  return summaries;
}

/// Plays the jobs that are not finished, up to `at_once` beside each other.
class Pool {
 public:
  Pool(std::vector<SuiteJob>& jobs, int at_once, std::optional<WallClock::time_point> deadline,
       const fs::path& out, Progress& progress)
      : jobs_(jobs), at_once_(at_once), deadline_(deadline), out_(out), progress_(progress) {
    for (const SuiteJob& job : jobs_) {
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
    SuiteJob* job;
    std::unique_ptr<RunProcess> process;
  };

  bool Over() const { return StopRequested() || (deadline_ && WallClock::now() > *deadline_); }

  void StartDue() {
    while (static_cast<int>(running_.size()) < at_once_ && next_ < jobs_.size() && !Over()) {
      SuiteJob& job = jobs_[next_++];
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

  bool IsUnderWay(const SuiteJob& job) const {
    return std::any_of(running_.begin(), running_.end(),
                       [&job](const Running& r) { return r.job == &job; });
  }

  void Show() const {
    Progress::State state;
    for (const SuiteJob& job : jobs_) {
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

  std::vector<SuiteJob>& jobs_;
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
  std::vector<SuiteJob> jobs = MakeJobs(options);
  if (jobs.empty()) {
    err << "horopter: no scenario matches; `horopter list` shows them with their tags\n";
    return ExitCode::kBadInput;
  }
  const ResultsFolder results =
      options.out.empty() ? ResultsFolder::New("results", LocalTime()) : ResultsFolder(options.out);
  const fs::path& folder = results.path();
  for (SuiteJob& job : jobs) job.folder = folder / job.folder;
  TakeOver(folder, options.earlier, jobs, err);
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
  for (const SuiteJob& job : jobs) {
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
