// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/field_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace horopter::scenarios {
namespace {

using Json = nlohmann::json;

// An integer where it is one, so that the schema reads as a person would write it.
Json Plain(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e16) return static_cast<std::int64_t>(value);
  return value;
}

Json Anchored(const std::string& pattern) { return "^(" + pattern + ")$"; }

class SchemaWriter : public FieldVisitor {
 public:
  static Json Of(const FieldTable& table) {
    SchemaWriter writer;
    table(writer);
    Json schema = {{"type", "object"},
                   {"additionalProperties", false},
                   {"properties", std::move(writer.properties_)}};
    if (!writer.required_.empty()) schema["required"] = std::move(writer.required_);
    return schema;
  }

  void Number(const FieldSpec& spec, const Range& range, double& value) override {
    Add(spec, Limited("number", range), range.Contains(value) ? Plain(value) : Json(nullptr));
  }
  void Whole(const FieldSpec& spec, const Range& range, std::int64_t& value) override {
    Add(spec, Limited("integer", range), value);
  }
  void Flag(const FieldSpec& spec, bool& value) override {
    Add(spec, {{"type", "boolean"}}, value);
  }
  void Text(const FieldSpec& spec, const TextRule& rule, std::string& value) override {
    Add(spec, TextSchema(rule), value);
  }
  void Choice(const FieldSpec& spec, const std::vector<std::string>& names,
              std::string& value) override {
    Add(spec, {{"type", "string"}, {"enum", names}}, value);
  }
  void TextList(const FieldSpec& spec, const TextRule& rule,
                std::vector<std::string>& values) override {
    Add(spec, {{"type", "array"}, {"items", TextSchema(rule)}, {"uniqueItems", true}}, values);
  }
  void Numbers(const FieldSpec& spec, const Range& range, std::span<double> values) override {
    Json defaults = Json::array();
    for (double v : values) defaults.push_back(Plain(v));
    Add(spec,
        {{"type", "array"},
         {"items", Limited("number", range)},
         {"minItems", values.size()},
         {"maxItems", values.size()}},
        std::move(defaults));
  }
  void Section(const FieldSpec& spec, const FieldTable& table) override {
    Add(spec, Of(table), nullptr);
  }
  void Optional(const OptionalSection& section) override { Section(section.spec, section.table); }
  void Map(const NamedMap& map) override {
    Json names = TextSchema(map.key_rule);
    names.erase("type");
    Add(map.spec,
        {{"type", "object"},
         {"propertyNames", std::move(names)},
         {"additionalProperties", Of(map.table("name"))}},
        nullptr);
  }
  void Alternatives(const AlternativeList& list) override {
    Json kinds = Json::object();
    for (const Alternative& a : list.at(0, {})) {
      kinds[a.spec.key] = Of(a.table);
      kinds[a.spec.key]["description"] = a.spec.doc;
    }
    const Json item = {{"type", "object"},
                       {"additionalProperties", false},
                       {"minProperties", 1},
                       {"maxProperties", 1},
                       {"properties", std::move(kinds)}};
    Add(list.spec, {{"type", "array"}, {"minItems", 1}, {"items", item}}, nullptr);
  }
  void Sentences(const SentenceList& list) override {
    const Json item = {{"type", "string"}, {"maxLength", 200}, {"pattern", Anchored(list.pattern)}};
    Add(list.spec, {{"type", "array"}, {"items", item}}, nullptr);
  }

 private:
  static Json Limited(const char* type, const Range& range) {
    Json schema = {{"type", type}};
    if (std::isfinite(range.min)) {
      schema[range.above_min ? "exclusiveMinimum" : "minimum"] = Plain(range.min);
    }
    if (std::isfinite(range.max)) schema["maximum"] = Plain(range.max);
    return schema;
  }

  static Json TextSchema(const TextRule& rule) {
    Json schema = {{"type", "string"}, {"maxLength", rule.max_length}};
    if (!rule.pattern.empty()) schema["pattern"] = Anchored(rule.pattern);
    return schema;
  }

  void Add(const FieldSpec& spec, Json schema, Json fallback) {
    schema["description"] = spec.doc + (spec.unit.empty() ? "" : " [" + spec.unit + "]");
    const bool none = fallback.is_null() || (fallback.is_string() && fallback == "");
    if (spec.required) {
      required_.push_back(spec.key);
    } else if (!none) {
      schema["default"] = std::move(fallback);
    }
    properties_[spec.key] = std::move(schema);
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
};

}  // namespace

Json FieldSchema(const FieldTable& table) { return SchemaWriter::Of(table); }

}  // namespace horopter::scenarios
