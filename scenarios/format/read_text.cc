// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/read_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "scenarios/format/diagnostics.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

// One byte more than a scenario may have, so that the parser sees that it is too large.
constexpr std::streamsize kMostBytes = (1 << 20) + 1;

[[noreturn]] void FailOn(const std::filesystem::path& path, const std::string& why) {
  Fail({path.string(), 0, 0}, why);
}

}  // namespace

std::string SiblingHint(const std::filesystem::path& path) {
  const auto parent = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code error;
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator it(parent, error), end; !error && it != end;
       it.increment(error)) {
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const auto nearest = NearestName(path.filename().string(), names);
  if (!nearest) return "";
  const auto meant =
      path.has_parent_path() ? path.parent_path() / *nearest : std::filesystem::path(*nearest);
  return "; did you mean '" + meant.string() + "'?";
}

std::string ReadText(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) FailOn(path, "no such file" + SiblingHint(path));
  if (std::filesystem::is_directory(status)) FailOn(path, "a folder where a file must stand");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) FailOn(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text(static_cast<std::size_t>(kMostBytes), '\0');
  file.read(text.data(), kMostBytes);
  if (file.bad()) FailOn(path, std::string("cannot be read: ") + std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace horopter::scenarios
