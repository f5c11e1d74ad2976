// SPDX-License-Identifier: Apache-2.0
// A VGA stereo pair by our renderer beside MuJoCo's own calls, in one run, and the table of ratios:
//   horopter_benchmark_sim_render --benchmark_repetitions=9
//   --benchmark_enable_random_interleaving=true
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench_scene.h"
#include "peer.h"

namespace horopter::sim {
namespace {

using testing::BenchScene;
using testing::BenchSceneName;
using testing::Peer;

constexpr Products kRgb{.rgb = true};
constexpr Products kRgbDepth{.rgb = true, .depth = true};
constexpr Products kAll{.rgb = true, .depth = true, .ids = true};

/// Wall-clock time of an iteration, and the processor time that all threads spent in it.
class Stopwatch {
 public:
  explicit Stopwatch(benchmark::State& state) : state_(state) {}
  ~Stopwatch() {
    state_.counters["cpu_ms"] =
        benchmark::Counter(1000 * cpu_s_, benchmark::Counter::kAvgIterations);
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  void Time(int pairs, const std::function<void()>& work) {
    const std::clock_t cpu = std::clock();  // of all threads
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    state_.SetIterationTime(wall.count() / pairs);
    cpu_s_ += static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / pairs;
  }

 private:
  benchmark::State& state_;
  double cpu_s_ = 0;
};

/// Painting a scene takes longer than timing it.
BenchScene& SceneOf(const BenchSceneName& name, int copy = 0) {
  static std::map<std::pair<std::string, int>, BenchScene> scenes;
  return scenes.try_emplace({name.name, copy}, name).first->second;
}

/// Times the pair alone; the world moves on between the frames.
void TimePairs(benchmark::State& state, BenchScene& scene,
               const std::function<void(const PosedCamera&, const PosedCamera&)>& render) {
  const auto first = scene.Pair();
  render(first[0], first[1]);  // shaders are compiled when first used
  Stopwatch stopwatch(state);
  for (auto _ : state) {
    scene.Next();
    const auto pair = scene.Pair();
    stopwatch.Time(1, [&] { render(pair[0], pair[1]); });
  }
}

void PeerPair(benchmark::State& state, const BenchSceneName& name, const Products& products,
              bool shadows) {
  BenchScene& scene = SceneOf(name);
  Peer peer(scene.world(), {.shadows = shadows});
  TimePairs(state, scene, [&](const PosedCamera& left, const PosedCamera& right) {
    benchmark::DoNotOptimize(peer.Render(left, products));
    benchmark::DoNotOptimize(peer.Render(right, products));
  });
}

void OurPair(benchmark::State& state, const BenchSceneName& name, const Products& products,
             const RendererOptions& options) {
  BenchScene& scene = SceneOf(name);
  Renderer renderer(scene.world(), options);
  TimePairs(state, scene, [&](const PosedCamera& left, const PosedCamera& right) {
    const std::array<PosedCamera, 2> pair{left, right};
    benchmark::DoNotOptimize(renderer.RenderAll(pair, products));
  });
}

/// A pair when everything moves, so that no shadow map of the frame before holds: every light
/// moves, which moves every shadow.
void OurPairInMotion(benchmark::State& state, const BenchSceneName& name) {
  BenchScene& scene = SceneOf(name);
  Renderer renderer(scene.world());
  Stopwatch stopwatch(state);
  int frame = 0;
  for (auto _ : state) {
    scene.Next();  // puts the lights back
    const double moved_m = 1e-3 * (1 + ++frame % 10);
    for (int i = 0; i < scene.world().model().nlight; ++i) {
      for (int k = 0; k < 2; ++k) {
        scene.world().mutable_data().light_xpos[3 * i + k] += moved_m;
        scene.world().mutable_data().light_xdir[3 * i + k] += moved_m;
      }
    }
    const auto pair = scene.Pair();
    stopwatch.Time(1, [&] { benchmark::DoNotOptimize(renderer.RenderAll(pair, kAll)); });
  }
}

/// Two renderers of two worlds, each on a thread of its own, a pair each; the time of one pair.
void OurPairsOnTwoThreads(benchmark::State& state, const BenchSceneName& name) {
  BenchScene &one = SceneOf(name), &two = SceneOf(name, 1);
  Renderer first(one.world()), second(two.world());
  Stopwatch stopwatch(state);
  for (auto _ : state) {
    one.Next();
    two.Next();
    const auto pair = one.Pair();
    stopwatch.Time(2, [&] {
      std::thread other([&] { benchmark::DoNotOptimize(second.RenderAll(pair, kAll)); });
      benchmark::DoNotOptimize(first.RenderAll(pair, kAll));
      other.join();
    });
  }
}

/// The same by two peers.
void PeerPairsOnTwoThreads(benchmark::State& state, const BenchSceneName& name) {
  BenchScene &one = SceneOf(name), &two = SceneOf(name, 1);
  Peer first(one.world(), {}), second(two.world(), {});
  Stopwatch stopwatch(state);
  for (auto _ : state) {
    one.Next();
    two.Next();
    const auto pair = one.Pair();
    const auto render = [&pair](Peer& peer) {
      for (const PosedCamera& view : pair) benchmark::DoNotOptimize(peer.Render(view, kAll));
    };
    stopwatch.Time(2, [&] {
      std::thread other([&] { render(second); });
      render(first);
      other.join();
    });
  }
}

/// A pair of 2 x 2 pixels: what a frame costs before any pixel.
void OurEmptyPair(benchmark::State& state, const BenchSceneName& name) {
  BenchScene& scene = SceneOf(name);
  Renderer renderer(scene.world(), {.shadows = false});
  const auto tiny = hardware::CameraModel::FromHorizontalFov(2, 2, 1);
  TimePairs(state, scene, [&](const PosedCamera& left, const PosedCamera& right) {
    const std::array<PosedCamera, 2> pair{PosedCamera{left.X_WC, tiny},
                                          PosedCamera{right.X_WC, tiny}};
    benchmark::DoNotOptimize(renderer.RenderAll(pair, kRgb));
  });
}

/// The shadow maps drawn in full, as the first frame has to, and an image of 2 x 2 pixels.
void OurFirstShadows(benchmark::State& state, const BenchSceneName& name) {
  BenchScene& scene = SceneOf(name);
  const auto tiny = hardware::CameraModel::FromHorizontalFov(2, 2, 1);
  Renderer renderer(scene.world(), {});
  const hardware::Pose X_WC = scene.Pair()[0].X_WC;
  Stopwatch stopwatch(state);
  for (auto _ : state) {
    for (int i = 0; i < scene.world().model().nlight; ++i) {  // a moved light moves every shadow
      scene.world().mutable_data().light_xpos[3 * i] += 1e-3;
    }
    stopwatch.Time(1, [&] { renderer.Render(X_WC, tiny, kRgb); });
  }
}

/// Medians over the repetitions, by the benchmark's name.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const std::string& name = run.run_name.function_name;
      ms_[name].push_back(run.GetAdjustedRealTime());
      const auto cpu = run.counters.find("cpu_ms");
      if (cpu != run.counters.end()) ms_[name + "/cpu"].push_back(cpu->second.value);
    }
  }
  /// Milliseconds; 0 when it did not run.
  double Of(const std::string& name) const {
    const auto found = ms_.find(name);
    if (found == ms_.end()) return 0;
    std::vector<double> values = found->second;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  }

 private:
  std::map<std::string, std::vector<double>> ms_;
};

struct Case {
  const char* name;
  Products products;
};
constexpr Case kCases[] = {{"rgb", kRgb}, {"rgb+depth", kRgbDepth}, {"rgb+depth+ids", kAll}};

void Register(const std::string& name, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime()->Unit(benchmark::kMillisecond);
}

void RegisterAll() {
  for (const BenchSceneName& scene : testing::BenchScenes()) {
    for (const bool shadows : {true, false}) {
      const std::string light = scene.name + (shadows ? "/shadows/" : "/no_shadows/");
      for (const Case& c : kCases) {
        Register(light + c.name + "/peer",
                 [=](benchmark::State& s) { PeerPair(s, scene, c.products, shadows); });
        Register(light + c.name + "/ours",
                 [=](benchmark::State& s) { OurPair(s, scene, c.products, {.shadows = shadows}); });
      }
    }
    Register(scene.name + "/supersampled",
             [=](benchmark::State& s) { OurPair(s, scene, kAll, {.supersample = true}); });
    Register(scene.name + "/in_motion", [=](benchmark::State& s) { OurPairInMotion(s, scene); });
    Register(scene.name + "/two", [=](benchmark::State& s) { OurPairsOnTwoThreads(s, scene); });
    Register(scene.name + "/two_peers",
             [=](benchmark::State& s) { PeerPairsOnTwoThreads(s, scene); });
    Register(scene.name + "/empty", [=](benchmark::State& s) { OurEmptyPair(s, scene); });
    Register(scene.name + "/first_shadows",
             [=](benchmark::State& s) { OurFirstShadows(s, scene); });
  }
}

void PrintRatio(const Medians& medians, const std::string& scene, const std::string& what,
                const char* shadows, const std::string& peer, const std::string& ours) {
  const double theirs = medians.Of(peer), own = medians.Of(ours);
  if (theirs <= 0 || own <= 0) return;
  std::printf("| %s | %s | %s | %.1f | %.1f | %.2f | %.2f |\n", scene.c_str(), what.c_str(),
              shadows, theirs, own, own / theirs,
              medians.Of(ours + "/cpu") / medians.Of(peer + "/cpu"));
}

void PrintRatios(const Medians& medians) {
  std::printf(
      "\n| scene | images | shadows | peer [ms] | ours [ms] | ours / peer | of CPU time |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const BenchSceneName& scene : testing::BenchScenes()) {
    for (const bool shadows : {true, false}) {
      for (const Case& c : kCases) {
        const std::string name = scene.name + (shadows ? "/shadows/" : "/no_shadows/") + c.name;
        PrintRatio(medians, scene.name, c.name, shadows ? "on" : "off", name + "/peer",
                   name + "/ours");
      }
    }
    const std::string peer = scene.name + "/shadows/rgb+depth+ids/peer";
    PrintRatio(medians, scene.name, "rgb+depth+ids, two of ours and two peers, per pair", "on",
               scene.name + "/two_peers", scene.name + "/two");
    PrintRatio(medians, scene.name, "rgb+depth+ids, two of ours and one peer, per pair", "on", peer,
               scene.name + "/two");
    PrintRatio(medians, scene.name, "rgb+depth+ids, everything moves: no shadow map is kept", "on",
               peer, scene.name + "/in_motion");
    PrintRatio(medians, scene.name, "rgb+depth+ids, colour from 2 x 2 samples", "on", peer,
               scene.name + "/supersampled");
  }
}

/// Where a pair's time goes, as differences between what was timed.
void PrintProfile(const Medians& medians) {
  std::printf(
      "\n| scene | part of a pair with everything | CPU [ms] | share |\n|---|---|---|---|\n");
  for (const BenchSceneName& scene : testing::BenchScenes()) {
    const auto of = [&](const std::string& name) { return medians.Of(scene.name + name + "/cpu"); };
    const double all = of("/shadows/rgb+depth+ids/ours"), lit = of("/no_shadows/rgb/ours");
    if (all <= 0 || lit <= 0) continue;
    const auto row = [&](const char* part, double ms) {
      if (ms < 0) {
        std::printf("| %s | %s | below noise | below noise |\n", scene.name.c_str(), part);
      } else {
        std::printf("| %s | %s | %.2f | %.0f %% |\n", scene.name.c_str(), part, ms, 100 * ms / all);
      }
    };
    row("scene update, vertices (a pair of 2 x 2 pixels)", of("/empty"));
    row("lit pass and colour read-back", lit - of("/empty"));
    row("shadow maps where something moved, shadow look-ups", of("/shadows/rgb/ours") - lit);
    row("depth read-back", of("/shadows/rgb+depth/ours") - of("/shadows/rgb/ours"));
    row("ids", all - of("/shadows/rgb+depth/ours"));
    row("(once: shadow maps in full)", of("/first_shadows"));
  }
}

/// How our colours differ from mjr_render's over one pair, and what the scene asks for.
void PrintAgreement() {
  std::printf(
      "\n| scene | geoms | shadow lights | shadow map | samples | channels of a pair that "
      "differ | by more than 2 levels | at most |\n|---|---|---|---|---|---|---|---|\n");
  for (const BenchSceneName& name : testing::BenchScenes()) {
    BenchScene& scene = SceneOf(name);
    const mjModel& m = scene.world().model();
    Renderer ours(scene.world()), plain(scene.world(), {.shading = Shading::kMujoco});
    int any = 0, over_two = 0, worst = 0;
    for (const PosedCamera& view : scene.Pair()) {
      const cv::Mat3b a = ours.Render(view.X_WC, view.camera).bgr;
      const cv::Mat3b b = plain.Render(view.X_WC, view.camera).bgr;
      for (int i = 0; i < static_cast<int>(a.total()); ++i) {
        for (int c = 0; c < 3; ++c) {
          const int apart = std::abs(a(i / a.cols, i % a.cols)[c] - b(i / b.cols, i % b.cols)[c]);
          any += apart > 0;
          over_two += apart > 2;
          worst = std::max(worst, apart);
        }
      }
    }
    std::printf("| %s | %d | %d | %d | 1 | %d of %d | %d | %d |\n", name.name.c_str(), m.ngeom,
                static_cast<int>(std::count(m.light_castshadow, m.light_castshadow + m.nlight, 1)),
                m.vis.quality.shadowsize, any, 2 * 3 * 640 * 480, over_two, worst);
  }
}

}  // namespace
}  // namespace horopter::sim

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  horopter::sim::RegisterAll();
  horopter::sim::Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  horopter::sim::PrintRatios(medians);
  horopter::sim::PrintProfile(medians);
  horopter::sim::PrintAgreement();
  return 0;
}
