// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace horopter::scenarios {

/// A text file that grows by whole lines. Each line reaches the operating system in one call, so
/// that it outlives the process. Owns its descriptor; moves, does not copy.
class AppendFile {
 public:
  /// Creates or empties the file and writes the first line. @throws ResultsError
  AppendFile(std::filesystem::path path, std::string_view header);
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&&) = delete;
  ~AppendFile();

  /// @param line without its line end @throws ResultsError
  void Append(std::string_view line);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace horopter::scenarios
