// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "scenarios/format/scenario_format.h"
#include "scenarios/format/yaml_document.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

/// An independent judge of documents by the published schema.
class SchemaJudge {
 public:
  SchemaJudge() : json_(ScenarioSchema()) {
    const valijson::adapters::NlohmannJsonAdapter adapter(json_);
    valijson::SchemaParser().populateSchema(adapter, schema_);
  }

  /// What the schema has against the document; "" when nothing.
  std::string Faults(const Document& document) {
    const nlohmann::json json = ToJson(ParseYaml(document.text, document.name));
    const valijson::adapters::NlohmannJsonAdapter target(json);
    valijson::ValidationResults results;
    if (validator_.validate(schema_, target, &results)) return "";
    valijson::ValidationResults::Error error;
    std::string faults = "refused";
    while (results.popError(error)) faults += "\n" + error.description;
    return faults;
  }

 private:
  nlohmann::json json_;
  valijson::Schema schema_;
  valijson::Validator validator_;
};

TEST(ScenarioSchema, PublishedFileIsCurrent) {
  const std::string file = HOROPTER_SOURCE_DIR "/scenarios/schema/scenario.schema.json";
  EXPECT_TRUE(Slurp(file) == ScenarioSchema().dump(2) + "\n")
      << "write it anew: horopter schema > scenarios/schema/scenario.schema.json";
}

TEST(ScenarioSchema, AgreesWithTheParserOnGoodAndBadDocuments) {
  SchemaJudge judge;
  for (const Document& d : Corpus("good")) EXPECT_EQ(judge.Faults(d), "") << d.name;
  for (const Document& d : Corpus("bad")) EXPECT_NE(judge.Faults(d), "") << d.name;
}

TEST(ScenarioSchema, LeavesToTheParserWhatTakesSeveralValues) {
  SchemaJudge judge;
  for (const Document& d : Corpus("semantic")) EXPECT_EQ(judge.Faults(d), "") << d.name;
}

TEST(ScenarioSchema, AcceptsResolvedScenarios) {
  SchemaJudge judge;
  for (const Document& d : Corpus("good")) {
    const Document resolved{d.name, ResolvedYaml(ParseScenarioText(d.text, d.name))};
    EXPECT_EQ(judge.Faults(resolved), "") << resolved.text;
  }
}

/// Every field of a section, and of the sections in it, has a sentence and a default, unless that
/// is the robot's.
void ExpectSections(const nlohmann::json& section, const std::string& path) {
  for (const auto& [key, field] : section["properties"].items()) {
    const std::string name = path + key;
    const std::string doc = field.value("description", "");
    EXPECT_FALSE(doc.empty()) << name;
    if (field.contains("properties")) {
      ExpectSections(field, name + ".");
    } else if (!path.empty()) {
      const bool robots = doc.find("left out: the robot's") != std::string::npos;
      EXPECT_NE(field.contains("default"), robots) << name;
    }
  }
}

TEST(ScenarioSchema, EveryFieldSaysWhatItMeans) { ExpectSections(ScenarioSchema(), ""); }

}  // namespace
}  // namespace horopter::scenarios
