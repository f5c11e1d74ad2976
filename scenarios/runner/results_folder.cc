// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/results_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace fs = std::filesystem;
namespace {

void ThrowIf(const std::error_code& reason, const fs::path& path) {
  if (!reason) return;
  throw ResultsError(
      fmt::format("{}: cannot create the results folder ({}); name another with --out",
                  path.string(), reason.message()));
}

void CreateAll(const fs::path& path) {
  std::error_code reason;
  fs::create_directories(path, reason);
  ThrowIf(reason, path);
}

fs::path CreateNew(const fs::path& root, const std::string& name) {
  CreateAll(root);
  for (int number = 1;; ++number) {
    const std::string suffix = number == 1 ? "" : fmt::format("-{}", number);
    const fs::path path = root / fmt::format("run-{}{}", name, suffix);
    std::error_code reason;
    const bool created = fs::create_directory(path, reason);
    if (created) return path;
    // What is there already may also be a file: both mean that the name is taken.
    if (reason != std::errc::file_exists) ThrowIf(reason, path);
  }
}

}  // namespace

ResultsFolder::ResultsFolder(const fs::path& path) : path_(path) {
  CreateAll(path);
  claim_ = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (claim_ < 0 || flock(claim_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(claim_);
  throw ResultsError(fmt::format(
      "{}: another horopter is writing its results there; wait for it, or name another with --out",
      path.string()));
}

ResultsFolder ResultsFolder::New(const fs::path& root, const std::string& name) {
  return ResultsFolder(CreateNew(root, name));
}

ResultsFolder::~ResultsFolder() {
  if (claim_ >= 0) close(claim_);
}

}  // namespace horopter::scenarios
