// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/find_scenarios.h"

#include <algorithm>
#include <set>

#include "scenarios/format/field_parser.h"
#include "scenarios/format/read_text.h"

namespace horopter::scenarios {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> ScenariosBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code none;
    if (it->is_directory(none)) {
      if (name.starts_with('.')) it.disable_recursion_pending();
      continue;
    }
    if (it->path().extension() == ".yaml" && name != "robot.yaml" && it->is_regular_file(none)) {
      files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> FindScenarios(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> found;
  std::set<fs::path> seen;
  ParseReport report;
  for (const fs::path& input : inputs) {
    std::error_code error;
    std::vector<fs::path> files;
    if (!fs::exists(input, error)) {
      report.Add({input.string()}, "no such file or folder" + SiblingHint(input));
      continue;
    }
    if (fs::is_directory(input, error)) {
      files = ScenariosBelow(input);
      if (files.empty()) {
        report.Add({input.string()}, "no scenarios (*.yaml) below this folder");
      }
    } else {
      files = {input};
    }
    for (fs::path& file : files) {
      if (seen.insert(fs::weakly_canonical(file, error)).second) found.push_back(std::move(file));
    }
  }
  ThrowIfAny(std::move(report.diagnostics));
  return found;
}

}  // namespace horopter::scenarios
