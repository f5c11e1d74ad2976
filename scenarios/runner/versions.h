// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace horopter::scenarios {

/// "0.1.0 (3308bf3-dirty)": the release, and the commit it was built from, with -dirty behind it
/// when the tree differed from the commit; "0.1.0 (unknown)" when it was built outside git.
std::string Version();

/// Versions of Horopter and of the libraries that results depend on, by name, and as `program` the
/// first digits of the executable's SHA-256, which tells builds of a changed tree apart. Results
/// of two builds may differ unless all of these agree.
std::map<std::string, std::string> LibraryVersions();

}  // namespace horopter::scenarios
