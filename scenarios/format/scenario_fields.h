// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenarios/format/field_visitor.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// The table of a scenario file: every key, once. The parser, the JSON Schema and the resolved
/// scenario all read it; defaults are those of a default-constructed Scenario.
void Visit(FieldVisitor& v, Scenario& scenario);

/// The table of its `room:`.
void Visit(FieldVisitor& v, RoomSpec& room);

}  // namespace horopter::scenarios
