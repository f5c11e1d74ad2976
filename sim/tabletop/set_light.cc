// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/set_light.h"

#include <algorithm>
#include <cmath>

#include "sim/random/random_stream.h"
#include "sim/tabletop/light_colour.h"

namespace horopter::sim {

namespace {

double Draw(double nominal, double spread, std::uint64_t seed, const char* what) {
  RandomStream random(seed, std::string("tabletop.light.") + what);
  return nominal + spread * random.Uniform(-1, 1);
}

void Scale(float rgb[3], const Eigen::Vector3d& by) {
  for (int c = 0; c < 3; ++c) rgb[c] *= static_cast<float>(by[c]);
}

}  // namespace

LampState DrawLamp(const LightConfig& config, std::uint64_t seed) {
  LampState lamp;
  lamp.azimuth_rad = Draw(config.azimuth_rad, config.azimuth_spread_rad, seed, "azimuth");
  lamp.elevation_rad = std::min(
      Draw(config.elevation_rad, config.elevation_spread_rad, seed, "elevation"), M_PI / 2);
  lamp.brightness = Draw(config.brightness, config.brightness_spread, seed, "brightness");
  lamp.colour_temperature_k = std::min(
      Draw(config.colour_temperature_k, config.colour_temperature_spread_k, seed, "colour"),
      kHighestColourTemperature_k);
  return lamp;
}

void SetLamp(World& world, const LampState& lamp, const Eigen::Vector3d& centre_W) {
  constexpr double kDistance_m = 2.5;  // between the ceiling and the table; shadows start here
  const int id = world.Id(mjOBJ_LIGHT, "lamp");
  mjModel& model = world.mutable_model();
  const Eigen::Vector3d up(std::cos(lamp.elevation_rad) * std::cos(lamp.azimuth_rad),
                           std::cos(lamp.elevation_rad) * std::sin(lamp.azimuth_rad),
                           std::sin(lamp.elevation_rad));
  Eigen::Map<Eigen::Vector3d>{model.light_pos + 3 * id} = centre_W + kDistance_m * up;
  Eigen::Map<Eigen::Vector3d>{model.light_dir + 3 * id} = -up;
  const Eigen::Vector3d tint = lamp.brightness * LightColour(lamp.colour_temperature_k);
  for (int light = 0; light < model.nlight; ++light) {
    Scale(model.light_diffuse + 3 * light, tint);
    Scale(model.light_ambient + 3 * light, tint);
    Scale(model.light_specular + 3 * light, tint);
  }
}

}  // namespace horopter::sim
