// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/format/fault_spec.h"
#include "scenarios/format/field_visitor.h"

namespace horopter::scenarios {

/// The fields of `faults:`.
AlternativeList FaultList(std::vector<FaultSpec>& faults);

/// Reads a YAML file that holds a scenario's `faults:` and nothing else, as strictly as a scenario.
/// @throws ScenarioError with everything that is wrong with it, or that it cannot be read
std::vector<FaultSpec> ReadFaultsFile(const std::filesystem::path& path);

/// One line that says all of a fault, as a file has it: "zero_off: eye left, pan_deg 2, ...".
std::string DescribeFault(const FaultSpec& fault);

}  // namespace horopter::scenarios
