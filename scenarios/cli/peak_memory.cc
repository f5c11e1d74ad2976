// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/peak_memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace horopter::scenarios {

std::optional<double> PeakMemoryMb() {
  // getrusage() would count what the program that started this one held.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024 / 1e6;
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

}  // namespace horopter::scenarios
