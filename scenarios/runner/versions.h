// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace horopter::scenarios {

/// Versions of Horopter and of the libraries that results depend on.
std::map<std::string, std::string> LibraryVersions();

}  // namespace horopter::scenarios
