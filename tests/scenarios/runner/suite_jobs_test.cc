// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/suite_jobs.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

class SuiteJobsTest : public testing::Test {
 protected:
  SuiteJobsTest() {
    fs::remove_all(root_);
    fs::create_directories(root_);
    Write("everyday", "quick");
    Write("rare", "experiment");
  }

  void Write(const std::string& name, const std::string& tag) const {
    std::ofstream(root_ / (name + ".yaml"))
        << "name: " << name << "\nscene: koala/empty_room.xml\ntags: [" << tag
        << "]\nsteps:\n  - wait: {duration_s: 1}\nexpect:\n  - contacts 0\n";
  }

  std::vector<std::string> Names(const SuiteOptions& options) const {
    std::vector<std::string> names;
    for (const SuiteJob& job : MakeJobs(options)) names.push_back(job.scenario.name);
    return names;
  }

  fs::path root_ = fs::path(testing::TempDir()) / "horopter_suite_jobs" /
                   testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(SuiteJobsTest, FoldersLeaveExperimentsOut) {
  SuiteOptions options;
  options.inputs = {root_};
  EXPECT_EQ(Names(options), std::vector<std::string>{"everyday"});
}

TEST_F(SuiteJobsTest, ExperimentsArePlayedByTagAndByFile) {
  SuiteOptions options;
  options.inputs = {root_};
  options.tags = {"experiment"};
  EXPECT_EQ(Names(options), std::vector<std::string>{"rare"});
  options.tags.clear();
  options.inputs = {root_ / "rare.yaml"};
  EXPECT_EQ(Names(options), std::vector<std::string>{"rare"});
}

}  // namespace
}  // namespace horopter::scenarios
