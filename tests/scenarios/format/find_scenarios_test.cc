// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/find_scenarios.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/format/diagnostics.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

TEST(FindScenarios, SortedBelowFoldersAndEachOnce) {
  TemporaryFolder folder;
  const auto b = folder.Write("b/two.yaml", "");
  const auto a = folder.Write("a/one.yaml", "");
  folder.Write("a/robot.yaml", "");
  folder.Write("a/notes.txt", "");
  folder.Write(".git/hidden.yaml", "");
  EXPECT_THAT(FindScenarios({folder.path()}), testing::ElementsAre(a, b));
  EXPECT_THAT(FindScenarios({b, folder.path(), b}), testing::ElementsAre(b, a));
}

TEST(FindScenarios, NamesEveryMissingInputWithASuggestion) {
  TemporaryFolder folder;
  folder.Write("waypoint.yaml", "");
  std::filesystem::create_directory(folder.path() / "empty");
  try {
    FindScenarios({folder.path() / "waipoint.yaml", folder.path() / "empty"});
    FAIL();
  } catch (const ScenarioError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2u);
    EXPECT_THAT(error.what(),
                testing::HasSubstr("did you mean '" + (folder.path() / "waypoint.yaml").string()));
    EXPECT_THAT(error.what(), testing::HasSubstr("no scenarios"));
  }
}

}  // namespace
}  // namespace horopter::scenarios
