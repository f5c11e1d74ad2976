// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace horopter::hardware {

/// Wall-clock milliseconds of each stage, one entry per pass. For reports only: nothing decides by
/// it.
class StageTimes {
 public:
  /// Runs `work` and books its time under `stage`; returns what it returns.
  template <typename Work>
  decltype(auto) Measure(const std::string& stage, Work&& work) {
    const Booking booking(*this, stage);
    return std::forward<Work>(work)();
  }

  void Add(const std::string& stage, double ms) { samples_[stage].push_back(ms); }
  const std::map<std::string, std::vector<double>>& samples() const { return samples_; }

 private:
  class Booking {
   public:
    Booking(StageTimes& times, const std::string& stage) : times_(times), stage_(stage) {}
    ~Booking() {
      times_.Add(stage_, std::chrono::duration<double, std::milli>(
                             std::chrono::steady_clock::now() - start_)
                             .count());
    }
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;

   private:
    StageTimes& times_;
    const std::string& stage_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };

  std::map<std::string, std::vector<double>> samples_;
};

/// The same where somebody asked for times.
template <typename Work>
decltype(auto) MeasureIf(StageTimes* times, const std::string& stage, Work&& work) {
  if (times == nullptr) return std::forward<Work>(work)();
  return times->Measure(stage, std::forward<Work>(work));
}

}  // namespace horopter::hardware
