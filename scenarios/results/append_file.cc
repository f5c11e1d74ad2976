// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/append_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

#include "scenarios/results/files.h"
#include "scenarios/results/results_error.h"

namespace horopter::scenarios {

AppendFile::AppendFile(std::filesystem::path path, std::string_view header)
    : path_(std::move(path)),
      descriptor_(
          ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) throw ResultsError(WriteFailure(path_, errno));
  try {
    Append(header);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

AppendFile::~AppendFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void AppendFile::Append(std::string_view line) {
  WriteFully(descriptor_, std::string(line) + '\n', path_);
}

}  // namespace horopter::scenarios
