// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace horopter::scenarios {

struct Ran {
  int code = -1;
  std::string output;  ///< both streams
};

/// Runs the built program as a shell would. @param arguments shell words
inline Ran Horopter(const std::string& arguments, const std::string& streams = "2>&1") {
  const std::string command = std::string("'") + HOROPTER_PROGRAM "' " + arguments + " " + streams;
  Ran ran;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ran;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    ran.output.append(buffer, n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ran.code = WEXITSTATUS(status);
  return ran;
}

}  // namespace horopter::scenarios
