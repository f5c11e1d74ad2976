// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A source tree with one file, and what write_build_version.cmake makes of it.
class BuildVersionTest : public testing::Test {
 protected:
  BuildVersionTest() {
    std::string pattern = (fs::path(testing::TempDir()) / "build_version_XXXXXX").string();
    root_ = mkdtemp(pattern.data());
    fs::create_directories(source());
    Write("file.cc", "int a;");
  }
  ~BuildVersionTest() override { fs::remove_all(root_); }

  fs::path source() const { return root_ / "my source"; }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(source() / name) << text;
  }

  static std::string TextOf(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void Git(const std::string& arguments) const {
    const std::string command = "git -C '" + source().string() +
                                "' -c user.name=t -c user.email=t@t -c commit.gpgsign=false " +
                                arguments + " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  void Commit() const {
    Git("init");
    Git("add .");
    Git("commit -m first");
  }

  std::string Header() const {
    const std::string command =
        std::string("'") + HOROPTER_CMAKE "' '-DSOURCE_DIR=" + source().string() +
        "' '-DHEADER=" + header().string() + "' '-DDEPFILE=" + depfile().string() + "' -P '" +
        HOROPTER_SOURCE_DIR "/scenarios/runner/write_build_version.cmake'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return TextOf(header());
  }

  fs::path header() const { return root_ / "build_version.h"; }
  fs::path depfile() const { return root_ / "build_version.d"; }

  fs::path root_;
};

TEST_F(BuildVersionTest, IsUnknownOutsideGit) {
  EXPECT_THAT(Header(), HasSubstr("HOROPTER_COMMIT \"unknown\""));
}

TEST_F(BuildVersionTest, IsUnknownInsideSomebodyElsesRepository) {
  Commit();
  fs::create_directories(source() / "copy");
  Write("copy/file.cc", "int a;");
  const fs::path top = source();
  fs::rename(top, root_ / "theirs");
  fs::create_directory_symlink(root_ / "theirs" / "copy", source());
  EXPECT_THAT(Header(), HasSubstr("HOROPTER_COMMIT \"unknown\""));
}

TEST_F(BuildVersionTest, IsTheCommitAndDirtyWhenATrackedFileDiffers) {
  Commit();
  EXPECT_THAT(Header(), testing::ContainsRegex("HOROPTER_COMMIT \"[0-9a-f]+\""));
  Write("untracked.cc", "");
  EXPECT_THAT(Header(), Not(HasSubstr("dirty")));
  Write("file.cc", "int b;");
  EXPECT_THAT(Header(), testing::ContainsRegex("HOROPTER_COMMIT \"[0-9a-f]+-dirty\""));
}

TEST_F(BuildVersionTest, HeaderThatWouldNotChangeKeepsItsTime) {
  Commit();
  Header();
  const auto long_ago = fs::last_write_time(header()) - std::chrono::hours(1);
  fs::last_write_time(header(), long_ago);
  Header();
  EXPECT_EQ(fs::last_write_time(header()), long_ago);
}

TEST_F(BuildVersionTest, DependsOnTheTrackedFilesAndOnWhereTheBranchIs) {
  Commit();
  Header();
  std::string escaped = source().string();
  escaped.replace(escaped.find("my source"), 9, "my\\ source");
  for (const char* file : {"/file.cc", "/.git/HEAD", "/.git/logs/HEAD", "/.git/refs/heads/"}) {
    EXPECT_THAT(TextOf(depfile()), HasSubstr(escaped + file));
  }
  EXPECT_THAT(TextOf(depfile()), Not(HasSubstr("/.git/index")));  // which git status may write
}

}  // namespace
}  // namespace horopter::scenarios
