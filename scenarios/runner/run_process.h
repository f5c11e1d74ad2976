// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/format/scenario.h"
#include "scenarios/results/run_record.h"
#include "scenarios/runner/exit_code.h"
#include "scenarios/runner/run_scenario.h"

namespace horopter::scenarios {

/// One run in a process of its own: a crash costs that run alone, runs beside each other share
/// nothing, and a run in a suite is bit for bit the run alone.
///
/// Start it before the calling process has threads. The child stops at SIGINT or SIGTERM, when its
/// parent is gone, and at the wall-clock deadline, and then leaves an incomplete run behind.
class RunProcess {
 public:
  using WallClock = std::chrono::steady_clock;

  /// @throws std::system_error when no process can be made
  RunProcess(const Scenario& scenario, const std::filesystem::path& folder,
             std::optional<WallClock::time_point> deadline);
  RunProcess(const RunProcess&) = delete;
  RunProcess& operator=(const RunProcess&) = delete;
  /// Kills the child if it still runs.
  ~RunProcess();

  /// Readable when there is progress or the child has ended.
  int fd() const { return fd_; }
  pid_t pid() const { return pid_; }

  /// Takes in what the child has said. @return false once it has ended
  bool Poll();

  /// Asks the child to stop (SIGTERM).
  void Stop();

  double sim_s() const { return sim_s_; }
  const std::string& doing() const { return doing_; }

  /// What came of it. A child that was ended by a signal gives an incomplete run, one that died
  /// before its folder had a summary an error; both say how, and both are kInfrastructure.
  /// @pre Poll() has returned false
  FinishedRun Finish() const;

 private:
  void Take(const std::string& line);

  RunSummary identity_;
  std::filesystem::path folder_;
  pid_t pid_ = -1;
  int fd_ = -1;
  int status_ = 0;
  std::string unread_;
  std::string failure_;
  std::string doing_ = "starting";
  double sim_s_ = 0;
};

/// From now on this process gets SIGTERM when its parent is gone. Ends it at once when `parent` is
/// gone already: a parent that dies between fork() and this call would leave an orphan otherwise.
/// @param parent the process that forked this one
void StopWithParent(pid_t parent);

/// Set by SIGINT and SIGTERM once InstallStopHandler() was called.
bool StopRequested();
void InstallStopHandler();

}  // namespace horopter::scenarios
