// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/mobile_base.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/stage_times.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"
#include "scenarios/runner/truth_probe.h"

namespace horopter::scenarios {

/// The backend's hardware or service is not there (exit code 4).
class BackendUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A robot to run a scenario on: the devices the stack may use and, for scoring alone, the truth.
class Backend {
 public:
  virtual ~Backend() = default;

  virtual hardware::Clock& clock() = 0;
  virtual hardware::StereoHead& head() = 0;
  virtual hardware::CameraPair& cameras() = 0;
  virtual hardware::MobileBase& base() = 0;

  /// Null where there is no truth.
  virtual TruthProbe* truth() = 0;

  /// "" where no image is rendered.
  virtual std::string gl_renderer() const = 0;

  /// Texts for the run's folder, by file name: what was generated for this run.
  virtual std::map<std::string, std::string> records() const { return {}; }
};

/// The only place that knows which backend is behind a name.
/// @param times where the backend books physics, render and read-back; outlives it
/// @throws BackendUnavailable, and whatever the backend's own set-up throws
std::unique_ptr<Backend> CreateBackend(const Scenario& scenario, const RobotDescription& robot,
                                       hardware::StageTimes& times);

}  // namespace horopter::scenarios
