// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/render/render_request.h"

namespace CLI {
class App;
}

namespace horopter::scenarios {

/// `horopter render` as written on the command line.
struct RenderArguments {
  std::string scene;
  std::string again;
  std::string robot;
  std::string out;
  std::string sheet;
  bool truth = false;
  bool png16 = false;
  std::vector<std::string> between;

  std::string pan, tilt, vergence;  ///< "A" or "A:B"; "" = not given
  std::vector<std::string> axes;    ///< "NAME=DEG"
  std::string poses;
  int random = 0;
  std::vector<std::string> bodies;  ///< "NAME=X,Y,Z[,YAW,PITCH,ROLL]"

  std::string motion;                 ///< YAML file
  std::vector<std::string> saccades;  ///< "NAME=DEG,...[@SECONDS]"
  std::vector<std::string> walks;     ///< "X,Y,TURN[@SECONDS]"
  std::vector<std::string> drives;    ///< "SPEED,TURN[@SECONDS]"
  std::optional<double> duration_s;
  std::optional<double> rate_hz;
  std::string faults;  ///< YAML file

  std::optional<std::uint64_t> seed;
  std::string obstacles;  ///< "N" or "MIN:MAX"
  std::string goal;       ///< "X,Y"
  std::optional<double> clearance_m;
  bool blocked = false;
  std::optional<int> clutter;
  std::optional<double> occluded;
  std::string background;
  std::optional<double> brightness;
  std::optional<double> colour_temperature_k;

  std::vector<std::string> cameras;
  std::string size;
  std::string profile = "ideal";
  std::string camera_file;
  bool supersample = false;
  std::string gl = "osmesa";
  std::vector<std::string> views;
};

/// Declares the options, which exclude or need each other where one says nothing without another.
void AddRenderOptions(CLI::App& app, RenderArguments& arguments);

/// What the options ask for. @throws hardware::ConfigError, ScenarioError, FormatError
RenderRequest RequestOf(const RenderArguments& arguments);

}  // namespace horopter::scenarios
