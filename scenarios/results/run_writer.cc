// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/run_writer.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "scenarios/results/embedded_pictures.h"
#include "scenarios/results/files.h"
#include "scenarios/results/junit.h"
#include "scenarios/results/plan_svg.h"
#include "scenarios/results/run_report.h"
#include "scenarios/results/summary_json.h"
#include "scenarios/results/tables.h"

namespace horopter::scenarios {
namespace fs = std::filesystem;
namespace {

/// What an earlier run in the same folder may have left.
void RemoveOldResults(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"room.json", "room.xml", "stack.json", "plan.json", "plan.svg",
                           "report.html", "junit.xml"}) {
    fs::remove(folder / name, ignored);
  }
  for (const auto& entry : fs::directory_iterator(folder / "frames", ignored)) {
    if (entry.path().extension() == ".png") fs::remove(entry.path(), ignored);
  }
}

/// Makes the folder a run that has not ended; only then are the old results gone.
fs::path Prepare(fs::path folder, const std::string& resolved_scenario, RunSummary identity) {
  identity.outcome = Outcome::kIncomplete;
  if (identity.error.empty()) identity.error = "the run did not finish";
  CreateFolder(folder);
  WriteFileAtomically(folder / "summary.json", RunSummaryText(identity));
  RemoveOldResults(folder);
  WriteFileAtomically(folder / "scenario.yaml", resolved_scenario);
  CreateFolder(folder / "frames");
  return folder;
}

std::vector<std::pair<PictureKind, const cv::Mat*>> PicturesOf(const FrameImages& images) {
  return {{PictureKind::kLeft, &images.left_bgr},
          {PictureKind::kRight, &images.right_bgr},
          {PictureKind::kRegions, &images.regions_bgr},
          {PictureKind::kDisparity, &images.disparity_bgr},
          {PictureKind::kDepth, &images.depth_bgr},
          {PictureKind::kTrueDepth, &images.true_depth_bgr},
          {PictureKind::kDepthError, &images.depth_error_bgr}};
}

std::string PngBytes(const cv::Mat& picture, const fs::path& file) {
  if (picture.type() != CV_8UC3) {
    throw std::invalid_argument(fmt::format("picture for {} is of type {}: must be CV_8UC3",
                                            file.string(), picture.type()));
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", picture, bytes);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

RunWriter::RunWriter(fs::path folder, const std::string& resolved_scenario,
                     const RunSummary& identity)
    : folder_(Prepare(std::move(folder), resolved_scenario, identity)),
      resolved_scenario_(resolved_scenario),
      frames_csv_(folder_ / "frames.csv", FrameTableHeader()),
      trajectory_csv_(folder_ / "trajectory.csv", PathTableHeader()) {}

void RunWriter::AddFrame(const FrameRecord& frame, const FrameImages& images) {
  ReportFrame pictured{frame, images.scales, {}};
  for (const auto& [kind, picture] : PicturesOf(images)) {
    if (picture->empty()) continue;
    const fs::path file =
        folder_ / "frames" / fmt::format("{:04}_{}.png", frame.index, FileSuffix(kind));
    WriteFileAtomically(file, PngBytes(*picture, file), Durability::kProcess);
    pictured.pictures.push_back({kind, file});
  }
  if (!pictured.pictures.empty()) pictured_.push_back(std::move(pictured));
  frames_.push_back(frame);
  frames_csv_.Append(FrameTableRow(frame));
}

void RunWriter::AddPathPoint(const PathPoint& point) {
  path_.push_back(point);
  trajectory_csv_.Append(PathTableRow(point));
}

void RunWriter::AddRecord(const std::string& name, const std::string& text) {
  WriteFileAtomically(folder_ / name, text);
}

void RunWriter::Finish(const RunSummary& summary, const PlanRecord& plan) {
  RunReport report{summary, plan, frames_, EmbedFrames(pictured_), resolved_scenario_};
  if (report.plan.path.empty()) report.plan.path = path_;
  WriteFileAtomically(folder_ / "plan.json", ToJson(report.plan).dump(1) + "\n");
  WriteFileAtomically(folder_ / "plan.svg", PlanSvg(report.plan));
  WriteFileAtomically(folder_ / "report.html", RunReportHtml(report));
  WriteFileAtomically(folder_ / "junit.xml", JunitXml({summary}));
  WriteFileAtomically(folder_ / "summary.json", RunSummaryText(summary));
}

}  // namespace horopter::scenarios
