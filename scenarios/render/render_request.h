// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/fault_spec.h"
#include "scenarios/format/scenario.h"
#include "scenarios/render/motion.h"
#include "scenarios/render/pose_table.h"

namespace horopter::scenarios {

/// What stands on a scene's table, how it is lit, and what is behind it.
struct TableSpec {
  static constexpr double kNothingHidden = 0;

  int clutter = 0;                   ///< things that belong to no experiment
  double occluded = kNothingHidden;  ///< share of the target that another object hides
  std::string background;            ///< one of the scene's; empty: drawn
  double brightness = 1;             ///< 1: as the scene has it
  double colour_temperature_k = 6500;

  bool operator==(const TableSpec&) const = default;
};

/// A room of obstacles in the scene's walls.
struct GeneratedRoom {
  RoomSpec spec;
  Eigen::Vector2d goal_m{3, 0};  ///< that the free path leads to, in the robot's starting frame

  bool operator==(const GeneratedRoom&) const = default;
};

/// Everything that decides the bytes of a data set, in a user's words: a scene, a robot in it, its
/// cameras, and where it looks in every frame, or what it does meanwhile. A manifest holds it, so
/// that the set can be made again.
struct RenderRequest {
  /// Stands for the cameras' native size; outside every range.
  static constexpr int kNative = -1;

  std::string scene;                  ///< below the scenes folder, e.g. koala/room.xml
  std::string robot;                  ///< a folder of the scenes folder
  std::optional<std::uint64_t> seed;  ///< none: the scene as it is written down
  std::optional<GeneratedRoom> room;
  std::optional<TableSpec> table;  ///< only for scenes with one; none: the defaults

  std::vector<std::string> pairs;  ///< of the robot's cameras; empty: all
  CameraSpec camera{kNative, kNative, kRobotsOwn, sim::CameraProfile{}};
  bool supersample = false;
  std::string gl = "osmesa";

  bool truth = false;  ///< depth, ids, normals, disparity, flow from frame to frame, states
  bool png16 = false;  ///< truth as 16-bit PNG as well
  /// "FROM:TO": also disparity and visibility between these cameras, both ways. Named as their
  /// image files are: PAIR_left, or left where one pair is rendered.
  std::vector<std::string> between;
  std::vector<std::string> views;  ///< cameras of the scene that show it as a whole, once
  PoseTable poses;                 ///< a frame each; with a motion one row, where it starts
  /// The robot moves in time, and its cameras run at their profile's rate. None: still views.
  std::optional<Motion> motion;
  std::vector<FaultSpec> faults;  ///< of head and cameras; a motion's only
};

/// The request as JSON; its camera has the keys of a scenario's `camera:`.
std::string EncodeRequest(const RenderRequest& request);

/// @param name heads messages
/// @throws ScenarioError, FormatError naming the key that is missing, unknown or wrong
RenderRequest DecodeRequest(const std::string& json, const std::string& name);

}  // namespace horopter::scenarios
