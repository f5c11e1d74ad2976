// SPDX-License-Identifier: Apache-2.0
// The same bits in every process, on any number of threads, in any order, under load and with
// either backend of one Mesa. Hashes are compared between runs, since kinds of processor may
// differ.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <string>

#include "fixed_views.h"

namespace horopter::sim {
namespace {

constexpr Products kEverything{.rgb = true, .depth = true, .ids = true};
constexpr int kBackendMissing = 3;

struct Answer {
  int status = -1;
  std::string hashes;
};

/// What print_hashes says, started with these environment variables.
Answer HashesOf(const std::string& arguments, const std::string& environment = "") {
  const std::string command = environment + " " HOROPTER_PRINT_HASHES " " + arguments;
  Answer answer;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return answer;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) answer.hashes += line.data();
  answer.status = WEXITSTATUS(pclose(pipe));
  return answer;
}

void ExpectSame(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.status, 0);
  EXPECT_EQ(b.status, 0);
  EXPECT_FALSE(a.hashes.empty());
  EXPECT_EQ(a.hashes, b.hashes);
}

TEST(RenderDeterminism, ProcessesAgree) { ExpectSame(HashesOf("osmesa"), HashesOf("osmesa")); }

TEST(RenderDeterminism, ThreadCountChangesNoBit) {
  const Answer usual = HashesOf("osmesa");
  for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=5"}) {
    SCOPED_TRACE(threads);
    ExpectSame(HashesOf("osmesa", threads), usual);
  }
}

TEST(RenderDeterminism, OrderChangesNoBit) {
  ExpectSame(HashesOf("osmesa reverse"), HashesOf("osmesa"));
}

TEST(RenderDeterminism, LoadChangesNoBit) {
  ExpectSame(HashesOf("osmesa busy"), HashesOf("osmesa"));
}

TEST(RenderDeterminism, BackendsOfOneMesaGiveTheSameBits) {
  const Answer osmesa = HashesOf("osmesa");
  const Answer egl = HashesOf("egl", "LIBGL_ALWAYS_SOFTWARE=1");
  if (egl.status == kBackendMissing) {
    GTEST_SKIP() << "EGL IS NOT INSTALLED HERE: the second backend is not tested. Install libegl1 "
                    "and libegl-mesa0.";
  }
  const auto driver = [](const Answer& answer) {
    return answer.hashes.substr(0, answer.hashes.find('\n'));
  };
  ASSERT_EQ(egl.status, 0);
  if (driver(egl) != driver(osmesa)) {
    GTEST_SKIP() << "EGL DRAWS WITH ANOTHER DRIVER HERE (" << driver(egl) << ", OSMesa with "
                 << driver(osmesa) << "): equal bits are not tested.";
  }
  ExpectSame(egl, osmesa);
}

/// All hashes of one pair of eyes as a body of the scene goes to and fro.
std::vector<std::uint64_t> HashesAlong(World& world, const std::vector<Renderer*>& renderers,
                                       const std::vector<double>& places) {
  const auto views = testing::FixedViews();
  std::vector<std::uint64_t> hashes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    world.mutable_data().qpos[0] = places[i];
    world.Forward();
    Renderer& renderer = *renderers[i % renderers.size()];
    for (const auto& view : renderer.RenderAll({{views[0], views[1]}}, kEverything)) {
      hashes.push_back(testing::Hash(view));
    }
  }
  return hashes;
}

TEST(RenderDeterminism, KeptShadowMapsShowWhatFreshOnesWould) {
  const auto world = World::FromXml(testing::kShowroomXml);
  const std::vector<double> places{0, 0.35, 0.35, -0.2, 5, 0};
  Renderer kept(*world, {.width = 320, .height = 240});
  const auto along = HashesAlong(*world, {&kept}, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    SCOPED_TRACE(places[i]);
    Renderer fresh(*world, {.width = 320, .height = 240});
    const auto alone = HashesAlong(*world, {&fresh}, {places[i]});
    EXPECT_EQ(along[2 * i], alone[0]);
    EXPECT_EQ(along[2 * i + 1], alone[1]);
  }
}

TEST(RenderDeterminism, OneRendererOrSeveralGiveTheSameBits) {
  const auto world = World::FromXml(testing::kShowroomXml);
  const std::vector<double> places{0, 0.2, -0.3, 0.2};
  Renderer one(*world, {.width = 320, .height = 240});
  Renderer first(*world, {.width = 320, .height = 240}),
      second(*world, {.width = 400, .height = 300});
  EXPECT_EQ(HashesAlong(*world, {&one}, places), HashesAlong(*world, {&first, &second}, places));
}

TEST(RenderDeterminism, AllAtOnceIsEachAlone) {
  const auto world = World::FromXml(testing::kShowroomXml);
  const auto views = testing::FixedViews();
  Renderer renderer(*world, {.width = 320, .height = 240});
  const auto together = renderer.RenderAll(views, kEverything);
  ASSERT_EQ(together.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(testing::Hash(together[i]),
              testing::Hash(renderer.Render(views[i].X_WC, views[i].camera, kEverything)));
  }
}

}  // namespace
}  // namespace horopter::sim
