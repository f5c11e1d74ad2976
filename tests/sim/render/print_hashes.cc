// SPDX-License-Identifier: Apache-2.0
// Prints the driver's name and the hash of each fixed view, one a line, for tests that compare
// processes:
//   print_hashes BACKEND [reverse] [busy] [scene=NAME] [dump=FILE]
// scene= takes a pair of 320 x 240 of a shipped scene (koala, nao, yorick) in place of the fixed
// views. dump= writes the pictures too: for each view width and height, colours, depths and ids,
// raw. Exits 3 when this machine lacks the backend, with the reason on stderr.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench_scene.h"
#include "fixed_views.h"

namespace horopter::sim {
namespace {

constexpr Products kEverything{.rgb = true, .depth = true, .ids = true};

template <typename Pixel>
void Write(const cv::Mat_<Pixel>& image, std::ofstream& file) {
  file.write(reinterpret_cast<const char*>(image.data),
             static_cast<std::streamsize>(image.total() * image.elemSize()));
}

void Dump(const RenderedView& view, std::ofstream& file) {
  const int size[2] = {view.bgr.cols, view.bgr.rows};
  file.write(reinterpret_cast<const char*>(size), sizeof size);
  Write(view.bgr, file);
  Write(view.depth, file);
  Write(view.ids, file);
}

void Print(World& world, const std::vector<PosedCamera>& views, const std::string& backend,
           bool reversed, const std::string& dump) {
  Renderer renderer(world, {.gl_backend = backend, .width = 320, .height = 240});
  std::vector<std::uint64_t> hashes(views.size());
  std::ofstream file;
  if (!dump.empty()) file.open(dump, std::ios::binary);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t k = reversed ? views.size() - 1 - i : i;
    const RenderedView seen = renderer.Render(views[k].X_WC, views[k].camera, kEverything);
    hashes[k] = testing::Hash(seen);
    if (file.is_open()) Dump(seen, file);
  }
  if (!dump.empty() && !file.flush()) throw std::runtime_error("cannot write " + dump);
  std::printf("%s\n", renderer.gl_renderer().c_str());
  for (const std::uint64_t hash : hashes) std::printf("%016lx\n", hash);
}

void PrintShowroom(const std::string& backend, bool reversed, const std::string& dump) {
  const auto world = World::FromXml(testing::kShowroomXml);
  Print(*world, testing::FixedViews(), backend, reversed, dump);
}

void PrintScene(const std::string& name, const std::string& backend, bool reversed,
                const std::string& dump) {
  for (const testing::BenchSceneName& scene : testing::BenchScenes()) {
    if (scene.name != name) continue;
    testing::BenchScene shipped(scene);
    const auto pair = shipped.Pair(320, 240);
    return Print(shipped.world(), {pair.begin(), pair.end()}, backend, reversed, dump);
  }
  throw std::runtime_error("no scene " + name);
}

/// What follows `key` in the argument that begins with it; empty when there is none.
std::string Value(const std::vector<std::string>& args, const std::string& key) {
  for (const std::string& arg : args) {
    if (arg.rfind(key, 0) == 0) return arg.substr(key.size());
  }
  return "";
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
  const std::string dump = horopter::sim::Value(args, "dump=");
  const std::string scene = horopter::sim::Value(args, "scene=");
  int status = 0;
  try {
    if (scene.empty()) {
      horopter::sim::PrintShowroom(backend, asked("reverse"), dump);
    } else {
      horopter::sim::PrintScene(scene, backend, asked("reverse"), dump);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  stop = true;
  for (std::thread& thread : busy) thread.join();
  return status;
}
