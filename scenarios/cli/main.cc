// SPDX-License-Identifier: Apache-2.0
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "scenarios/cli/command_line.h"

int main(int argc, char** argv) {
  // Standard output is for results: tables and JSON that other programs read.
  spdlog::set_default_logger(spdlog::stderr_color_mt("horopter"));
  return horopter::scenarios::RunCommandLine(argc, argv);
}
