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

Album Draw(const std::string& backend, const std::string& environment) {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("views_" + std::to_string(getpid()) + "_" + backend);
  const std::string command =
      environment + " " HOROPTER_PRINT_HASHES " " + backend + " dump=" + path.string();
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

Agreement Compare(const Album& a, const Album& b) {
  const auto world = World::FromXml(testing::kShowroomXml);
  int pixels = 0, plain = 0, colour = 0, plain_colour = 0, depth = 0, ids = 0;
  for (std::size_t i = 0; i < a.views.size(); ++i) {
    const RenderedView &p = a.views[i], &q = b.views[i];
    for (int y = 0; y < p.bgr.rows; ++y) {
      for (int x = 0; x < p.bgr.cols; ++x, ++pixels) {
        const bool alike = cv::norm(p.bgr(y, x), q.bgr(y, x), cv::NORM_INF) <= kGreyLevels;
        const bool is_plain = p.ids(y, x) == q.ids(y, x) && IsPlain(world->model(), p.ids(y, x));
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
Agreement Measure(const Album& usual, const Album& other) {
  EXPECT_EQ(usual.status, 0);
  EXPECT_EQ(other.status, 0);
  EXPECT_EQ(usual.views.size(), testing::FixedViews().size());
  EXPECT_EQ(other.views.size(), usual.views.size());
  if (other.views.size() != usual.views.size() || usual.views.empty()) return {};
  const Agreement shares = Compare(usual, other);
  std::printf("agree: colours %.5f, without textures %.5f, depth %.5f, ids %.5f with %s",
              shares.colour, shares.untextured, shares.depth, shares.ids, other.driver.c_str());
  return shares;
}

TEST(RenderAgreement, SoftpipeDrawsTheSameWithinTwoGreyLevels) {
  const Album usual = Draw("osmesa", "GALLIUM_DRIVER=llvmpipe");
  const Album softpipe = Draw("osmesa", "GALLIUM_DRIVER=softpipe");
  if (softpipe.status == 0 && softpipe.driver == usual.driver) {
    GTEST_SKIP() << "THIS MESA HAS NO SOFTPIPE: agreement with another renderer is not tested.";
  }
  const Agreement shares = Measure(usual, softpipe);
  EXPECT_GE(shares.colour, kShare);
  EXPECT_GE(shares.untextured, kShare);
  EXPECT_GE(shares.depth, kShare);
  EXPECT_GE(shares.ids, kShare);
}

TEST(RenderAgreement, TheDriverOfEglDrawsTheSameWithinTwoGreyLevels) {
  const Album usual = Draw("osmesa", "GALLIUM_DRIVER=llvmpipe");
  const Album egl = Draw("egl", "");
  if (egl.status == kBackendMissing) {
    GTEST_SKIP() << "EGL IS NOT INSTALLED HERE: its driver is not tested. Install libegl1 and "
                    "libegl-mesa0.";
  }
  const Agreement shares = Measure(usual, egl);  // equal bits where it is the same driver
  EXPECT_GE(shares.colour, kShare);
  EXPECT_GE(shares.depth, kShare);
  EXPECT_GE(shares.ids, kShare);
}

}  // namespace
}  // namespace horopter::sim
