// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace fs = std::filesystem;
namespace {

std::string Remedy(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or choose another folder with --out";
    case ENOTDIR:
    case EEXIST:
      return "a file is in the way: remove it or choose another folder with --out";
    default:
      return "choose a folder that you may write with --out";
  }
}

/// Closes the descriptor and removes the temporary unless the rename has happened.
class Temporary {
 public:
  explicit Temporary(fs::path path)
      : path_(std::move(path)),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    if (descriptor_ < 0) throw ResultsError(WriteFailure(path_, errno));
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }

  int descriptor() const { return descriptor_; }

  void RenameTo(const fs::path& file, Durability durability) {
    // EINVAL: a file system that cannot flush; the content is then as safe as it gets.
    if (durability == Durability::kPower && ::fsync(descriptor_) != 0 && errno != EINVAL) {
      throw ResultsError(WriteFailure(file, errno));
    }
    const int closed = ::close(std::exchange(descriptor_, -1));
    if (closed != 0) throw ResultsError(WriteFailure(file, errno));
    if (::rename(path_.c_str(), file.c_str()) != 0) throw ResultsError(WriteFailure(file, errno));
    path_.clear();
  }

 private:
  fs::path path_;
  int descriptor_;
};

}  // namespace

std::string WriteFailure(const fs::path& place, int error) {
  return fmt::format("cannot write results to {}: {}; {}", place.string(),
                     std::generic_category().message(error), Remedy(error));
}

void CreateFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) throw ResultsError(WriteFailure(folder, error.value()));
}

void WriteFully(int descriptor, std::string_view content, const fs::path& file) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw ResultsError(WriteFailure(file, errno));
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void WriteFileAtomically(const fs::path& file, std::string_view content, Durability durability) {
  // The process id keeps apart two processes that write the same suite.
  Temporary temporary(file.string() + fmt::format(".{}.tmp", ::getpid()));
  WriteFully(temporary.descriptor(), content, file);
  temporary.RenameTo(file, durability);
}

std::string ReadFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw ResultsError(fmt::format("cannot read {}: it is a folder", file.string()));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw ResultsError(
        fmt::format("cannot read {}: {}", file.string(), std::generic_category().message(errno)));
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace horopter::scenarios
