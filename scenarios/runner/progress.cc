// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/progress.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace horopter::scenarios {
namespace {

constexpr std::chrono::milliseconds kTerminalPeriod(200);
constexpr std::chrono::seconds kLogPeriod(15);

/// Of a run that is over its expected time, by how much it will exceed what it has taken so far.
constexpr double kOverdue = 1.1;

}  // namespace

std::string TimeLeft(double elapsed_s, double done_sim_s, double total_sim_s) {
  if (done_sim_s < 1) return "";
  const double left_s = elapsed_s * (total_sim_s - done_sim_s) / done_sim_s;
  const long whole_s = std::lround(std::ceil(left_s));
  return whole_s < 60 ? fmt::format("about {} s left", whole_s)
                      : fmt::format("about {} min {} s left", whole_s / 60, whole_s % 60);
}

Progress::Progress(std::ostream& out, bool terminal)
    : out_(out), terminal_(terminal), next_(start_ + (terminal ? kTerminalPeriod : kLogPeriod)) {}

void Progress::State::AddKept() {
  ++runs;
  ++done_runs;
}

void Progress::State::AddEnded(const RunSummary& run) {
  AddKept();
  done_sim_s += run.sim_s.value_or(0);
  total_sim_s += run.sim_s.value_or(0);
}

void Progress::State::AddWaiting(double expected_s) {
  ++runs;
  total_sim_s += expected_s;
}

void Progress::State::AddUnderWay(double sim_s, double expected_s, std::string what) {
  AddWaiting(std::max(expected_s, kOverdue * sim_s));
  done_sim_s += sim_s;
  doing.push_back(std::move(what));
}

void Progress::Show(const State& state) {
  const auto now = WallClock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? std::chrono::milliseconds(kTerminalPeriod)
                           : std::chrono::milliseconds(kLogPeriod));
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const std::string left = TimeLeft(elapsed_s, state.done_sim_s, state.total_sim_s);
  const std::string line =
      fmt::format("[{}/{}] {}{}{}", state.done_runs, state.runs, fmt::join(state.doing, "; "),
                  left.empty() ? "" : ", ", left);
  if (terminal_) {
    constexpr std::size_t kColumns = 118;
    out_ << "\r\033[K" << line.substr(0, kColumns) << std::flush;
  } else {
    out_ << line << std::endl;
  }
}

void Progress::Ended(const RunSummary& run) {
  Clear();
  out_ << fmt::format("{} seed {}: {}", run.scenario, run.seed, ToString(run.outcome));
  if (run.wall_s) out_ << fmt::format(" in {:.1f} s", *run.wall_s);
  if (!run.error.empty()) out_ << ": " << run.error;
  out_ << std::endl;
}

void Progress::Clear() {
  if (terminal_) out_ << "\r\033[K" << std::flush;
}

}  // namespace horopter::scenarios
