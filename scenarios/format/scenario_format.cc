// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_format.h"

#include <nlohmann/json.hpp>

#include "scenarios/format/field_parser.h"
#include "scenarios/format/field_schema.h"
#include "scenarios/format/field_writer.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/robot_defaults.h"
#include "scenarios/format/scenario_checks.h"
#include "scenarios/format/scenario_fields.h"
#include "scenarios/format/yaml_document.h"

namespace horopter::scenarios {
namespace {

FieldTable TableOf(Scenario& scenario) {
  return [&scenario](FieldVisitor& v) { Visit(v, scenario); };
}

}  // namespace

Scenario ParseScenario(const std::filesystem::path& path, const ParseOptions& options) {
  return ParseScenarioText(ReadText(path), path.string(), options);
}

Scenario ParseScenarioText(const std::string& text, const std::string& name,
                           const ParseOptions& options) {
  const YamlNode root = ParseYaml(text, name);
  Scenario scenario;
  scenario.file = name;
  scenario.name = std::filesystem::path(name).stem().string();
  ParseReport report;
  ParseFields(root, TableOf(scenario), report);
  const auto robot = CheckScenario(scenario, root.mark, options.scenes_dir, report);
  ThrowIfAny(std::move(report.diagnostics));
  if (robot) FillFromRobot(*robot, scenario);
  return scenario;
}

std::string ResolvedYaml(const Scenario& scenario) {
  Scenario copy = scenario;  // the writer reads through the same non-const table as the parser
  return WriteFields(TableOf(copy));
}

nlohmann::json ScenarioSchema() {
  Scenario defaults;
  nlohmann::json schema = FieldSchema(TableOf(defaults));
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Horopter scenario";
  return schema;
}

}  // namespace horopter::scenarios
