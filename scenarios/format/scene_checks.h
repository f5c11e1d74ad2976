// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenarios/format/field_parser.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// What a scenario asks of its scene: that the bodies to place are there, may be moved and leave
/// the robot its start, that goals are on the floor, that there is a board where one is judged,
/// that the robot's cameras are in it. Passed over when the scene is no XML.
/// @param mjcf the scene's file
/// @param root place of the document, for what has none of its own
void CheckAgainstScene(const Scenario& scenario, const RobotDescription& robot,
                       const std::filesystem::path& mjcf, const SourceMark& root,
                       ParseReport& report);

}  // namespace horopter::scenarios
