// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "scenarios/format/field_parser.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// What no single field shows: that scene and robot exist and belong together, that the robot can
/// do the steps, that the bodies to place are there, that the median filter has a middle, that an
/// expectation has a step to judge.
/// @param root place of the document, for what has none of its own
/// @param scenes_dir empty: scene, robot and the robot's limits are passed over
/// @return the robot, when it was looked up and found
std::optional<RobotDescription> CheckScenario(const Scenario& scenario, const SourceMark& root,
                                              const std::filesystem::path& scenes_dir,
                                              ParseReport& report);

}  // namespace horopter::scenarios
