// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/surfaces.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

constexpr std::string_view kPrefix = "texture:";

std::string DrawFloor(RandomStream& random, const std::string& size) {
  const double kind = random.Uniform(0, 1), plank_m = random.Uniform(0.08, 0.14);
  return kind < 0.65 ? fmt::format("parquet,{},plank_m={:.3f}", size, plank_m) : "carpet," + size;
}

std::string DrawBrick(RandomStream& random, const std::string& size) {
  return fmt::format("brick,{},course_m={:.3f}", size, random.Uniform(0.065, 0.10));
}

/// The recipe with its free choices drawn again, or unchanged when it leaves none.
std::string Redrawn(const std::string& texture, const std::string& recipe, std::uint64_t seed) {
  RandomStream random(seed, "room.surface." + texture);
  const std::string kind = recipe.substr(0, recipe.find(','));
  const std::size_t size_at = recipe.find("size_m=");
  if (size_at == std::string::npos) return recipe;
  const std::string size = recipe.substr(size_at, recipe.find(',', size_at) - size_at);
  if (texture == "floor") return DrawFloor(random, size);
  if (kind == "brick") return DrawBrick(random, size);
  if (kind == "fabric")
    return fmt::format("fabric,{},hue_deg={:.0f}", size, random.Uniform(0, 360));
  if (kind == "wood") return fmt::format("wood,{},darkness={:.2f}", size, random.Uniform(0.1, 0.6));
  return recipe;
}

/// Pale shades that walls are painted in.
Eigen::Vector3d DrawTint(RandomStream& random) {
  static const std::array<Eigen::Vector3d, 5> kTints = {
      Eigen::Vector3d(1.00, 1.00, 1.00), Eigen::Vector3d(1.00, 0.97, 0.88),
      Eigen::Vector3d(0.93, 1.00, 0.93), Eigen::Vector3d(0.92, 0.96, 1.00),
      Eigen::Vector3d(1.00, 0.94, 0.90)};
  return kTints[static_cast<std::size_t>(random.Uniform(0, kTints.size()))];
}

}  // namespace

std::map<std::string, std::string> VarySurfaces(SceneDocument& scene, std::uint64_t seed) {
  std::map<std::string, std::string> changed;
  for (pugi::xml_node text : scene.Elements("text")) {
    const std::string name = text.attribute("name").value();
    if (!name.starts_with(kPrefix)) continue;
    const std::string texture = name.substr(kPrefix.size());
    const std::string before = text.attribute("data").value();
    const std::string after = Redrawn(texture, before, seed);
    if (after == before) continue;
    text.attribute("data").set_value(after.c_str());
    changed[texture] = after;
  }
  for (pugi::xml_node material : scene.Elements("material")) {
    const std::string name = material.attribute("name").value();
    if (!name.ends_with("_wall") || name.starts_with("brick") || material.attribute("rgba"))
      continue;
    RandomStream random(seed, "room.tint." + name);
    const Eigen::Vector3d tint = DrawTint(random);
    material.append_attribute("rgba") = MjcfNumbers({tint[0], tint[1], tint[2], 1}).c_str();
  }
  return changed;
}

}  // namespace horopter::sim
