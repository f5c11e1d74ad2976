// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/format/diagnostics.h"

namespace horopter::scenarios {

/// A value of a YAML file and where it stands.
///
/// Plain scalars have the types of YAML 1.2's core schema, so `yes` and `0777` are text and a
/// number, not a truth value and an octal; quoted ones are text.
struct YamlNode {
  enum class Kind { kNull, kBoolean, kInteger, kFloat, kText, kSequence, kMapping };

  Kind kind = Kind::kNull;
  SourceMark mark;
  std::string text;                                    ///< a scalar's, as written but for quotes
  std::vector<YamlNode> items;                         ///< kSequence
  std::vector<std::pair<YamlNode, YamlNode>> entries;  ///< kMapping, in file order

  /// Nothing unless the node is an integer or a float that a double holds finitely.
  std::optional<double> AsNumber() const;
};

/// "a mapping", "text" ...: what a node is, for messages.
std::string Describe(const YamlNode& node);

/// Reads the one document of a YAML text.
///
/// Refused, each with its place: syntax errors, tabs in the indentation, bytes that are not UTF-8,
/// control characters, quotes that never close, a second document, no document at all, anchors,
/// aliases and tags (no scenario needs them, and expanding them is how a short file becomes a huge
/// one), duplicate keys, keys that are not scalars, nesting deeper than 32, more than 1 MiB.
/// @param file how messages name the text
/// @throws ScenarioError; syntax errors come alone, duplicate keys all together
YamlNode ParseYaml(const std::string& text, const std::string& file);

/// The document as JSON, for validators. Numbers that JSON cannot hold become text.
nlohmann::json ToJson(const YamlNode& node);

}  // namespace horopter::scenarios
