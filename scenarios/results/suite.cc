// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/suite.h"

#include <string>
#include <system_error>

#include "scenarios/results/files.h"
#include "scenarios/results/junit.h"
#include "scenarios/results/suite_report.h"
#include "scenarios/results/summary_json.h"

namespace horopter::scenarios {
namespace fs = std::filesystem;

void WriteSuite(const fs::path& folder, const std::vector<RunSummary>& runs) {
  CreateFolder(folder);
  WriteFileAtomically(folder / "report.html", SuiteReportHtml(runs));
  WriteFileAtomically(folder / "junit.xml", JunitXml(runs));
  WriteFileAtomically(folder / "summary.json", SuiteSummaryText(runs));
}

std::vector<RunSummary> ReadSuiteSummary(const fs::path& folder_or_file) {
  std::error_code ignored;
  const fs::path file =
      fs::is_directory(folder_or_file, ignored) ? folder_or_file / "summary.json" : folder_or_file;
  std::string text;
  try {
    text = ReadFile(file);
  } catch (const ResultsError& error) {
    throw UnusableResults(error.what());
  }
  try {
    std::vector<RunSummary> runs = ParseSummaryText(text);
    for (RunSummary& run : runs) {
      if (run.directory.empty()) run.directory.push_back('.');
    }
    return runs;
  } catch (const ResultsError& error) {
    throw UnusableResults(file.string() + ": " + error.what());
  }
}

}  // namespace horopter::scenarios
