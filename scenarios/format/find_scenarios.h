// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace horopter::scenarios {

/// The scenario files that a command line names: files as they are, folders with every *.yaml below
/// them but those named robot.yaml and those in hidden folders. In the order of the inputs, sorted
/// within a folder, each file once.
/// @throws ScenarioError for every input that does not exist (with the name that was probably
///         meant), and for every folder without scenarios
std::vector<std::filesystem::path> FindScenarios(const std::vector<std::filesystem::path>& inputs);

}  // namespace horopter::scenarios
