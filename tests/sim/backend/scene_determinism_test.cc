// SPDX-License-Identifier: Apache-2.0
// Pictures, sensor images and truth of the three shipped scenes: the same bits in every process, on
// any number of threads, in any order and under load. Hashes are compared between runs, since kinds
// of processor may differ.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace horopter::sim {
namespace {

/// What print_scene_hashes says, started with these environment variables.
std::string Hashes(const std::string& arguments, const std::string& environment = "") {
  const std::string command = environment + " " HOROPTER_PRINT_SCENE_HASHES " " + arguments;
  std::string hashes;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return hashes;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) hashes += line.data();
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 0) << command;
  return hashes;
}

/// A process that keeps a core busy for as long as this lives.
class BusyProcess {
 public:
  BusyProcess() : pid_(fork()) {
    if (pid_ != 0) return;
    for (volatile unsigned turns = 0;;) turns = turns + 1;
  }
  ~BusyProcess() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  BusyProcess(const BusyProcess&) = delete;
  BusyProcess& operator=(const BusyProcess&) = delete;

 private:
  pid_t pid_;
};

TEST(SceneDeterminism, ProcessesThreadsOrderAndLoadChangeNoBit) {
  const std::string usual = Hashes("");
  // 3 scenes, 2 gazes: 6 renderings, 1 sensor image, 3 maps of truth, 3 of disparity, 3 of flow.
  EXPECT_EQ(std::count(usual.begin(), usual.end(), '\n'), 3 * 2 * 16);
  EXPECT_EQ(Hashes("threads=1", "LP_NUM_THREADS=0"), usual) << "one thread";
  EXPECT_EQ(Hashes("reverse threads=5", "LP_NUM_THREADS=3"), usual) << "many, the last first";
  const BusyProcess first, second, third;
  EXPECT_EQ(Hashes(""), usual) << "under load";
}

}  // namespace
}  // namespace horopter::sim
