// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/lighting.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <sstream>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

using Colour = Eigen::Array3d;

/// Factors on the colours of the lights that a scene was built with.
struct Mood {
  const char* name;
  Colour lamp;
  Colour window;
  Colour rest;
};

const std::array<Mood, 4>& Moods() {
  static const std::array<Mood, 4> kMoods = {{
      {"daylight", {0.85, 0.87, 0.90}, {1.22, 1.24, 1.27}, {1.10, 1.10, 1.12}},
      {"evening", {1.05, 0.95, 0.80}, {1.08, 0.95, 0.78}, {0.92, 0.84, 0.74}},
      {"lamps", {1.38, 1.32, 1.20}, {0.80, 0.78, 0.75}, {1.00, 0.97, 0.92}},
      {"overcast", {0.80, 0.82, 0.85}, {1.06, 1.10, 1.15}, {1.08, 1.10, 1.14}},
  }};
  return kMoods;
}

Eigen::Vector3d Numbers(const pugi::xml_attribute& attribute) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  std::istringstream text(attribute.value());
  text.imbue(std::locale::classic());
  for (int i = 0; i < 3; ++i) text >> v[i];
  return v;
}

void Scale(pugi::xml_attribute attribute, const Colour& factor) {
  if (!attribute) return;
  const Colour colour = (Numbers(attribute).array() * factor).min(1.0);
  attribute.set_value(MjcfNumbers({colour[0], colour[1], colour[2]}).c_str());
}

void TurnAboutVertical(pugi::xml_attribute direction, double angle_rad) {
  const Eigen::Vector3d d = Numbers(direction);
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  direction.set_value(MjcfNumbers({c * d.x() - s * d.y(), s * d.x() + c * d.y(), d.z()}).c_str());
}

}  // namespace

std::vector<std::string> LightingNames() {
  std::vector<std::string> names;
  for (const Mood& mood : Moods()) names.emplace_back(mood.name);
  return names;
}

Lighting ApplyLighting(SceneDocument& scene, const std::string& kind, std::uint64_t seed) {
  if (kind == "as_built") return {kind, 1};
  RandomStream random(seed, "room.lighting");
  const auto drawn = static_cast<std::size_t>(random.Uniform(0, Moods().size()));
  const double brightness = random.Uniform(0.9, 1.1);
  const double turn_rad = random.Uniform(-M_PI, M_PI);
  const Mood* chosen = &Moods()[drawn];
  for (const Mood& mood : Moods()) {
    if (mood.name == kind) chosen = &mood;
  }
  for (pugi::xml_node light : scene.Elements("light")) {
    const std::string_view name = light.attribute("name").value();
    const Colour& factor = name == "lamp"     ? chosen->lamp
                           : name == "window" ? chosen->window
                                              : chosen->rest;
    Scale(light.attribute("diffuse"), factor * brightness);
    Scale(light.attribute("ambient"), factor * brightness);
    if (name == "lamp") TurnAboutVertical(light.attribute("dir"), turn_rad);
  }
  return {chosen->name, brightness};
}

}  // namespace horopter::sim
