// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/results_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

class ResultsFolderTest : public testing::Test {
 protected:
  ResultsFolderTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / "horopter_results_folder" / info->name();
    fs::remove_all(root_);
  }

  fs::path root_;
};

TEST_F(ResultsFolderTest, NewOnesOfTheSameSecondAreTheirOwn) {
  const ResultsFolder first = ResultsFolder::New(root_, "20260131-235959");
  const ResultsFolder second = ResultsFolder::New(root_, "20260131-235959");
  std::ofstream(root_ / "run-20260131-235959-3") << "a file";
  const ResultsFolder third = ResultsFolder::New(root_, "20260131-235959");
  EXPECT_EQ(first.path(), root_ / "run-20260131-235959");
  EXPECT_EQ(second.path(), root_ / "run-20260131-235959-2");
  EXPECT_EQ(third.path(), root_ / "run-20260131-235959-4");
  EXPECT_TRUE(fs::is_directory(third.path()));
}

TEST_F(ResultsFolderTest, IsRefusedWhileAnotherUsesItAndNotAfterwards) {
  std::optional<ResultsFolder> used(std::in_place, root_ / "out");
  try {
    const ResultsFolder same(root_ / "out");
    FAIL();
  } catch (const ResultsError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--out"));
  }
  used.reset();
  EXPECT_EQ(ResultsFolder(root_ / "out").path(), root_ / "out");
}

TEST_F(ResultsFolderTest, ThatCannotBeMadeSaysWhere) {
  fs::create_directories(root_);
  std::ofstream(root_ / "file") << "";
  EXPECT_THROW(ResultsFolder(root_ / "file" / "out"), ResultsError);
  EXPECT_THROW(ResultsFolder::New(root_ / "file", "x"), ResultsError);
}

}  // namespace
}  // namespace horopter::scenarios
