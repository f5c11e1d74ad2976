// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "scenarios/format/fault_fields.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

constexpr const char* kMinimal =
    "scene: koala/room.xml\nsteps:\n  - wait: {duration_s: 1}\nexpect: []\n";

std::string Faults(const std::string& text) {
  try {
    ParseScenarioText(text, "s.yaml");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

/// Without the places in the file, which a resolved scenario does not share.
Scenario Unplaced(Scenario scenario) {
  for (Step& step : scenario.steps) step.mark = {};
  for (FaultSpec& fault : scenario.faults) fault.mark = {};
  for (Expectation& expectation : scenario.expect) expectation.mark = {};
  return scenario;
}

void ExpectRoundTrip(const Scenario& scenario) {
  const std::string yaml = ResolvedYaml(scenario);
  try {
    const Scenario again = ParseScenarioText(yaml, scenario.file.string());
    EXPECT_EQ(Unplaced(again), Unplaced(scenario)) << yaml;
    EXPECT_EQ(ResolvedYaml(again), yaml);
  } catch (const ScenarioError& error) {
    ADD_FAILURE() << error.what() << "\n" << yaml;
  }
}

TEST(ScenarioFormat, DefaultsAreThoseOfTheStruct) {
  const Scenario scenario = ParseScenarioText(kMinimal, "dir/my_run.yaml");
  EXPECT_EQ(scenario.name, "my_run");
  EXPECT_EQ(scenario.camera, CameraSpec{});
  EXPECT_EQ(scenario.vision, VisionSpec{});
  EXPECT_EQ(scenario.navigation, NavigationSpec{});
  EXPECT_EQ(scenario.seed, Scenario{}.seed);
}

TEST(ScenarioFormat, EveryKeyArrives) {
  const Scenario s = ParseScenarioText(Corpus("good").front().text, "everything.yaml");
  EXPECT_EQ(s.name, "everything at once");
  EXPECT_EQ(s.seed, 9007199254740991u);
  EXPECT_FALSE(s.variation.textures);
  EXPECT_EQ(s.bodies.at("board").position_m, Eigen::Vector3d(1, -0.25, 0.3));
  EXPECT_EQ(s.camera.height, 480);
  EXPECT_EQ(s.navigation.cruise_speed_m_s, 0.1);
  ASSERT_EQ(s.steps.size(), 6u);
  EXPECT_EQ(std::get<FixateStep>(s.steps[0].action).hold_s, 2);
  EXPECT_EQ(std::get<LookAtStep>(s.steps[1].action).target_m.y(), 3);
  EXPECT_EQ(std::get<SaccadeStep>(s.steps[3].action), SaccadeStep{});
  EXPECT_EQ(std::get<GotoStep>(s.steps[4].action).goal_m, Eigen::Vector2d(3, -0.5));
  EXPECT_EQ(s.steps[4].mark.ToString(), "everything.yaml:23:5");
  ASSERT_TRUE(s.room.has_value());
  EXPECT_EQ(*s.room, (RoomSpec{2, 5, "blocked", 0.3, "lamps", false, false}));
  ASSERT_EQ(s.faults.size(), 11u);
  EXPECT_EQ(std::get<StuckAxisFault>(s.faults[3].kind).axis, "right_pan");
  EXPECT_EQ(s.faults[3].from_s, 3);
  EXPECT_EQ(s.faults[3].until_s, 8.5);
  EXPECT_EQ(std::get<ZeroOffFault>(s.faults[4].kind), (ZeroOffFault{"left", 2, -1}));
  EXPECT_EQ(s.faults[10].until_s, FaultSpec::kForEver_s);
}

TEST(ScenarioFormat, WithoutRoomAndFaultsThereAreNone) {
  const Scenario plain = ParseScenarioText(kMinimal, "s.yaml");
  EXPECT_FALSE(plain.room.has_value());
  EXPECT_TRUE(plain.faults.empty());
  const std::string resolved = ResolvedYaml(plain);
  EXPECT_EQ(resolved.find("room:"), std::string::npos);
  EXPECT_EQ(resolved.find("faults:"), std::string::npos);
  const Scenario with_room = ParseScenarioText(
      "scene: a.xml\nroom: {}\nsteps:\n  - goto: {x_m: 1, y_m: 0}\nexpect: []\n", "s.yaml");
  EXPECT_EQ(with_room.room.value(), RoomSpec{});
  EXPECT_NE(ResolvedYaml(with_room).find("clearance_m: 0.35"), std::string::npos);
}

TEST(ScenarioFormat, AFaultIsDescribedInOneLine) {
  EXPECT_EQ(DescribeFault({{}, ZeroOffFault{"left", 2, 0}, 1.5}),
            "zero_off: eye left, pan_deg 2, tilt_deg 0, from_s 1.5, until_s 3600");
  EXPECT_EQ(DescribeFault({{}, SwappedPairFault{}}), "swapped_pair: from_s 0, until_s 3600");
}

TEST(ScenarioFormat, GoodDocumentsSurviveResolving) {
  for (const Document& d : Corpus("good")) {
    SCOPED_TRACE(d.name);
    ExpectRoundTrip(ParseScenarioText(d.text, d.name));
  }
}

TEST(ScenarioFormat, RandomScenariosSurviveResolving) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto in = [&](double low, double high) { return low + (high - low) * unit(random); };
  for (int i = 0; i < 200; ++i) {
    Scenario s = ParseScenarioText(kMinimal, "s.yaml");
    s.description = "odd \"text\": # \\ {} 'x' \n line \t \xc3\xbc";
    s.seed = random();
    s.camera.horizontal_fov_deg = in(5, 150);
    s.head.encoder_noise_deg = in(0, 1e-9);
    s.vision.rate_hz = in(1e-3, 60);
    s.bodies["board"].position_m = Eigen::Vector3d(in(-1, 1), in(-1, 1), in(-1, 1));
    s.steps.push_back({{}, FixateStep{{in(0.1, 3), in(-1, 1), in(0, 1)}, in(0, 5)}});
    s.steps.push_back({{}, SaccadeStep{in(-90, 90), in(-30, 30), in(0, 20), in(0, 1)}});
    s.steps.push_back({{}, GotoStep{{in(-3, 3), in(-3, 3)}, in(0.05, 1), in(1, 100)}});
    ExpectRoundTrip(s);
  }
}

TEST(ScenarioFormat, RefusesEveryBadDocumentWithItsPlace) {
  for (const char* kind : {"bad", "semantic", "syntax"}) {
    for (const Document& d : Corpus(kind)) {
      SCOPED_TRACE(std::string(kind) + "/" + d.name);
      try {
        ParseScenarioText(d.text, d.name);
        ADD_FAILURE() << "accepted";
      } catch (const ScenarioError& error) {
        for (const Diagnostic& fault : error.diagnostics()) {
          EXPECT_EQ(fault.mark.file, d.name);
          EXPECT_GE(fault.mark.line, 1);
          EXPECT_GE(fault.mark.column, 1);
          EXPECT_EQ(fault.ToString().find('\n'), std::string::npos);
        }
      }
    }
  }
}

TEST(ScenarioFormat, ReportsAllErrorsInFileOrder) {
  const std::string faults = Faults(
      "scen: a.xml\n"
      "camera: {widht: 1, height: 9999}\n"
      "steps:\n"
      "  - gotto: {}\n"
      "expect:\n"
      "  - clearence 1\n");
  EXPECT_THAT(faults, testing::MatchesRegex(
                          "s.yaml:1:1: required key 'scene' is missing[^\n]*\n"
                          "s.yaml:1:1: unknown key 'scen'; did you mean 'scene'\\?\n"
                          "s.yaml:2:10: camera: unknown key 'widht'; did you mean 'width'\\?\n"
                          "s.yaml:2:28: camera.height = 9999: must be a whole number from 16 to "
                          "4096[^\n]*\n"
                          "s.yaml:4:5: [^\n]*did you mean 'goto'\\?\n"
                          "s.yaml:6:5: [^\n]*did you mean 'clearance'\\?"));
}

TEST(ScenarioFormat, DuplicateKeysAreAllFound) {
  const std::string faults = Faults("scene: a.xml\nscene: b.xml\ncamera: {width: 1, width: 2}\n");
  EXPECT_THAT(faults, testing::HasSubstr("s.yaml:2:1: key 'scene' stands twice, first in line 1"));
  EXPECT_THAT(faults, testing::HasSubstr("s.yaml:3:20: key 'width' stands twice"));
}

TEST(ScenarioFormat, HostileTextsEndInAnError) {
  std::string bomb = "a: &a [x, x]\n";
  for (char c = 'b'; c < 'z'; ++c) {
    bomb += std::string(1, c) + ": &" + c + " [*" + char(c - 1) + ", *" + char(c - 1) + "]\n";
  }
  EXPECT_THAT(Faults(bomb), testing::HasSubstr("anchors"));
  EXPECT_NE(Faults(std::string(1000000, '[')), "");
  EXPECT_NE(Faults(std::string(500000, '{')), "");
  EXPECT_THAT(Faults(std::string(2 << 20, 'x')), testing::HasSubstr("1 MiB"));
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(Faults(deep), testing::HasSubstr("nested deeper"));
  EXPECT_NE(Faults(std::string("scene: a\0b\n", 11)), "");
}

TEST(ScenarioFormat, RandomDamageNeverDoesMoreThanThrow) {
  const std::string whole = Corpus("good").front().text;
  std::mt19937 random(3);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = whole;
    for (int n = 0; n < 3; ++n) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, random() % 20);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 20));
      }
    }
    try {
      ExpectRoundTrip(ParseScenarioText(text, "s.yaml"));
    } catch (const ScenarioError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(ScenarioFormat, MissingFileSuggestsItsNeighbour) {
  TemporaryFolder folder;
  folder.Write("waypoint.yaml", kMinimal);
  EXPECT_NO_THROW(ParseScenario(folder.path() / "waypoint.yaml", {}));
  try {
    ParseScenario(folder.path() / "waypont.yaml", {});
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("waypoint.yaml'?"));
  }
  EXPECT_THROW(ParseScenario(folder.path(), {}), ScenarioError);
}

}  // namespace
}  // namespace horopter::scenarios
