// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/yaml_document.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "scenarios/format/text_check.h"

namespace horopter::scenarios {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr double kLargestExactInteger = 9007199254740991.0;  // 2^53 - 1

bool IsDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// [-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?
bool IsFloat(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view exponent = text.substr(e + 1);
    if (exponent.starts_with('-') || exponent.starts_with('+')) exponent.remove_prefix(1);
    if (!IsDigits(exponent)) return false;
    text = text.substr(0, e);
  }
  const auto dot = text.find('.');
  if (dot == std::string_view::npos) return IsDigits(text);
  const std::string_view whole = text.substr(0, dot);
  const std::string_view fraction = text.substr(dot + 1);
  return (IsDigits(whole) && (fraction.empty() || IsDigits(fraction))) ||
         (whole.empty() && IsDigits(fraction));
}

YamlNode::Kind PlainKind(std::string_view text) {
  using Kind = YamlNode::Kind;
  for (const char* null : {"", "~", "null", "Null", "NULL"}) {
    if (text == null) return Kind::kNull;
  }
  for (const char* boolean : {"true", "True", "TRUE", "false", "False", "FALSE"}) {
    if (text == boolean) return Kind::kBoolean;
  }
  const bool sign = text.starts_with('-') || text.starts_with('+');
  if (IsDigits(text.substr(sign ? 1 : 0))) return Kind::kInteger;
  return IsFloat(text) ? Kind::kFloat : Kind::kText;
}

/// Builds the tree from yaml-cpp's events, so that nothing is expanded, merged or overwritten.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  YamlNode Take() && { return std::move(root_); }
  std::vector<Diagnostic> TakeDuplicates() && { return std::move(duplicates_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    RefuseAnchor(mark, anchor);
    Add(Make(YamlNode::Kind::kNull, mark));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    Refuse(mark, "aliases (*name) are not part of the format: write the value out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    RefuseAnchor(mark, anchor);
    RefuseTag(mark, tag);
    const bool plain = tag == "?";
    if (!plain) RequireClosedQuote(mark);
    YamlNode node = Make(plain ? PlainKind(value) : YamlNode::Kind::kText, mark);
    node.text = value;
    Add(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Open(YamlNode::Kind::kSequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { Close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Open(YamlNode::Kind::kMapping, mark, tag, anchor);
  }
  void OnMapEnd() override { Close(); }

 private:
  struct OpenNode {
    YamlNode node;
    std::optional<YamlNode> key;             ///< read, its value still to come
    std::map<std::string, SourceMark> seen;  ///< keys
  };

  SourceMark Place(const YAML::Mark& mark) const { return {file_, mark.line + 1, mark.column + 1}; }

  [[noreturn]] void Refuse(const YAML::Mark& mark, std::string message) const {
    Fail(Place(mark), std::move(message));
  }

  void RefuseAnchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) Refuse(mark, "anchors (&name) are not part of the format: drop it");
  }

  void RefuseTag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") {
      Refuse(mark, "tags (!...) are not part of the format: drop it");
    }
  }

  // yaml-cpp 0.7 takes the end of the file for the closing quote.
  void RequireClosedQuote(const YAML::Mark& mark) const {
    const auto start = static_cast<std::size_t>(mark.pos);
    if (mark.pos < 0 || start >= text_.size()) return;
    const char quote = text_[start];
    if (quote != '"' && quote != '\'') return;
    for (std::size_t i = start + 1; i < text_.size(); ++i) {
      if (quote == '"' && text_[i] == '\\') {
        ++i;
      } else if (text_[i] == quote) {
        return;
      }
    }
    Refuse(mark, "this quote is never closed: add the closing one");
  }

  YamlNode Make(YamlNode::Kind kind, const YAML::Mark& mark) const {
    YamlNode node;
    node.kind = kind;
    node.mark = Place(mark);
    return node;
  }

  void Open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    RefuseAnchor(mark, anchor);
    RefuseTag(mark, tag);
    if (open_.size() >= kMaxDepth) Refuse(mark, "nested deeper than any scenario: flatten this");
    open_.push_back({Make(kind, mark), std::nullopt, {}});
  }

  void Close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    Add(std::move(node));
  }

  void Add(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    OpenNode& parent = open_.back();
    if (parent.node.kind == YamlNode::Kind::kSequence) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.key) {
      TakeKey(parent, std::move(node));
    } else {
      parent.node.entries.emplace_back(std::move(*parent.key), std::move(node));
      parent.key.reset();
    }
  }

  void TakeKey(OpenNode& parent, YamlNode key) {
    if (key.kind == YamlNode::Kind::kSequence || key.kind == YamlNode::Kind::kMapping) {
      Fail(key.mark, "a key must be a single word, not " + Describe(key));
    }
    const auto [first, fresh] = parent.seen.emplace(key.text, key.mark);
    if (!fresh) {
      duplicates_.push_back(
          {key.mark, "key '" + Excerpt(key.text) + "' stands twice, first in line " +
                         std::to_string(first->second.line) + ": keep one of them"});
    }
    parent.key = std::move(key);
  }

  const std::string& text_;
  const std::string& file_;
  YamlNode root_;
  std::vector<OpenNode> open_;
  std::vector<Diagnostic> duplicates_;
};

[[noreturn]] void FailOnSyntax(const YAML::Exception& error, const std::string& file) {
  const bool placed = error.mark.line >= 0;
  Fail({file, placed ? error.mark.line + 1 : 1, placed ? error.mark.column + 1 : 1},
       "not valid YAML: " + error.msg + "; check indentation, brackets and quotes here");
}

}  // namespace

std::optional<double> YamlNode::AsNumber() const {
  if (kind != Kind::kInteger && kind != Kind::kFloat) return std::nullopt;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string Describe(const YamlNode& node) {
  using Kind = YamlNode::Kind;
  switch (node.kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kSequence:
      return "a list";
    case Kind::kMapping:
      return "a mapping";
    case Kind::kText:
      return "the text '" + Excerpt(node.text) + "'";
    case Kind::kBoolean:
    case Kind::kInteger:
    case Kind::kFloat:
      break;
  }
  return Excerpt(node.text);
}

YamlNode ParseYaml(const std::string& text, const std::string& file) {
  ThrowIfAny(CheckText(text, file));
  std::istringstream stream(text);
  TreeBuilder builder(text, file);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) {
      Fail({file, 1, 1}, "the file is empty: a scenario has at least scene, steps and expect");
    }
    TreeBuilder second(text, file);
    if (parser.HandleNextDocument(second)) {
      const YamlNode extra = std::move(second).Take();
      Fail(extra.mark,
           "a second document starts here: one file, one document; check the "
           "indentation or drop the '---'");
    }
  } catch (const YAML::Exception& error) {
    FailOnSyntax(error, file);
  }
  YamlNode root = std::move(builder).Take();
  ThrowIfAny(std::move(builder).TakeDuplicates());
  return root;
}

nlohmann::json ToJson(const YamlNode& node) {
  using Kind = YamlNode::Kind;
  switch (node.kind) {
    case Kind::kNull:
      return nullptr;
    case Kind::kBoolean:
      return node.text[0] == 't' || node.text[0] == 'T';
    case Kind::kText:
      return node.text;
    case Kind::kInteger:
    case Kind::kFloat: {
      const auto number = node.AsNumber();
      if (!number) return node.text;
      // JSON Schema counts 3.0 as an integer; validators go by the JSON type.
      if (*number == std::floor(*number) && std::abs(*number) <= kLargestExactInteger) {
        return static_cast<std::int64_t>(*number);
      }
      return *number;
    }
    case Kind::kSequence: {
      nlohmann::json list = nlohmann::json::array();
      for (const YamlNode& item : node.items) list.push_back(ToJson(item));
      return list;
    }
    case Kind::kMapping:
      break;
  }
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [key, value] : node.entries) object[key.text] = ToJson(value);
  return object;
}

}  // namespace horopter::scenarios
