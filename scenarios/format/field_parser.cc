// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/field_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "scenarios/format/suggest.h"
#include "scenarios/format/text_check.h"

namespace horopter::scenarios {
namespace {

using Kind = YamlNode::Kind;

/// "camera.width = 9: must be ...", the form of every complaint about a value.
std::string Bad(const std::string& path, const YamlNode& node, const std::string& constraint) {
  const char* quote = node.kind == Kind::kText ? "'" : "";
  const std::string value = node.kind == Kind::kText ? Excerpt(node.text) : Describe(node);
  return fmt::format("{} = {}{}{}: must be {}", path, quote, value, quote, constraint);
}

std::string NumberWanted(const Range& range, const FieldSpec& spec, const char* kind) {
  std::string text = kind;
  if (const std::string limits = range.ToString(); !limits.empty()) text += " " + limits;
  return spec.unit.empty() ? text : text + " [" + spec.unit + "]";
}

/// Reads one mapping; a child reads each mapping within.
class MappingParser : public FieldVisitor {
 public:
  MappingParser(const YamlNode& node, std::string path, ParseReport& report)
      : node_(node), path_(std::move(path)), report_(report) {}

  /// Runs the table over the mapping, then complains about the keys it did not name.
  static void Read(const YamlNode& node, const std::string& path, const FieldTable& table,
                   ParseReport& report) {
    if (node.kind != Kind::kMapping) {
      const std::string what = path.empty() ? "the file" : path;
      report.Add(node.mark, what + " is " + Describe(node) +
                                ": must be a mapping (key: value); leave it out for the defaults");
      return;
    }
    MappingParser parser(node, path, report);
    table(parser);
    parser.RefuseUnknownKeys();
  }

  void Number(const FieldSpec& spec, const Range& range, double& value) override {
    if (const YamlNode* node = Find(spec)) ReadNumber(*node, PathOf(spec.key), spec, range, value);
  }

  void Whole(const FieldSpec& spec, const Range& range, std::int64_t& value) override {
    const YamlNode* node = Find(spec);
    if (node == nullptr) return;
    const auto number = node->AsNumber();
    if (!number || *number != std::floor(*number) || !range.Contains(*number)) {
      const std::string quoted = node->kind == Kind::kText ? QuotedNumberHint(*node) : "";
      Complain(*node, PathOf(spec.key), NumberWanted(range, spec, "a whole number") + quoted);
      return;
    }
    value = static_cast<std::int64_t>(*number);
  }

  void Flag(const FieldSpec& spec, bool& value) override {
    const YamlNode* node = Find(spec);
    if (node == nullptr) return;
    if (node->kind != Kind::kBoolean) {
      Complain(*node, PathOf(spec.key), "true or false");
      return;
    }
    value = node->text[0] == 't' || node->text[0] == 'T';
  }

  void Text(const FieldSpec& spec, const TextRule& rule, std::string& value) override {
    if (const YamlNode* node = Find(spec)) ReadText(*node, PathOf(spec.key), rule, value);
  }

  void Choice(const FieldSpec& spec, const std::vector<std::string>& names,
              std::string& value) override {
    const YamlNode* node = Find(spec);
    if (node == nullptr) return;
    std::string text;
    if (!ReadText(*node, PathOf(spec.key), {}, text)) return;
    if (std::find(names.begin(), names.end(), text) == names.end()) {
      std::string list;
      for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
      const auto nearest = NearestName(text, names);
      Complain(*node, PathOf(spec.key),
               (names.size() > 1 ? "one of " : "") + list +
                   (nearest ? "; did you mean '" + *nearest + "'?" : ""));
      return;
    }
    value = text;
  }

  void TextList(const FieldSpec& spec, const TextRule& rule,
                std::vector<std::string>& values) override {
    const YamlNode* node = FindList(spec, "a list of texts, e.g. [a, b]");
    if (node == nullptr) return;
    values.clear();
    for (std::size_t i = 0; i < node->items.size(); ++i) {
      std::string text;
      const std::string path = PathOf(spec.key, i);
      if (!ReadText(node->items[i], path, rule, text)) continue;
      if (std::find(values.begin(), values.end(), text) != values.end()) {
        Complain(node->items[i], path, "different from the ones before it");
      }
      values.push_back(text);
    }
  }

  void Numbers(const FieldSpec& spec, const Range& range, std::span<double> values) override {
    const std::string wanted = "a list of " + std::to_string(values.size()) + " numbers" +
                               (spec.unit.empty() ? "" : " [" + spec.unit + "]");
    const YamlNode* node = FindList(spec, wanted);
    if (node == nullptr) return;
    if (node->items.size() != values.size()) {
      report_.Add(node->mark, PathOf(spec.key) + " has " + std::to_string(node->items.size()) +
                                  " elements: must be " + wanted);
      return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      ReadNumber(node->items[i], PathOf(spec.key, i), spec, range, values[i]);
    }
  }

  void Section(const FieldSpec& spec, const FieldTable& table) override {
    if (const YamlNode* node = Find(spec)) Read(*node, PathOf(spec.key), table, report_);
  }

  void Optional(const OptionalSection& section) override { Section(section.spec, section.table); }

  void Map(const NamedMap& map) override {
    const YamlNode* node = Find(map.spec);
    if (node == nullptr) return;
    if (node->kind != Kind::kMapping) {
      Complain(*node, PathOf(map.spec.key), "a mapping of names (name: {...})");
      return;
    }
    for (const auto& [key, value] : node->entries) {
      std::string name;
      YamlNode as_text = key;  // a key is a name whatever it looks like
      as_text.kind = Kind::kText;
      const std::string path = PathOf(map.spec.key);
      if (!ReadText(as_text, path + ": the name", map.key_rule, name)) continue;
      const std::string child = path + "." + name;
      report_.marks[child] = value.mark;
      Read(value, child, map.table(name), report_);
    }
  }

  void Alternatives(const AlternativeList& list) override {
    const YamlNode* node = FindList(list.spec, "a list (- name: {...})");
    if (node == nullptr) return;
    if (node->items.empty()) Complain(*node, PathOf(list.spec.key), "at least one element");
    for (std::size_t i = 0; i < node->items.size(); ++i) {
      const std::string path = PathOf(list.spec.key, i);
      const std::size_t faults = report_.diagnostics.size();
      ReadAlternative(node->items[i], path, list.at(i, node->items[i].mark));
      if (report_.diagnostics.size() > faults) report_.broken.insert(path);
    }
  }

  void Sentences(const SentenceList& list) override {
    const YamlNode* node = FindList(list.spec, "a list of sentences (- contacts 0)");
    if (node == nullptr) return;
    for (std::size_t i = 0; i < node->items.size(); ++i) {
      std::string text;
      const std::string path = PathOf(list.spec.key, i);
      if (!ReadText(node->items[i], path, {}, text)) continue;
      if (const std::string fault = list.add(text, node->items[i].mark); !fault.empty()) {
        report_.Add(node->items[i].mark, path + " '" + Excerpt(text) + "': " + fault);
      }
    }
  }

 private:
  std::string PathOf(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }
  std::string PathOf(const std::string& key, std::size_t index) const {
    return PathOf(key) + "[" + std::to_string(index) + "]";
  }

  void Complain(const YamlNode& node, const std::string& path, const std::string& constraint) {
    report_.Add(node.mark, Bad(path, node, constraint));
  }

  const YamlNode* Find(const FieldSpec& spec) {
    known_.push_back(spec.key);
    for (const auto& [key, value] : node_.entries) {
      if (key.text != spec.key) continue;
      report_.marks[PathOf(spec.key)] = value.mark;
      return &value;
    }
    if (spec.required) {
      report_.Add(node_.mark, (path_.empty() ? "" : path_ + ": ") + "required key '" + spec.key +
                                  "' is missing: " + spec.doc +
                                  (spec.unit.empty() ? "" : " [" + spec.unit + "]"));
    }
    return nullptr;
  }

  const YamlNode* FindList(const FieldSpec& spec, const std::string& wanted) {
    const YamlNode* node = Find(spec);
    if (node == nullptr || node->kind == Kind::kSequence) return node;
    Complain(*node, PathOf(spec.key), wanted);
    return nullptr;
  }

  void RefuseUnknownKeys() {
    for (const auto& [key, value] : node_.entries) {
      if (std::find(known_.begin(), known_.end(), key.text) != known_.end()) continue;
      report_.Add(key.mark, (path_.empty() ? "" : path_ + ": ") + "unknown key '" +
                                Excerpt(key.text) + "'" + DidYouMean(key.text, known_));
    }
  }

  static std::string QuotedNumberHint(const YamlNode& node) {
    YamlNode plain = node;
    plain.kind = Kind::kFloat;
    return plain.AsNumber() ? "; drop the quotes" : "";
  }

  void ReadNumber(const YamlNode& node, const std::string& path, const FieldSpec& spec,
                  const Range& range, double& value) {
    const auto number = node.AsNumber();
    if (number && range.Contains(*number)) {
      value = *number;
      return;
    }
    const std::string hint = node.kind == Kind::kText ? QuotedNumberHint(node) : "";
    Complain(node, path, NumberWanted(range, spec, "a number") + hint);
  }

  bool ReadText(const YamlNode& node, const std::string& path, const TextRule& rule,
                std::string& value) {
    if (node.kind != Kind::kText) {
      const bool scalar =
          node.kind != Kind::kSequence && node.kind != Kind::kMapping && node.kind != Kind::kNull;
      Complain(node, path, scalar ? "text: put it in quotes" : "text");
      return false;
    }
    if (CodePoints(node.text) > rule.max_length) {
      Complain(node, path, "at most " + std::to_string(rule.max_length) + " characters long");
      return false;
    }
    if (!rule.pattern.empty() && !std::regex_match(node.text, std::regex(rule.pattern))) {
      Complain(node, path, rule.description);
      return false;
    }
    value = node.text;
    return true;
  }

  void ReadAlternative(const YamlNode& node, const std::string& path,
                       const std::vector<Alternative>& alternatives) {
    std::vector<std::string> names;
    for (const Alternative& a : alternatives) names.push_back(a.spec.key);
    if (node.kind != Kind::kMapping || node.entries.size() != 1) {
      report_.Add(node.mark, path + " is " + Describe(node) +
                                 ": must be a mapping with a single key (- " + names.front() +
                                 ": {...})" +
                                 (node.kind == Kind::kMapping ? "; check the indentation" : ""));
      return;
    }
    const auto& [key, value] = node.entries.front();
    for (const Alternative& a : alternatives) {
      if (a.spec.key == key.text) return Read(value, path + "." + key.text, a.table, report_);
    }
    report_.Add(key.mark,
                path + ": unknown kind '" + Excerpt(key.text) + "'" + DidYouMean(key.text, names));
  }

  const YamlNode& node_;
  std::string path_;
  ParseReport& report_;
  std::vector<std::string> known_;
};

}  // namespace

void ParseFields(const YamlNode& root, const FieldTable& table, ParseReport& report) {
  MappingParser::Read(root, "", table, report);
}

}  // namespace horopter::scenarios
