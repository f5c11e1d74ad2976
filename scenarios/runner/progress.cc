// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/progress.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace horopter::scenarios {
namespace {

constexpr std::chrono::milliseconds kTerminalPeriod(200);
constexpr std::chrono::seconds kLogPeriod(15);

}  // namespace

Progress::Progress(std::ostream& out, bool terminal)
    : out_(out), terminal_(terminal), next_(start_ + (terminal ? kTerminalPeriod : kLogPeriod)) {}

std::string Progress::TimeLeft(const State& state) const {
  if (state.done_sim_s < 1) return "";
  const double elapsed_s = std::chrono::duration<double>(WallClock::now() - start_).count();
  const double left_s = elapsed_s * (state.total_sim_s - state.done_sim_s) / state.done_sim_s;
  const int minutes = static_cast<int>(left_s / 60);
  const int seconds = static_cast<int>(std::ceil(left_s - 60 * minutes));
  return minutes > 0 ? fmt::format("at most {} min {} s left", minutes, seconds)
                     : fmt::format("at most {} s left", seconds);
}

void Progress::Show(const State& state) {
  const auto now = WallClock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? std::chrono::milliseconds(kTerminalPeriod)
                           : std::chrono::milliseconds(kLogPeriod));
  const std::string line =
      fmt::format("[{}/{}] {}{}{}", state.done_runs, state.runs, fmt::join(state.doing, "; "),
                  state.done_sim_s < 1 ? "" : ", ", TimeLeft(state));
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
