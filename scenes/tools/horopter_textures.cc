// SPDX-License-Identifier: Apache-2.0
// Writes the pictures that a scene's textures are painted with, one PNG each.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

#include "sim/textures/paint_textures.h"
#include "sim/world/world.h"

namespace {

void WritePictures(const std::string& scene, const std::filesystem::path& folder,
                   std::uint64_t seed) {
  const horopter::sim::World world(scene);
  const auto pictures = horopter::sim::PaintPictures(world.model(), seed);
  std::filesystem::create_directories(folder);
  for (const auto& picture : pictures) {
    const std::filesystem::path file = folder / (picture.name + ".png");
    if (!cv::imwrite(file.string(), picture.bgr)) {
      throw std::runtime_error(
          fmt::format("cannot write {}: is the folder writable?", file.string()));
    }
  }
  fmt::print("{} pictures in {}\n", pictures.size(), folder.string());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Writes the pictures that a scene's textures are painted with, one PNG each (a cube texture "
      "has six).\n\nExample:\n  horopter_textures scenes/koala/room.xml /tmp/textures --seed 3"};
  std::string scene;
  std::string folder;
  std::uint64_t seed = 1;
  app.add_option("scene", scene, "MJCF file")->required();
  app.add_option("folder", folder, "where the PNG files go; made when missing")->required();
  app.add_option("--seed", seed, "seed of the run whose textures to paint")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    WritePictures(scene, folder, seed);
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "horopter_textures: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "horopter_textures: {}\n", error.what());
    return 2;
  }
  return 0;
}
