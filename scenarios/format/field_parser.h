// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scenarios/format/diagnostics.h"
#include "scenarios/format/field_visitor.h"
#include "scenarios/format/yaml_document.h"

namespace horopter::scenarios {

/// What parsing by a table found besides the values.
struct ParseReport {
  std::vector<Diagnostic> diagnostics;
  /// Where each value stands, by its dotted path ("camera.width"); absent keys have none.
  std::map<std::string, SourceMark> marks;
  /// Paths of the steps ("steps[2]") in which something was wrong.
  std::set<std::string> broken;

  void Add(const SourceMark& mark, std::string message) {
    diagnostics.push_back({mark, std::move(message)});
  }
};

/// Fills the members that `table` lists from a YAML mapping.
///
/// Whatever is wrong (unknown and missing keys, wrong types, values out of range) goes to `report`,
/// all of it; the member then keeps the value it had. `root` may be any node.
void ParseFields(const YamlNode& root, const FieldTable& table, ParseReport& report);

}  // namespace horopter::scenarios
