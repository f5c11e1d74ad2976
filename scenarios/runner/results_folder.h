// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace horopter::scenarios {

/// The folder that a suite writes into, its own as long as this lives: another process that asks
/// for the same folder meanwhile is refused. Where the file system has no locks nobody is.
///
/// A process forked meanwhile shares the claim, and keeps it until it ends too.
class ResultsFolder {
 public:
  /// A folder that may be there already. Creates it and what is above it.
  /// @throws ResultsError when it cannot be created, or belongs to a process that still runs
  explicit ResultsFolder(const std::filesystem::path& path);

  /// A folder that was not there before: ROOT/run-NAME, or with -2, -3, ... behind that.
  /// @throws ResultsError when it cannot be created
  static ResultsFolder New(const std::filesystem::path& root, const std::string& name);

  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  ~ResultsFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int claim_ = -1;
};

}  // namespace horopter::scenarios
