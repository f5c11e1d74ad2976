// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/results/append_file.h"
#include "scenarios/results/report_frame.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Writes one run's folder, from the first moment on in a state that tells the truth:
///
///   summary.json   says `incomplete` until Finish() replaces it, which is the last thing it does
///   scenario.yaml  the resolved scenario
///   frames.csv, trajectory.csv   a header, then one row per call, each handed to the operating
///                  system whole, so that a killed process leaves all its rows readable
///   frames/NNNN_left.png ...     the chosen frames (NNNN is the frame's index)
///   stack.json     the numbers that the stack runs with, which the scenario leaves to defaults
///   room.json, room.xml   a generated room: what stands where, and its whole scene
///   plan.json, plan.svg, report.html, junit.xml   by Finish()
///
/// Every other file appears whole or not at all (a temporary in the same folder, then a rename).
/// Files of an earlier run in the same folder are removed, others are left alone.
class RunWriter {
 public:
  /// Creates the folder and what is above it.
  /// @param resolved_scenario text of scenario.yaml
  /// @param identity the run's scenario, file, seed, backend and whatever else is known before it
  ///        starts; its outcome is written as incomplete whatever it says
  /// @throws ResultsError when the folder cannot be created or written
  RunWriter(std::filesystem::path folder, const std::string& resolved_scenario,
            const RunSummary& identity);
  RunWriter(const RunWriter&) = delete;
  RunWriter& operator=(const RunWriter&) = delete;
  /// Without Finish() the folder keeps saying that the run is incomplete.
  ~RunWriter() = default;

  /// One row of frames.csv, and a PNG for every picture that is not empty. Pass pictures only of
  /// the frames worth keeping: the report embeds at most twelve of them, evenly chosen, and the
  /// last. @throws ResultsError; std::invalid_argument when a picture is not CV_8UC3.
  void AddFrame(const FrameRecord& frame, const FrameImages& images = {});

  /// One row of trajectory.csv. @throws ResultsError
  void AddPathPoint(const PathPoint& point);

  /// One more file of the run's folder: stack.json, room.json or room.xml. @throws ResultsError
  void AddRecord(const std::string& name, const std::string& text);

  /// Writes the plan, the report and junit.xml, then summary.json. To be called once; also for a
  /// run that failed, stopped with an error, or ran out of time (`summary.outcome` says so).
  /// @param plan a plan without a path is drawn with the points that AddPathPoint() was given
  /// @throws ResultsError; the run then still reads as incomplete
  void Finish(const RunSummary& summary, const PlanRecord& plan);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string resolved_scenario_;
  AppendFile frames_csv_;
  AppendFile trajectory_csv_;
  std::vector<FrameRecord> frames_;
  std::vector<ReportFrame> pictured_;
  std::vector<PathPoint> path_;
};

}  // namespace horopter::scenarios
