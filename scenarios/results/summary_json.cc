// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/summary_json.h"

#include <fmt/format.h>

#include <cmath>

#include "scenarios/results/results_error.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json OrNull(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(CleanText(text));
}

Json ToJson(const ExpectationResult& expectation) {
  return {{"name", CleanText(expectation.name)},      {"value", OrNull(expectation.value)},
          {"limit", OrNull(expectation.limit)},       {"unit", CleanText(expectation.unit)},
          {"outcome", ToString(expectation.outcome)}, {"metric", OrNull(expectation.metric)},
          {"detail", OrNull(expectation.detail)}};
}

Json ToJson(const StageTiming& timing) {
  Json json = {
      {"median", OrNull(timing.median_ms)}, {"p95", OrNull(timing.p95_ms)}, {"n", timing.n}};
  if (timing.modelled_ms) json["modelled"] = *timing.modelled_ms;
  return json;
}

Json ToJson(const Machine& machine) {
  return {{"processor", OrNull(machine.processor)},
          {"cores", machine.cores > 0 ? Json(machine.cores) : Json(nullptr)},
          {"load", OrNull(machine.load)}};
}

Json ToJson(const hardware::Pose2& pose) {
  return {{"x_m", pose.x_m}, {"y_m", pose.y_m}, {"heading_rad", pose.heading_rad}};
}

Json ToJson(const std::vector<std::pair<double, double>>& points) {
  Json list = Json::array();
  for (const auto& [x, y] : points) list.push_back(Json::array({x, y}));
  return list;
}

std::string Dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Reads one run, knowing where in the text it is.
class RunReader {
 public:
  RunReader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) Fail("", "must be an object");
  }

  RunSummary Read() const {
    RunSummary run;
    run.scenario = Required<std::string>(json_, "scenario", "a text");
    run.description = Text("description");
    run.file = Text("file");
    run.seed = ReadSeed();
    run.backend = Required<std::string>(json_, "backend", "a text");
    run.faults = ReadFaults();
    run.outcome = ReadOutcome<Outcome>(
        json_, "outcome",
        {Outcome::kPassed, Outcome::kFailed, Outcome::kError, Outcome::kIncomplete});
    run.error = Text("error");
    run.expectations = ReadExpectations();
    run.metrics = ReadMetrics();
    run.image_hash = Text("image_hash");
    run.decision_hash = Text("decision_hash");
    run.timing_ms = ReadTiming();
    run.sim_s = Number(json_, "sim_s");
    run.wall_s = Number(json_, "wall_s");
    run.gl_renderer = Text("gl_renderer");
    run.machine = ReadMachine();
    run.versions = ReadVersions();
    run.directory = Text("directory");
    return run;
  }

 private:
  [[noreturn]] void Fail(const std::string& key, const std::string& what) const {
    const std::string dot = place_.empty() || key.empty() ? "" : ".";
    throw ResultsError(fmt::format("{}{}{}: {}", place_, dot, key, what));
  }

  static const Json& At(const Json& object, const std::string& key) {
    static const Json null;
    const auto found = object.find(key);
    return found == object.end() ? null : *found;
  }

  template <typename T>
  T Required(const Json& object, const std::string& key, const char* kind) const {
    const Json& value = At(object, key);
    if (value.is_null()) Fail(key, fmt::format("is missing: must be {}", kind));
    try {
      return value.get<T>();
    } catch (const Json::exception&) {
      Fail(key, fmt::format("is {}: must be {}", value.dump(), kind));
    }
  }

  std::string Text(const std::string& key) const {
    return At(json_, key).is_null() ? "" : Required<std::string>(json_, key, "a text or null");
  }

  std::optional<double> Number(const Json& object, const std::string& key) const {
    const Json& value = At(object, key);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number()) Fail(key, fmt::format("is {}: must be a number or null", value.dump()));
    return value.get<double>();
  }

  /// The object under a key, empty when absent.
  const Json& Object(const std::string& key) const {
    static const Json empty = Json::object();
    const Json& value = At(json_, key);
    if (value.is_null()) return empty;
    if (!value.is_object()) Fail(key, "must be an object");
    return value;
  }

  template <typename T>
  T ReadOutcome(const Json& object, const std::string& key, std::initializer_list<T> all) const {
    const auto text = Required<std::string>(object, key, "an outcome");
    for (const T outcome : all) {
      if (ToString(outcome) == text) return outcome;
    }
    Fail(key, fmt::format("is \"{}\", which is no outcome", text));
  }

  std::uint64_t ReadSeed() const {
    const Json& seed = At(json_, "seed");
    if (!seed.is_number_unsigned()) Fail("seed", "must be an integer from 0");
    return seed.get<std::uint64_t>();
  }

  std::vector<ExpectationResult> ReadExpectations() const {
    const Json& list = At(json_, "expectations");
    if (!list.is_array()) Fail("expectations", "must be a list");
    std::vector<ExpectationResult> expectations;
    for (const Json& item : list) {
      const RunReader reader(item, fmt::format("{}{}expectations[{}]", place_,
                                               place_.empty() ? "" : ".", expectations.size()));
      ExpectationResult& e = expectations.emplace_back();
      e.name = reader.Required<std::string>(item, "name", "a text");
      e.value = reader.Number(item, "value");
      e.limit = reader.Number(item, "limit").value_or(std::nan(""));
      e.unit = reader.Text("unit");
      e.outcome = reader.ReadOutcome<ExpectationOutcome>(
          item, "outcome",
          {ExpectationOutcome::kPassed, ExpectationOutcome::kFailed,
           ExpectationOutcome::kNotApplicable});
      e.metric = reader.Text("metric");
      e.detail = reader.Text("detail");
    }
    return expectations;
  }

  std::vector<std::string> ReadFaults() const {
    const Json& list = At(json_, "faults");
    if (list.is_null()) return {};
    if (!list.is_array()) Fail("faults", "must be a list");
    std::vector<std::string> faults;
    for (const Json& item : list) {
      if (!item.is_string()) Fail("faults", "must be a list of texts");
      faults.push_back(item);
    }
    return faults;
  }

  std::map<std::string, double> ReadMetrics() const {
    std::map<std::string, double> metrics;
    for (const auto& [name, value] : Object("metrics").items()) {
      if (value.is_null()) continue;
      if (!value.is_number()) Fail("metrics." + name, "must be a number or null");
      metrics[name] = value.get<double>();
    }
    return metrics;
  }

  std::map<std::string, StageTiming> ReadTiming() const {
    std::map<std::string, StageTiming> timing;
    for (const auto& [stage, value] : Object("timing_ms").items()) {
      const RunReader reader(value, place_ + (place_.empty() ? "" : ".") + "timing_ms." + stage);
      timing[stage] = {reader.Number(value, "median"), reader.Number(value, "p95"),
                       reader.Required<int>(value, "n", "an integer"),
                       reader.Number(value, "modelled")};
    }
    return timing;
  }

  Machine ReadMachine() const {
    const Json& object = Object("machine");
    const RunReader reader(object, place_ + (place_.empty() ? "" : ".") + "machine");
    const Json& cores = At(object, "cores");
    return {reader.Text("processor"),
            cores.is_null() ? 0 : reader.Required<unsigned>(object, "cores", "an integer"),
            reader.Number(object, "load")};
  }

  std::map<std::string, std::string> ReadVersions() const {
    std::map<std::string, std::string> versions;
    for (const auto& [name, value] : Object("versions").items()) {
      if (!value.is_string()) Fail("versions." + name, "must be a text");
      versions[name] = value.get<std::string>();
    }
    return versions;
  }

  const Json& json_;
  std::string place_;
};

}  // namespace

nlohmann::ordered_json ToJson(const RunSummary& run) {
  Json expectations = Json::array();
  for (const ExpectationResult& e : run.expectations) expectations.push_back(ToJson(e));
  Json faults = Json::array();
  for (const std::string& fault : run.faults) faults.push_back(CleanText(fault));
  Json metrics = Json::object();
  for (const auto& [name, value] : run.metrics) metrics[CleanText(name)] = OrNull(value);
  Json timing = Json::object();
  for (const auto& [stage, t] : run.timing_ms) timing[CleanText(stage)] = ToJson(t);
  Json versions = Json::object();
  for (const auto& [name, version] : run.versions) versions[CleanText(name)] = CleanText(version);
  return {{"scenario", CleanText(run.scenario)},
          {"description", OrNull(run.description)},
          {"file", OrNull(run.file)},
          {"directory", OrNull(run.directory)},
          {"seed", run.seed},
          {"backend", CleanText(run.backend)},
          {"faults", std::move(faults)},
          {"outcome", ToString(run.outcome)},
          {"error", OrNull(run.error)},
          {"expectations", std::move(expectations)},
          {"metrics", std::move(metrics)},
          {"image_hash", OrNull(run.image_hash)},
          {"decision_hash", OrNull(run.decision_hash)},
          {"timing_ms", std::move(timing)},
          {"sim_s", OrNull(run.sim_s)},
          {"wall_s", OrNull(run.wall_s)},
          {"gl_renderer", OrNull(run.gl_renderer)},
          {"machine", ToJson(run.machine)},
          {"versions", std::move(versions)}};
}

nlohmann::ordered_json ToJson(const PlanRecord& plan) {
  Json shapes = Json::array();
  for (const PlanShape& shape : plan.shapes) {
    shapes.push_back({{"name", CleanText(shape.name)},
                      {"kind", CleanText(shape.kind)},
                      {"outline_m", ToJson(shape.outline_m)}});
  }
  Json path = Json::array();
  for (const PathPoint& point : plan.path) {
    path.push_back({{"t_s", point.t_s},
                    {"odometry", ToJson(point.odometry)},
                    {"true_pose", point.true_pose ? ToJson(*point.true_pose) : Json(nullptr)}});
  }
  return {{"frame", "robot's start: x forward, y left"},
          {"shapes", std::move(shapes)},
          {"goals_m", ToJson(plan.goals_m)},
          {"waypoints_m", ToJson(plan.waypoints_m)},
          {"robot_radius_m", plan.robot_radius_m},
          {"path", std::move(path)}};
}

std::string RunSummaryText(const RunSummary& run) { return Dump(ToJson(run)); }

std::string SuiteSummaryText(const std::vector<RunSummary>& runs) {
  Json list = Json::array();
  for (const RunSummary& run : runs) list.push_back(ToJson(run));
  Json suite = Json::object();
  suite["runs"] = std::move(list);
  return Dump(suite);
}

std::vector<RunSummary> ParseSummaryText(std::string_view text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw ResultsError(fmt::format("is not JSON (at byte {})", error.byte));
  }
  if (!json.is_object()) throw ResultsError("is not a summary: must be an object");
  if (!json.contains("runs")) return {RunReader(json, "").Read()};
  if (!json["runs"].is_array()) throw ResultsError("runs: must be a list");
  std::vector<RunSummary> runs;
  for (const Json& item : json["runs"]) {
    runs.push_back(RunReader(item, fmt::format("runs[{}]", runs.size())).Read());
  }
  return runs;
}

}  // namespace horopter::scenarios
