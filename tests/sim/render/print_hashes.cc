// SPDX-License-Identifier: Apache-2.0
// Prints the driver's name and the hash of each fixed view, one a line, for tests that compare
// processes:
//   print_hashes BACKEND [reverse] [busy]
// Exits 3 when this machine lacks the backend, with the reason on stderr.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "fixed_views.h"

namespace horopter::sim {
namespace {

constexpr Products kEverything{.rgb = true, .depth = true, .ids = true};

void Print(const std::string& backend, bool reversed) {
  const auto world = World::FromXml(testing::kShowroomXml);
  const std::vector<PosedCamera> views = testing::FixedViews();
  Renderer renderer(*world, {.gl_backend = backend, .width = 320, .height = 240});
  std::vector<std::uint64_t> hashes(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t k = reversed ? views.size() - 1 - i : i;
    hashes[k] = testing::Hash(renderer.Render(views[k].X_WC, views[k].camera, kEverything));
  }
  std::printf("%s\n", renderer.gl_renderer().c_str());
  for (const std::uint64_t hash : hashes) std::printf("%016lx\n", hash);
}

}  // namespace
}  // namespace horopter::sim

int main(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  const auto asked = [&args](const char* word) {
    return std::find(args.begin(), args.end(), word) != args.end();
  };
  const std::string backend = args.empty() ? "osmesa" : args[0];
  if (!horopter::sim::ProbeGlBackend(backend).problem.empty()) {
    std::fprintf(stderr, "%s\n", horopter::sim::ProbeGlBackend(backend).problem.c_str());
    return 3;
  }
  std::atomic<bool> stop = false;
  std::vector<std::thread> busy;
  for (unsigned i = 0; asked("busy") && i < std::thread::hardware_concurrency(); ++i) {
    busy.emplace_back([&stop] {
      while (!stop) {
      }
    });
  }
  int status = 0;
  try {
    horopter::sim::Print(backend, asked("reverse"));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  stop = true;
  for (std::thread& thread : busy) thread.join();
  return status;
}
