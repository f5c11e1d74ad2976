// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenarios/format/field_visitor.h"

namespace horopter::scenarios {

/// The mapping that `table` lists as block-style YAML, every field with its value. Numbers are
/// written with the fewest digits that read back as the same bits. Empty text, maps and lists of
/// alternatives are left out unless required.
std::string WriteFields(const FieldTable& table);

}  // namespace horopter::scenarios
