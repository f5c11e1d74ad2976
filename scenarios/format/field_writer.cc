// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/field_writer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace horopter::scenarios {
namespace {

/// Every JSON string is a double-quoted YAML scalar.
std::string Quoted(const std::string& text) { return nlohmann::json(text).dump(); }

class YamlWriter : public FieldVisitor {
 public:
  static std::string Write(const FieldTable& table, int indent) {
    YamlWriter writer(indent);
    table(writer);
    return writer.text_;
  }

  void Number(const FieldSpec& spec, const Range& range, double& value) override {
    if (range.Contains(value)) Line(spec.key, fmt::format("{}", value));
  }
  void Whole(const FieldSpec& spec, const Range& range, std::int64_t& value) override {
    if (range.Contains(static_cast<double>(value))) Line(spec.key, fmt::format("{}", value));
  }
  void Flag(const FieldSpec& spec, bool& value) override {
    Line(spec.key, value ? "true" : "false");
  }
  void Text(const FieldSpec& spec, const TextRule&, std::string& value) override {
    if (!value.empty() || spec.required) Line(spec.key, Quoted(value));
  }
  void Choice(const FieldSpec& spec, const std::vector<std::string>&, std::string& value) override {
    Line(spec.key, Quoted(value));
  }
  void TextList(const FieldSpec& spec, const TextRule&, std::vector<std::string>& values) override {
    std::string list;
    for (const std::string& v : values) list += (list.empty() ? "" : ", ") + Quoted(v);
    Line(spec.key, "[" + list + "]");
  }
  void Numbers(const FieldSpec& spec, const Range&, std::span<double> values) override {
    Line(spec.key, fmt::format("[{}]", fmt::join(values, ", ")));
  }
  void Section(const FieldSpec& spec, const FieldTable& table) override {
    const std::string body = Write(table, indent_ + 2);
    Line(spec.key, body.empty() ? "{}" : "");
    text_ += body;
  }
  void Optional(const OptionalSection& section) override {
    if (section.present) Section(section.spec, section.table);
  }
  void Map(const NamedMap& map) override {
    if (map.keys.empty()) return;
    Line(map.spec.key, "");
    for (const std::string& key : map.keys) {
      text_ += fmt::format("{:{}}{}:\n", "", indent_ + 2, Quoted(key));
      text_ += Write(map.table(key), indent_ + 4);
    }
  }
  void Alternatives(const AlternativeList& list) override {
    if (list.size == 0 && !list.spec.required) return;
    Line(list.spec.key, list.size == 0 ? "[]" : "");
    for (std::size_t i = 0; i < list.size; ++i) {
      for (const Alternative& a : list.at(i, {})) {
        if (!a.chosen) continue;
        text_ += fmt::format("{:{}}- {}:\n", "", indent_ + 2, a.spec.key);
        text_ += Write(a.table, indent_ + 6);
      }
    }
  }
  void Sentences(const SentenceList& list) override {
    Line(list.spec.key, list.texts.empty() ? "[]" : "");
    for (const std::string& text : list.texts) {
      text_ += fmt::format("{:{}}- {}\n", "", indent_ + 2, Quoted(text));
    }
  }

 private:
  explicit YamlWriter(int indent) : indent_(indent) {}

  void Line(const std::string& key, const std::string& value) {
    text_ += fmt::format("{:{}}{}:{}{}\n", "", indent_, key, value.empty() ? "" : " ", value);
  }

  int indent_;
  std::string text_;
};

}  // namespace

std::string WriteFields(const FieldTable& table) { return YamlWriter::Write(table, 0); }

}  // namespace horopter::scenarios
