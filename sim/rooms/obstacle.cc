// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/obstacle.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

constexpr double kScreenThickness_m = 0.04;
constexpr double kScreenFoot_m = 0.30;

double Draw(RandomStream& random, double low, double high) {
  // To the millimetre, as one would note it.
  return std::round(random.Uniform(low, high) * 1000) / 1000;
}

/// A colour of paint: full, of any hue, never as dark as to hide its texture.
Vector3d DrawPaint(RandomStream& random) {
  static const std::array<Vector3d, 6> kPaints = {
      Vector3d(1.00, 0.22, 0.20),  // red
      Vector3d(0.24, 0.42, 0.95),  // blue
      Vector3d(0.98, 0.80, 0.18),  // yellow
      Vector3d(0.30, 0.75, 0.34),  // green
      Vector3d(1.00, 0.52, 0.16),  // orange
      Vector3d(0.58, 0.36, 0.78),  // violet
  };
  const auto chosen = static_cast<std::size_t>(random.Uniform(0, kPaints.size()));
  return kPaints[chosen] * random.Uniform(0.85, 1.0);
}

std::string FabricOfAnyHue(RandomStream& random) {
  return fmt::format("fabric,hue_deg={:.0f}", random.Uniform(0, 360));
}

/// Surface and colour that suit the shape.
void DrawSurface(Obstacle& o, RandomStream random) {
  if (o.shape == "carton" || o.shape == "cartons") {
    o.surface = "cardboard";
    o.rgb = Vector3d::Constant(random.Uniform(0.85, 1.0));
  } else if (o.shape == "crate") {
    o.surface = fmt::format("wood,darkness={:.2f}", random.Uniform(0.05, 0.5));
  } else if (o.shape == "screen") {
    o.surface = FabricOfAnyHue(random);
  } else if (o.shape == "bin") {
    o.surface = "plaster";
    o.rgb = Vector3d(0.42, 0.46, 0.50) * random.Uniform(0.7, 1.3);
  } else {
    o.surface = "plaster";
    o.rgb = DrawPaint(random);
  }
}

std::string Size(const Vector3d& s) { return fmt::format("{}x{}x{}", s.x(), s.y(), s.z()); }

/// A cube texture of its own for a thing of that size.
void AddTexture(SceneDocument& scene, const Obstacle& o, const std::string& name,
                const Vector3d& size_m) {
  pugi::xml_node asset = scene.AppendSection("asset");
  pugi::xml_node texture = asset.append_child("texture");
  texture.append_attribute("name") = name.c_str();
  texture.append_attribute("type") = "cube";
  texture.append_attribute("builtin") = "flat";
  texture.append_attribute("width") = 160;
  texture.append_attribute("height") = 6 * 160;
  pugi::xml_node material = asset.append_child("material");
  material.append_attribute("name") = name.c_str();
  material.append_attribute("texture") = name.c_str();
  material.append_attribute("specular") = 0;
  material.append_attribute("rgba") = MjcfNumbers({o.rgb[0], o.rgb[1], o.rgb[2], 1}).c_str();
  pugi::xml_node recipe = scene.AppendSection("custom").append_child("text");
  recipe.append_attribute("name") = ("texture:" + name).c_str();
  const std::size_t comma = o.surface.find(',');
  const std::string keys = comma == std::string::npos ? "" : o.surface.substr(comma);
  recipe.append_attribute("data") =
      (o.surface.substr(0, comma) + ",size_m=" + Size(size_m) + keys).c_str();
}

pugi::xml_node AddGeom(pugi::xml_node body, const char* type, const Vector3d& place,
                       std::initializer_list<double> size, const std::string& material) {
  pugi::xml_node geom = body.append_child("geom");
  geom.append_attribute("type") = type;
  geom.append_attribute("size") = MjcfNumbers(size).c_str();
  geom.append_attribute("pos") = MjcfNumbers({place.x(), place.y(), place.z()}).c_str();
  geom.append_attribute("material") = material.c_str();
  return geom;
}

void AddBox(pugi::xml_node body, const Vector3d& place, const Vector3d& size,
            const std::string& material) {
  AddGeom(body, "box", place, {size.x() / 2, size.y() / 2, size.z() / 2}, material);
}

/// The upper carton: three quarters of the lower one, askew and a little off its middle.
constexpr double kUpperShare = 0.72;
constexpr double kUpperHeightShare = 0.42;

void AddCartons(SceneDocument& scene, pugi::xml_node body, const Obstacle& o) {
  Vector3d lower = o.size_m, upper = o.size_m * kUpperShare;
  upper.z() = o.size_m.z() * kUpperHeightShare;
  lower.z() = o.size_m.z() - upper.z();
  AddTexture(scene, o, o.name, lower);
  AddTexture(scene, o, o.name + "_upper", upper);
  AddBox(body, {0, 0, lower.z() / 2}, lower, o.name);
  pugi::xml_node geom = AddGeom(body, "box", {0.01, -0.015, lower.z() + upper.z() / 2},
                                {upper.x() / 2, upper.y() / 2, upper.z() / 2}, o.name + "_upper");
  const double half_turn = 7 * M_PI / 180;
  geom.append_attribute("quat") =
      MjcfNumbers({std::cos(half_turn), 0, 0, std::sin(half_turn)}).c_str();
}

void AddScreen(SceneDocument& scene, pugi::xml_node body, const Obstacle& o) {
  constexpr double kFootHeight_m = 0.03;
  AddTexture(scene, o, o.name, o.size_m);
  AddBox(body, {0, 0, kFootHeight_m + (o.size_m.z() - kFootHeight_m) / 2},
         {o.size_m.x(), kScreenThickness_m, o.size_m.z() - kFootHeight_m}, o.name);
  for (const double side : {-0.42, 0.42}) {
    AddBox(body, {side * o.size_m.x(), 0, kFootHeight_m / 2}, {0.06, kScreenFoot_m, kFootHeight_m},
           o.name);
  }
}

}  // namespace

double Obstacle::radius_m() const {
  const bool round = shape == "drum" || shape == "bin" || shape == "ball";
  return round ? size_m.x() / 2 : size_m.head<2>().norm() / 2;
}

Obstacle DrawObstacle(int index, std::uint64_t seed) {
  static const std::array<const char*, 7> kShapes = {"carton", "cartons", "crate", "block",
                                                     "drum",   "bin",     "ball"};
  Obstacle o;
  o.name = fmt::format("obstacle_{}", index);
  RandomStream random(seed, "room.shape." + o.name);
  o.shape = kShapes[static_cast<std::size_t>(random.Uniform(0, kShapes.size()))];
  const double across = Draw(random, 0.24, 0.36), ratio = random.Uniform(0.75, 1.0);
  const double height = Draw(random, 0.36, 0.50);
  if (o.shape == "ball") {
    o.size_m = Vector3d::Constant(Draw(random, 0.36, 0.46));
  } else if (o.shape == "drum" || o.shape == "bin") {
    o.size_m = {across, across, height};
  } else if (o.shape == "cartons") {
    o.size_m = {across, std::round(1000 * across * ratio) / 1000, Draw(random, 0.46, 0.62)};
  } else {
    o.size_m = {across, std::round(1000 * across * ratio) / 1000, height};
  }
  DrawSurface(o, RandomStream(seed, "room.colour." + o.name));
  return o;
}

Obstacle DrawScreen(int index, double length_m, std::uint64_t seed) {
  Obstacle o;
  o.name = fmt::format("obstacle_{}", index);
  o.shape = "screen";
  RandomStream random(seed, "room.shape.screens");  // of one make, all of them
  o.size_m = {length_m, kScreenFoot_m, Draw(random, 1.1, 1.4)};
  DrawSurface(o, RandomStream(seed, "room.colour.screens"));
  return o;
}

void AddObstacle(SceneDocument& scene, const Obstacle& o) {
  pugi::xml_node body = scene.AppendSection("worldbody").append_child("body");
  body.append_attribute("name") = o.name.c_str();
  SetPose(body, o.X_WO);
  const Vector3d middle(0, 0, o.size_m.z() / 2);
  if (o.shape == "cartons") return AddCartons(scene, body, o);
  if (o.shape == "screen") return AddScreen(scene, body, o);
  AddTexture(scene, o, o.name, o.size_m);
  if (o.shape == "drum" || o.shape == "bin") {
    AddGeom(body, "cylinder", middle, {o.size_m.x() / 2, o.size_m.z() / 2}, o.name);
  } else if (o.shape == "ball") {
    AddGeom(body, "sphere", middle, {o.size_m.x() / 2}, o.name);
  } else {
    AddBox(body, middle, o.size_m, o.name);
  }
}

}  // namespace horopter::sim
