// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/expectation_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "scenarios/format/diagnostics.h"
#include "scenarios/format/metric_registry.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

constexpr const char* kForms =
    "write METRIC OP VALUE [UNIT] (clearance >= 0.05 m) or reached within D m before T s";

constexpr const char* kNumber = R"((?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)";

struct BadSentence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || IsDigit(c);
}
bool IsOperator(char c) { return std::string_view("<>=!").find(c) != std::string_view::npos; }

/// Words, operators and numbers of a sentence, read from left to right.
class Sentence {
 public:
  explicit Sentence(std::string_view text) : rest_(text) { SkipSpace(); }

  bool done() const { return rest_.empty(); }
  char front() const { return rest_.empty() ? '\0' : rest_.front(); }
  /// What is left, for messages.
  std::string rest() const { return Excerpt(std::string(rest_)); }

  std::string Word() { return std::string(Take(Count(IsWord))); }
  std::string Operator() { return std::string(Take(Count(IsOperator))); }
  std::string UnitName() {
    return std::string(Take(front() == '%' ? 1 : Count([](char c) { return IsWord(c); })));
  }

  /// A decimal number, as written.
  std::optional<std::string> NumberText() {
    std::size_t n = front() == '-' || front() == '+' ? 1 : 0;
    std::size_t digits = Digits(&n);
    if (n < rest_.size() && rest_[n] == '.') {
      ++n;
      digits += Digits(&n);
    }
    if (digits == 0) return std::nullopt;
    std::size_t exponent = n;
    if (exponent < rest_.size() && (rest_[exponent] == 'e' || rest_[exponent] == 'E')) {
      ++exponent;
      if (exponent < rest_.size() && (rest_[exponent] == '-' || rest_[exponent] == '+')) ++exponent;
      if (Digits(&exponent) > 0) n = exponent;
    }
    return std::string(Take(n));
  }

 private:
  template <typename Predicate>
  std::size_t Count(Predicate of) const {
    return static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), of) -
                                    rest_.begin());
  }
  std::size_t Digits(std::size_t* n) const {
    const std::size_t start = *n;
    while (*n < rest_.size() && IsDigit(rest_[*n])) ++*n;
    return *n - start;
  }
  std::string_view Take(std::size_t n) {
    const std::string_view taken = rest_.substr(0, n);
    rest_.remove_prefix(n);
    SkipSpace();
    return taken;
  }
  void SkipSpace() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  std::string_view rest_;
};

std::string Fold(const std::string& text) {
  std::string folded;
  for (char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) {
      folded += c;
    } else if (!folded.empty() && folded.back() != ' ') {
      folded += ' ';
    }
  }
  if (folded.ends_with(' ')) folded.pop_back();
  return folded;
}

std::optional<Comparison> ToComparison(const std::string& text) {
  for (Comparison c : {Comparison::kAtMost, Comparison::kAtLeast, Comparison::kLess,
                       Comparison::kGreater, Comparison::kEqual}) {
    if (text == ToString(c)) return c;
  }
  return std::nullopt;
}

double ReadNumber(Sentence& sentence, const Metric& metric) {
  const std::string before = sentence.rest();
  const auto text = sentence.NumberText();
  if (!text) {
    throw BadSentence(before.empty() ? std::string("the value is missing; ") + kForms
                                     : "'" + before + "' is no number; " + kForms);
  }
  if (text->front() == '-' && metric.min >= 0) {
    throw BadSentence(metric.name + " is never negative: drop the sign of " + *text);
  }
  double value = 0;
  const char* begin = text->data() + (text->front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text->data() + text->size(), value);
  if (error != std::errc() || !std::isfinite(value)) {
    throw BadSentence(*text + " is too large or too small for a number");
  }
  if (metric.whole && text->find_first_not_of("+0123456789") != std::string::npos) {
    throw BadSentence(metric.name + " counts: write a whole number instead of " + *text);
  }
  return value;
}

std::string UnitHint(const Metric& metric) {
  const auto names = UnitNamesFor(metric);
  if (names.empty()) return metric.name + " has no unit: drop it";
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return metric.name + " is written in " + list;
}

double InMetricUnit(double value, const std::string& unit, const Metric& metric) {
  if (const auto converted = ToMetricUnit(value, unit, metric)) return *converted;
  std::vector<std::string> known;
  for (const Unit& u : Units()) known.push_back(u.name);
  const bool exists = std::find(known.begin(), known.end(), unit) != known.end();
  const auto nearest = NearestName(unit, UnitNamesFor(metric));
  throw BadSentence(
      (exists ? "unit '" + unit + "' does not fit: " : "unknown unit '" + unit + "': ") +
      UnitHint(metric) + (nearest ? "; did you mean '" + *nearest + "'?" : ""));
}

void RequireEnd(const Sentence& sentence) {
  if (!sentence.done()) {
    throw BadSentence("'" + sentence.rest() + "' does not belong there; " + kForms);
  }
}

/// "within D m before T s", after "reached".
void ReadReached(Sentence& sentence, Expectation& expectation) {
  const Metric& distance = *FindMetric("reached");
  const Metric& time = *FindMetric("time_to_goal");
  const auto length = [&](const Metric& metric) {
    const double value = ReadNumber(sentence, metric);
    const std::string unit = sentence.UnitName();
    if (unit.empty() || unit == "before") {
      throw BadSentence("the unit is missing: write reached within 0.15 m before 60 s");
    }
    return InMetricUnit(value, unit, metric);
  };
  expectation.limit = length(distance);
  if (const std::string word = sentence.Word(); word != "before") {
    throw BadSentence("'" + word +
                      "' where 'before' must stand: reached within 0.15 m before 60 s");
  }
  expectation.before_s = length(time);
}

void ReadComparison(Sentence& sentence, const Metric& metric, Expectation& expectation) {
  expectation.comparison = Comparison::kEqual;
  if (IsOperator(sentence.front())) {
    const std::string op = sentence.Operator();
    const auto comparison = ToComparison(op);
    if (!comparison) {
      throw BadSentence("unknown comparison '" + op + "': write <=, >=, <, > or ==");
    }
    expectation.comparison = *comparison;
  }
  const double value = ReadNumber(sentence, metric);
  expectation.limit = InMetricUnit(value, sentence.UnitName(), metric);
}

Expectation Read(const std::string& text) {
  Sentence sentence(text);
  Expectation expectation;
  expectation.text = text;
  expectation.metric = sentence.Word();
  if (expectation.metric.empty()) throw BadSentence(std::string("no metric; ") + kForms);
  const Metric* metric = FindMetric(expectation.metric);
  if (metric == nullptr) {
    throw BadSentence("unknown metric '" + Excerpt(expectation.metric) + "'" +
                      DidYouMean(expectation.metric, MetricNames()));
  }
  expectation.unit = metric->unit;
  Sentence ahead = sentence;
  if (metric->name == "reached" && ahead.Word() == "within") {
    sentence = ahead;
    ReadReached(sentence, expectation);
  } else {
    ReadComparison(sentence, *metric, expectation);
  }
  RequireEnd(sentence);
  if (expectation.limit > metric->max) {
    throw BadSentence(fmt::format("{} is at most {}: write a fraction or a percentage (40 %)",
                                  metric->name, metric->max));
  }
  return expectation;
}

std::string Escaped(const std::string& name) {
  std::string escaped;
  for (char c : name) escaped += c == '.' ? "\\." : std::string(1, c);
  return escaped;
}

std::string UnitPattern(const Metric& metric) {
  std::string pattern;
  for (const std::string& name : UnitNamesFor(metric))
    pattern += (pattern.empty() ? "" : "|") + name;
  return pattern;
}

std::string ValuePattern(const Metric& metric) {
  if (metric.whole) return R"(\+?\d+)";
  return (metric.min < 0 ? "[-+]?" : "\\+?") + std::string(kNumber);
}

}  // namespace

const char* ToString(Comparison comparison) {
  switch (comparison) {
    case Comparison::kAtMost:
      return "<=";
    case Comparison::kAtLeast:
      return ">=";
    case Comparison::kLess:
      return "<";
    case Comparison::kGreater:
      return ">";
    case Comparison::kEqual:
      return "==";
  }
  return "?";
}

std::variant<Expectation, std::string> ParseExpectation(const std::string& sentence) {
  try {
    return Read(Fold(sentence));
  } catch (const BadSentence& bad) {
    return std::string(bad.what());
  }
}

std::string ExpectationPattern() {
  const Metric& distance = *FindMetric("reached");
  const Metric& time = *FindMetric("time_to_goal");
  std::string pattern = fmt::format(
      R"(\s*reached\s+within(?:\s+|\s*(?=\+)){0}\s*(?:{1})\s+before(?:\s+|\s*(?=\+)){0}\s*(?:{2})\s*)",
      "\\+?" + std::string(kNumber), UnitPattern(distance), UnitPattern(time));
  for (const Metric& metric : Metrics()) {
    const std::string units = UnitPattern(metric);
    pattern += fmt::format(R"(|\s*{}(?:\s*(?:<=|>=|==|<|>)\s*|\s*(?=[-+])|\s+){}{}\s*)",
                           Escaped(metric.name), ValuePattern(metric),
                           units.empty() ? "" : "(?:\\s*(?:" + units + "))?");
  }
  return pattern;
}

}  // namespace horopter::scenarios
