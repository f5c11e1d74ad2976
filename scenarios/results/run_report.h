// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/embedded_pictures.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// All that a run's report shows.
struct RunReport {
  RunSummary summary;
  PlanRecord plan;
  std::vector<FrameRecord> frames;      ///< every frame, for the charts
  std::vector<EmbeddedFrame> pictures;  ///< the frames shown
  std::string resolved_scenario;        ///< YAML
};

/// The run as one HTML page that needs nothing beside it: where the robot went, what it saw, how
/// wrong its depth was, the expectations, timing, and what it takes to repeat the run.
std::string RunReportHtml(const RunReport& report);

}  // namespace horopter::scenarios
