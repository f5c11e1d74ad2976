// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <set>
#include <utility>

#include "scenarios/runner/truth_probe.h"
#include "sim/backend/koala_simulation.h"
#include "sim/oracle/collision_oracle.h"
#include "sim/truth/ground_truth.h"

namespace horopter::scenarios {

/// The larger of both eyes' errors; NaN when either has none.
double WorseEye(double left, double right);

/// Truth of the simulated Koala: what the left eye would see if it were perfect, contacts from
/// MuJoCo, clearance from Bullet's world built from the same model.
class KoalaTruth final : public TruthProbe {
 public:
  /// Watches the simulation from now on; both must outlive it.
  KoalaTruth(sim::KoalaSimulation& simulation, hardware::StageTimes& times);

  hardware::Pose2 X_OB() override;
  double Clearance() override;
  int contacts() const override { return contacts_; }
  double FixationErrorDeg(const Eigen::Vector3d& p_OT) override;
  FrameTruth AtCapture() override;
  PlanRecord Plan() override;

 private:
  using GeomPair = std::pair<int, int>;

  void CountContacts(const sim::World& world);
  /// Where the left eye's view shows geom "board" within site "board_pattern".
  cv::Mat1b BoardPixels(const sim::EyeTruth& seen) const;

  sim::KoalaSimulation& simulation_;
  hardware::StageTimes& times_;
  sim::CollisionOracle oracle_;
  std::shared_ptr<const sim::SceneShapes> shapes_;  ///< shared with snapshots, which may outlive it
  int robot_body_ = -1;
  std::set<int> robot_geoms_;
  std::set<int> floor_geoms_;
  std::set<GeomPair> touching_;  ///< at the last step
  int contacts_ = 0;
};

}  // namespace horopter::scenarios
