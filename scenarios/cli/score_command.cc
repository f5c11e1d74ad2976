// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/quiet_opencv.h"
#include "scenarios/dataset/disparity_files.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/image_file.h"
#include "scenarios/runner/exit_code.h"
#include "vision/disparity/field_score.h"

namespace horopter::scenarios {
namespace {

using vision::ErrorScore;

struct ScoreArguments {
  std::string estimate;
  std::string truth;
  std::string mask;
  double scale = 1;
  bool max_px = false;
  bool json = false;
};

cv::Mat1b ReadMask(const std::string& file) {
  if (file.empty()) return {};
  const cv::Mat pixels = ReadImage(file);
  if (pixels.channels() != 1) {
    throw FormatError(
        fmt::format("{}: {} channels: a mask has one, other than 0 where pixels count", file,
                    pixels.channels()));
  }
  return pixels != 0;
}

/// JSON has no NaN: what was not measured is null.
nlohmann::ordered_json Number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json Json(const ErrorScore& score) {
  nlohmann::ordered_json bad_estimated, bad_known;
  for (std::size_t i = 0; i < vision::kBadLimitsPx.size(); ++i) {
    const std::string limit = fmt::format("{:g}", vision::kBadLimitsPx[i]);
    bad_estimated[limit] = Number(score.bad_estimated[i]);
    bad_known[limit] = Number(score.bad_known[i]);
  }
  return {{"known", score.known},
          {"estimated", score.estimated},
          {"density", Number(score.density)},
          {"mean_px", Number(score.mean_px)},
          {"median_px", Number(score.median_px)},
          {"rms_px", Number(score.rms_px)},
          {"max_px", Number(score.max_px)},
          {"max_at", {score.max_at.x, score.max_at.y}},
          {"bad_estimated", bad_estimated},
          {"bad_known", bad_known}};
}

using Rows = std::vector<std::pair<std::string, ErrorScore>>;

Rows RowsOf(const vision::FieldScores& scores) {
  Rows rows = {{"dx", scores.dx}};
  if (scores.dy) rows.emplace_back("dy", *scores.dy);
  if (scores.vector) rows.emplace_back("vector", *scores.vector);
  return rows;
}

std::string Cell(double value) { return std::isfinite(value) ? fmt::format("{:.3f}", value) : "-"; }

void PrintMarkdown(const Rows& rows, bool max_px) {
  std::string header = "| | known | density | mean px | median px | RMS px |";
  std::string line = "|---|---:|---:|---:|---:|---:|";
  for (const double limit : vision::kBadLimitsPx) header += fmt::format(" bad-{:g} |", limit);
  for (const double limit : vision::kBadLimitsPx)
    header += fmt::format(" missing or bad-{:g} |", limit);
  for (std::size_t i = 0; i < 2 * vision::kBadLimitsPx.size(); ++i) line += "---:|";
  std::cout << header << (max_px ? " max px | at |" : "") << "\n"
            << line << (max_px ? "---:|---:|" : "") << "\n";
  for (const auto& [name, s] : rows) {
    std::cout << fmt::format("| {} | {} | {} | {} | {} | {} |", name, s.known, Cell(s.density),
                             Cell(s.mean_px), Cell(s.median_px), Cell(s.rms_px));
    for (const double share : s.bad_estimated) std::cout << " " << Cell(share) << " |";
    for (const double share : s.bad_known) std::cout << " " << Cell(share) << " |";
    if (max_px)
      std::cout << fmt::format(" {} | ({}, {}) |", Cell(s.max_px), s.max_at.x, s.max_at.y);
    std::cout << "\n";
  }
}

vision::FieldScores Score(const ScoreArguments& a) {
  const QuietOpenCv quiet;
  const vision::DisparityMaps truth = ReadDisparity(a.truth, a.scale);
  const vision::DisparityMaps estimate = ReadDisparity(a.estimate, a.scale);
  return vision::ScoreDisparity(estimate, truth, ReadMask(a.mask));
}

int ScoreFiles(const ScoreArguments& a) {
  const Rows rows = RowsOf(Score(a));
  if (!a.json) {
    PrintMarkdown(rows, a.max_px);
    return static_cast<int>(ExitCode::kPassed);
  }
  nlohmann::ordered_json report;
  for (const auto& [name, score] : rows) report[name] = Json(score);
  std::cout << report.dump(2) << "\n";
  return static_cast<int>(ExitCode::kPassed);
}

}  // namespace

Command AddScoreCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("score", "Hold a disparity file against the true one");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<ScoreArguments>();
  app->add_option("ESTIMATE", a->estimate, "Disparity to judge: .flo, .pfm, .png or .pgm")
      ->required();
  app->add_option("TRUTH", a->truth, "True disparity, in any of these formats")->required();
  app->add_option("--mask", a->mask, "Image: only pixels other than 0 count");
  app->add_option("--scale", a->scale, "Value of 1 px in a .png of 8 bits or a .pgm")
      ->capture_default_str();
  app->add_flag("--max-px", a->max_px, "Also the largest error, and where it is");
  app->add_flag("--json", a->json, "Print JSON");
  app->footer(
      "\nErrors of dx, and where both files have a vertical part those of dy and of the vector,\n"
      "over the pixels whose truth is known: density, mean, median, RMS, and the shares beyond\n"
      "0.5, 1, 2 and 4 px, of the estimated pixels and with missing ones counted as wrong.\n"
      "\nFormats: .flo; .pfm (Middlebury); .png of 16 bits (KITTI disparity, or flow in three\n"
      "channels), or of 8 bits, and .pgm, where value / scale is the disparity and 0 unknown.\n"
      "\nExamples:\n"
      "  horopter score disparity.flo truth.flo --json\n"
      "  horopter score disparity.pfm disp2.pgm --scale 4 --mask nonoccluded.png");
  return {app, [a] { return ScoreFiles(*a); }};
}

}  // namespace horopter::scenarios
