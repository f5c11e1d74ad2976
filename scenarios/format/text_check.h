// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/format/diagnostics.h"

namespace horopter::scenarios {

/// What is wrong with a file's bytes before any YAML is read: longer than 1 MiB, not UTF-8, control
/// characters, tabs in the indentation. Columns count bytes from 1.
std::vector<Diagnostic> CheckText(const std::string& text, const std::string& file);

/// How many code points the valid UTF-8 `text` has.
std::size_t CodePoints(const std::string& text);

}  // namespace horopter::scenarios
