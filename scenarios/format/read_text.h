// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace horopter::scenarios {

/// Content of a file, at most a little over 1 MiB of it.
/// @throws ScenarioError that says why it cannot be read, with the name that was probably meant
std::string ReadText(const std::filesystem::path& path);

/// "; did you mean 'x'?" among the names beside a path that does not exist, or "".
std::string SiblingHint(const std::filesystem::path& path);

}  // namespace horopter::scenarios
