// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/run_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <vector>

#include "scenarios/results/results_error.h"
#include "scenarios/results/suite.h"

namespace horopter::scenarios {
namespace {

using WallClock = RunProcess::WallClock;

volatile std::sig_atomic_t stop_requested = 0;

void OnStopSignal(int) { stop_requested = 1; }

/// Lines shorter than PIPE_BUF are written whole; a parent that no longer reads is no reason to
/// stop here.
void Say(int fd, char kind, const std::string& text) {
  const std::string line = std::string(1, kind) + text + '\n';
  [[maybe_unused]] const ssize_t written = write(fd, line.data(), line.size());
}

/// The child's whole life.
ExitCode Play(const Scenario& scenario, const std::filesystem::path& folder, int fd,
              std::optional<WallClock::time_point> deadline) {
  auto next_report = WallClock::now();
  RunHooks hooks;
  hooks.progress = [&](double sim_s, const std::string& doing) {
    const auto now = WallClock::now();
    if (now < next_report) return;
    next_report = now + std::chrono::milliseconds(200);
    Say(fd, 'P', fmt::format("{} {}", sim_s, doing));
  };
  hooks.interrupted = [&] {
    return stop_requested != 0 || (deadline && WallClock::now() > *deadline);
  };
  try {
    return RunScenario(scenario, folder, hooks).exit_code;
  } catch (const std::exception& error) {
    Say(fd, 'E', error.what());
    return ExitCode::kInfrastructure;
  }
}

std::string HowItDied(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("the run's process exited with {} and left no summary", WEXITSTATUS(status));
}

/// The run's summary as its folder has it; nothing when that cannot be read.
std::optional<RunSummary> SummaryIn(const std::filesystem::path& folder) {
  try {
    const std::vector<RunSummary> runs = ReadSuiteSummary(folder);
    if (runs.size() != 1) return std::nullopt;
    RunSummary summary = runs.front();
    summary.directory = folder.filename().string();
    return summary;
  } catch (const ResultsError&) {
    return std::nullopt;
  }
}

}  // namespace

bool StopRequested() { return stop_requested != 0; }

void InstallStopHandler() {
  struct sigaction action = {};
  action.sa_handler = OnStopSignal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void StopWithParent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(static_cast<int>(ExitCode::kInfrastructure));
}

RunProcess::RunProcess(const Scenario& scenario, const std::filesystem::path& folder,
                       std::optional<WallClock::time_point> deadline)
    : identity_(IdentityOf(scenario)), folder_(folder) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe to a run");
  }
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(reason, std::generic_category(), "cannot start a process for a run");
  }
  if (pid_ == 0) {
    StopWithParent(parent);
    signal(SIGPIPE, SIG_IGN);
    close(ends[0]);
    InstallStopHandler();
    const ExitCode code = Play(scenario, folder, ends[1], deadline);
    _exit(static_cast<int>(code));
  }
  close(ends[1]);
  fd_ = ends[0];
}

RunProcess::~RunProcess() {
  if (fd_ >= 0) {
    close(fd_);
    kill(pid_, SIGKILL);
    waitpid(pid_, &status_, 0);
  }
}

void RunProcess::Take(const std::string& line) {
  if (line.empty()) return;
  if (line[0] == 'E') failure_ = line.substr(1);
  if (line[0] != 'P') return;
  std::size_t used = 0;
  sim_s_ = std::stod(line.substr(1), &used);
  doing_ = line.size() > used + 2 ? line.substr(used + 2) : "";
}

bool RunProcess::Poll() {
  char buffer[4096];
  const ssize_t n = read(fd_, buffer, sizeof buffer);
  if (n < 0 && errno == EINTR) return true;
  if (n > 0) {
    unread_.append(buffer, static_cast<std::size_t>(n));
    for (std::size_t end; (end = unread_.find('\n')) != std::string::npos;) {
      Take(unread_.substr(0, end));
      unread_.erase(0, end + 1);
    }
    return true;
  }
  close(fd_);
  fd_ = -1;
  while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
  }
  return false;
}

void RunProcess::Stop() { kill(pid_, SIGTERM); }

FinishedRun RunProcess::Finish() const {
  FinishedRun run{identity_, ExitCode::kInfrastructure};
  run.summary.directory = folder_.filename().string();
  run.summary.outcome = Outcome::kError;
  if (!failure_.empty()) {
    run.summary.error = failure_;
    return run;
  }
  const std::optional<RunSummary> left = SummaryIn(folder_);
  if (left && WIFEXITED(status_)) {
    run.summary = *left;
    run.exit_code = static_cast<ExitCode>(WEXITSTATUS(status_));
    return run;
  }
  // A run that was killed is as incomplete in the suite as its own folder says.
  if (left && left->outcome == Outcome::kIncomplete) run.summary = *left;
  run.summary.error = HowItDied(status_);
  return run;
}

}  // namespace horopter::scenarios
