// SPDX-License-Identifier: Apache-2.0
// How far other renderers agree with the one of every day, llvmpipe behind OSMesa: Mesa's softpipe,
// which shares none of its rasteriser's code, and the GPU that EGL draws with where there is one.
// Two drivers cannot share a process, so each draws the fixed views in one of its own.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "bench_scene.h"
#include "fixed_views.h"

namespace horopter::sim {
namespace {

constexpr int kBackendMissing = 3;
constexpr double kGreyLevels = 2;
constexpr double kDepth = 1e-4;  // of itself
constexpr double kShare = 0.995;

/// What a driver made of the fixed views.
struct Album {
  int status = -1;
  std::string driver;
  std::vector<RenderedView> views;
};

template <typename Pixel>
cv::Mat_<Pixel> Read(std::ifstream& file, int width, int height) {
  cv::Mat_<Pixel> image(height, width);
  file.read(reinterpret_cast<char*>(image.data),
            static_cast<std::streamsize>(image.total() * image.elemSize()));
  return image;
}

/// @param scene a shipped one; empty for the fixed views
Album Draw(const std::string& backend, const std::string& environment,
           const std::string& scene = "") {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("views_" + std::to_string(getpid()) + "_" + backend);
  const std::string command = environment + " " HOROPTER_PRINT_HASHES " " + backend +
                              " dump=" + path.string() + (scene.empty() ? "" : " scene=" + scene);
  Album album;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return album;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    if (album.driver.empty()) album.driver = line.data();
  }
  album.status = WEXITSTATUS(pclose(pipe));
  std::ifstream file(path, std::ios::binary);
  for (int size[2]; file.read(reinterpret_cast<char*>(size), sizeof size);) {
    RenderedView view;
    view.bgr = Read<cv::Vec3b>(file, size[0], size[1]);
    view.depth = Read<float>(file, size[0], size[1]);
    view.ids = Read<int>(file, size[0], size[1]);
    album.views.push_back(view);
  }
  std::filesystem::remove(path);
  return album;
}

/// Shares of the pixels that both show.
struct Agreement {
  double colour = 0;
  double untextured = 0;  ///< of colours, where both show an opaque thing without a texture
  double depth = 0;
  double ids = 0;
};

/// Opaque, and of one colour.
bool IsPlain(const mjModel& model, int geom) {
  if (geom < 0) return false;
  const int material = model.geom_matid[geom];
  const float* rgba = material < 0 ? model.geom_rgba + 4 * geom : model.mat_rgba + 4 * material;
  return rgba[3] == 1 && (material < 0 || model.mat_texid[material] < 0);
}

/// @param levels how far colours may lie apart
Agreement Compare(const mjModel& model, const Album& a, const Album& b,
                  double levels = kGreyLevels) {
  int pixels = 0, plain = 0, colour = 0, plain_colour = 0, depth = 0, ids = 0;
  for (std::size_t i = 0; i < a.views.size(); ++i) {
    const RenderedView &p = a.views[i], &q = b.views[i];
    for (int y = 0; y < p.bgr.rows; ++y) {
      for (int x = 0; x < p.bgr.cols; ++x, ++pixels) {
        const bool alike = cv::norm(p.bgr(y, x), q.bgr(y, x), cv::NORM_INF) <= levels;
        const bool is_plain = p.ids(y, x) == q.ids(y, x) && IsPlain(model, p.ids(y, x));
        colour += alike;
        plain += is_plain;
        plain_colour += is_plain && alike;
        ids += p.ids(y, x) == q.ids(y, x);
        const float z = p.depth(y, x), other = q.depth(y, x);
        depth += z == other || std::abs(z - other) <= kDepth * z;
      }
    }
  }
  const double all = pixels;
  return {colour / all, plain_colour / static_cast<double>(plain), depth / all, ids / all};
}

/// Compares what can be compared, and prints it.
Agreement Measure(const mjModel& model, const Album& usual, const Album& other) {
  EXPECT_EQ(usual.status, 0);
  EXPECT_EQ(other.status, 0);
  EXPECT_FALSE(usual.views.empty());
  EXPECT_EQ(other.views.size(), usual.views.size());
  if (other.views.size() != usual.views.size() || usual.views.empty()) return {};
  const Agreement shares = Compare(model, usual, other);
  std::printf("agree: colours %.5f, without textures %.5f, depth %.5f, ids %.5f with %s",
              shares.colour, shares.untextured, shares.depth, shares.ids, other.driver.c_str());
  return shares;
}

constexpr const char* kNoSoftpipe =
    "THIS MESA HAS NO SOFTPIPE: agreement with another renderer is not tested.";

TEST(RenderAgreement, SoftpipeDrawsTheSameWithinTwoGreyLevels) {
  const Album usual = Draw("osmesa", "GALLIUM_DRIVER=llvmpipe");
  const Album softpipe = Draw("osmesa", "GALLIUM_DRIVER=softpipe");
  if (softpipe.status == 0 && softpipe.driver == usual.driver) GTEST_SKIP() << kNoSoftpipe;
  const auto world = World::FromXml(testing::kShowroomXml);
  const Agreement shares = Measure(world->model(), usual, softpipe);
  EXPECT_GE(shares.colour, kShare);
  EXPECT_GE(shares.untextured, kShare);
  EXPECT_GE(shares.depth, kShare);
  EXPECT_GE(shares.ids, kShare);
}

class ShippedSceneAgreement : public ::testing::TestWithParam<testing::BenchSceneName> {};

// llvmpipe filters textures in bytes, which moves colours by up to four levels, and nearly every
// pixel of these scenes has a texture. So the usual llvmpipe is held to four grey levels, and one
// that filters in floats to two: 0.3, 0.7 and 0.5 % of the pixels are then farther apart, on
// textures seen small, whose levels follow from llvmpipe's logarithm.
TEST_P(ShippedSceneAgreement, SoftpipeDrawsTheSameButForTheFilterInBytes) {
  constexpr double kFourLevels = 4, kShareInFloats = 0.99, kShareOfShapes = 0.9999;
  const std::string& name = GetParam().name;
  const Album usual = Draw("osmesa", "GALLIUM_DRIVER=llvmpipe", name);
  const Album softpipe = Draw("osmesa", "GALLIUM_DRIVER=softpipe", name);
  if (softpipe.status == 0 && softpipe.driver == usual.driver) GTEST_SKIP() << kNoSoftpipe;
  const Album in_floats =
      Draw("osmesa", "GALLIUM_DRIVER=llvmpipe GALLIVM_PERF=no_aos_sampling", name);
  for (const Album& album : {usual, softpipe, in_floats}) {
    ASSERT_EQ(album.status, 0);
    ASSERT_EQ(album.views.size(), 2);
  }
  const World world(testing::PathOf(GetParam()));
  const Agreement two = Compare(world.model(), usual, softpipe);
  const Agreement four = Compare(world.model(), usual, softpipe, kFourLevels);
  const Agreement floats = Compare(world.model(), in_floats, softpipe);
  std::printf(
      "agree: within 2 levels %.5f, 4 levels %.5f; in floats, 2 levels %.5f; depth %.5f, ids "
      "%.5f\n",
      two.colour, four.colour, floats.colour, two.depth, two.ids);
  EXPECT_GE(four.colour, kShare);
  EXPECT_GE(floats.colour, kShareInFloats);
  EXPECT_GE(two.depth, kShareOfShapes);
  EXPECT_GE(two.ids, kShareOfShapes);
}

INSTANTIATE_TEST_SUITE_P(RenderAgreement, ShippedSceneAgreement,
                         ::testing::ValuesIn(testing::BenchScenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(RenderAgreement, TheDriverOfEglDrawsTheSameWithinTwoGreyLevels) {
  const Album usual = Draw("osmesa", "GALLIUM_DRIVER=llvmpipe");
  const Album egl = Draw("egl", "");
  const auto world = World::FromXml(testing::kShowroomXml);
  if (egl.status == kBackendMissing) {
    GTEST_SKIP() << "EGL IS NOT INSTALLED HERE: its driver is not tested. Install libegl1 and "
                    "libegl-mesa0.";
  }
  const Agreement shares =
      Measure(world->model(), usual, egl);  // equal bits where it is the same driver
  EXPECT_GE(shares.colour, kShare);
  EXPECT_GE(shares.depth, kShare);
  EXPECT_GE(shares.ids, kShare);
}

}  // namespace
}  // namespace horopter::sim
