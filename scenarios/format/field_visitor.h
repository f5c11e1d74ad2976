// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// A key of a file: what it is called, what it means, and in which unit.
struct FieldSpec {
  std::string key;
  std::string unit;  ///< "" when it has none
  std::string doc;   ///< one sentence
  bool required = false;
};

/// Values a number may have. NaN and infinity never pass.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  ///< min itself is excluded

  bool Contains(double value) const;
  /// "from 16 to 4096", "greater than 0", "at most 5", "" when everything passes.
  std::string ToString() const;
};

/// What a text may look like.
struct TextRule {
  std::string pattern;           ///< ECMAScript, on the whole text; "" = anything
  std::string description;       ///< of the pattern, after "must be"
  std::size_t max_length = 200;  ///< code points
};

class FieldVisitor;

/// The fields of a mapping, in the order of the file.
using FieldTable = std::function<void(FieldVisitor&)>;

/// One of the keys that a single-key mapping may have, e.g. a kind of step.
struct Alternative {
  FieldSpec spec;
  bool chosen = false;  ///< the value at hand is this one
  FieldTable table;     ///< makes the value this one, and lists its fields
};

/// A list whose elements are single-key mappings.
struct AlternativeList {
  FieldSpec spec;
  std::size_t size = 0;  ///< elements the value has now
  /// Alternatives of element `index`, which is appended when it is the next one.
  std::function<std::vector<Alternative>(std::size_t index, const SourceMark& mark)> at;
};

/// A list of sentences with a grammar of their own.
struct SentenceList {
  FieldSpec spec;
  std::string pattern;             ///< ECMAScript: every sentence that `add` can accept
  std::vector<std::string> texts;  ///< sentences the value has now
  /// Parses one more; what is wrong with it, or "".
  std::function<std::string(const std::string& text, const SourceMark& mark)> add;
};

/// A mapping that may be missing, which means something else than its defaults.
struct OptionalSection {
  FieldSpec spec;
  bool present = false;  ///< the value at hand has it
  FieldTable table;      ///< makes it present, and lists its fields
};

/// A mapping whose keys are names that the author of the file chooses.
struct NamedMap {
  FieldSpec spec;
  TextRule key_rule;
  std::vector<std::string> keys;  ///< keys the value has now
  std::function<FieldTable(const std::string& key)> table;
};

/// What reads, writes and describes a file by its table of fields.
///
/// A file's layout is a function `void Visit(FieldVisitor&, T&)` that names every field once: key,
/// unit, range, meaning, and the member that holds it; the member's value in a default-constructed
/// T is the default. Parser, JSON Schema and resolved YAML are three visitors over it.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  /// A default outside the range says that leaving the key out means something else than a number.
  virtual void Number(const FieldSpec& spec, const Range& range, double& value) = 0;
  /// Likewise.
  virtual void Whole(const FieldSpec& spec, const Range& range, std::int64_t& value) = 0;
  virtual void Flag(const FieldSpec& spec, bool& value) = 0;
  virtual void Text(const FieldSpec& spec, const TextRule& rule, std::string& value) = 0;
  virtual void Choice(const FieldSpec& spec, const std::vector<std::string>& names,
                      std::string& value) = 0;
  virtual void TextList(const FieldSpec& spec, const TextRule& rule,
                        std::vector<std::string>& values) = 0;
  /// A list of exactly values.size() numbers.
  virtual void Numbers(const FieldSpec& spec, const Range& range, std::span<double> values) = 0;
  virtual void Section(const FieldSpec& spec, const FieldTable& table) = 0;
  virtual void Optional(const OptionalSection& section) = 0;
  virtual void Map(const NamedMap& map) = 0;
  virtual void Alternatives(const AlternativeList& list) = 0;
  virtual void Sentences(const SentenceList& list) = 0;

  /// Any integer member.
  template <typename Integer>
  void Integral(const FieldSpec& spec, const Range& range, Integer& value) {
    auto whole = static_cast<std::int64_t>(value);
    Whole(spec, range, whole);
    value = static_cast<Integer>(whole);
  }
};

}  // namespace horopter::scenarios
