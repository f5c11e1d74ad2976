// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/machine.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace horopter::scenarios {
namespace {

std::string Processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

}  // namespace

Machine ThisMachine() {
  Machine machine{Processor(), std::thread::hardware_concurrency(), {}};
  if (double load = 0; getloadavg(&load, 1) == 1) machine.load = load;
  return machine;
}

}  // namespace horopter::scenarios
