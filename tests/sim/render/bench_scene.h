// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/render/renderer.h"

namespace horopter::sim::testing {

/// A shipped scene with the pair of cameras that looks at it.
struct BenchSceneName {
  std::string name;
  std::string file;  ///< below scenes/
  std::string left, right;
};

/// Those whose files exist.
std::vector<BenchSceneName> BenchScenes();
std::filesystem::path PathOf(const BenchSceneName& scene);

/// A scene with painted textures whose robot moves a little from frame to frame.
class BenchScene {
 public:
  explicit BenchScene(const BenchSceneName& scene);

  World& world() { return *world_; }
  /// Takes the first joint 1 mm (or mrad) on and back, and turns both eyes by 0.1 deg: what a frame
  /// of a driving robot changes.
  void Next();
  /// The stereo pair as it is now, 60 deg wide.
  std::array<PosedCamera, 2> Pair(int width = 640, int height = 480) const;

 private:
  BenchSceneName name_;
  std::unique_ptr<World> world_;
  double start_ = 0;
  int frame_ = 0;
};

}  // namespace horopter::sim::testing
