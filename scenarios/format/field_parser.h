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

  /// A field's place, or the document's when the default stands.
  SourceMark MarkOf(const std::string& path, const SourceMark& root) const {
    const auto found = marks.find(path);
    return found == marks.end() ? root : found->second;
  }

  /// Whether something was wrong in an element of a list, so that its values are not what the file
  /// meant.
  bool IsBroken(const std::string& path) const { return broken.count(path) > 0; }

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
