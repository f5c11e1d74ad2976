// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/format/field_visitor.h"

namespace horopter::scenarios {

/// JSON Schema (draft 7) of the mapping that `table` lists: an object without other properties,
/// each with its type, range, default and meaning. Pass a table over default-constructed values,
/// which this changes.
nlohmann::json FieldSchema(const FieldTable& table);

}  // namespace horopter::scenarios
