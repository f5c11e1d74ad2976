// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/behaviour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/kinematics/fixate.h"
#include "control/kinematics/gaze_angles.h"

namespace horopter::scenarios {
namespace {

using hardware::FromSeconds;
using hardware::HeadAngles;
using hardware::Time;

constexpr double kRadians = M_PI / 180;

Eigen::Vector3d InBase(const hardware::Pose2& X_OB, const Eigen::Vector3d& p_O) {
  return hardware::ToPose(X_OB).inverse() * p_O;
}

/// Turns the head to a target that may move with the base, then holds it.
class HoldGaze : public Behaviour {
 public:
  HoldGaze(const BehaviourContext& context, double hold_s) : context_(context), hold_s_(hold_s) {}

  StepOutput Update(const StackState& state) final {
    StepOutput out;
    out.head = Target(state, out);
    if (!out.failure.empty()) {
      out.fixated_O.reset();
      out.done = true;
      return out;
    }
    if (!settled_at_ && Settled(state.angles, *out.head)) settled_at_ = state.t;
    if (!settled_at_) {
      out.fixated_O.reset();
      out.decision = "turning the head";
      return out;
    }
    out.decision = "holding the gaze";
    out.done = state.t - *settled_at_ >= FromSeconds(hold_s_);
    return out;
  }

 protected:
  const BehaviourContext& context() const { return context_; }

 private:
  /// Where the axes should be; sets out.failure when they cannot get there.
  virtual HeadAngles Target(const StackState& state, StepOutput& out) const = 0;

  bool Settled(const HeadAngles& now, const HeadAngles& target) const {
    const auto a = hardware::ToArray(now), b = hardware::ToArray(target);
    for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
      if (context_.limits[i].exists() && std::abs(a[i] - b[i]) > context_.settled_rad) return false;
    }
    return true;
  }

  BehaviourContext context_;
  double hold_s_;
  std::optional<Time> settled_at_;
};

/// Fixates a point, or looks its way with parallel axes.
class GazeBehaviour final : public HoldGaze {
 public:
  GazeBehaviour(const FixateStep& step, const BehaviourContext& context)
      : HoldGaze(context, step.hold_s), target_O_(step.target_m), converging_(true) {}
  GazeBehaviour(const LookAtStep& step, const BehaviourContext& context)
      : HoldGaze(context, step.hold_s), target_O_(step.target_m), converging_(false) {}

 private:
  HeadAngles Target(const StackState& state, StepOutput& out) const override {
    const control::Fixation fixation = control::Fixate(
        context().geometry, context().limits, state.angles.neck, InBase(state.X_OB, target_O_));
    if (!fixation.reachable()) {
      out.failure = (converging_ ? "cannot fixate: " : "cannot look there: ") + fixation.why;
      out.impossible = true;
    }
    if (!converging_) return Parallel(fixation.angles);
    out.fixated_O = target_O_;
    return fixation.angles;
  }

  /// Both eyes the way of their mean.
  static HeadAngles Parallel(HeadAngles angles) {
    angles.left.pan_rad = angles.right.pan_rad = (angles.left.pan_rad + angles.right.pan_rad) / 2;
    angles.left.tilt_rad = angles.right.tilt_rad =
        (angles.left.tilt_rad + angles.right.tilt_rad) / 2;
    return angles;
  }

  Eigen::Vector3d target_O_;
  bool converging_;
};

class SaccadeBehaviour final : public HoldGaze {
 public:
  SaccadeBehaviour(const SaccadeStep& step, const BehaviourContext& context)
      : HoldGaze(context, step.hold_s) {
    target_ = control::Turn({{step.pan_deg * kRadians, step.tilt_deg * kRadians},
                             step.vergence_deg * kRadians},
                            context.limits)
                  .angles;
  }

 private:
  HeadAngles Target(const StackState&, StepOutput&) const override { return target_; }

  HeadAngles target_;
};

class WaitBehaviour final : public Behaviour {
 public:
  explicit WaitBehaviour(const WaitStep& step) : duration_s_(step.duration_s) {}

  StepOutput Update(const StackState& state) override {
    if (!until_) until_ = state.t + FromSeconds(duration_s_);
    StepOutput out;
    out.decision = "waiting";
    out.done = state.t >= *until_;
    return out;
  }

 private:
  double duration_s_;
  std::optional<Time> until_;
};

class GotoBehaviour final : public Behaviour {
 public:
  GotoBehaviour(const GotoStep& step, const BehaviourContext& context,
                control::Navigator& navigator)
      : step_(step), context_(context), navigator_(navigator) {}

  StepOutput Update(const StackState& state) override {
    if (!deadline_) {
      navigator_.SetGoal(step_.goal_m, step_.tolerance_m);
      deadline_ = state.t + FromSeconds(step_.timeout_s);
    }
    const control::NavigatorDecision decision = navigator_.Update(state.t, state.X_OB);
    StepOutput out;
    out.twist = decision.command;
    out.waypoint_O = decision.waypoint;
    out.decision = fmt::format("{}: {}", control::ToString(decision.state), decision.reason);
    const control::Fixation gaze =
        control::Fixate(context_.geometry, context_.limits, state.angles.neck, decision.gaze_B);
    out.head = gaze.angles;
    if (decision.state == control::NavigatorState::kReached) {
      out.done = true;
    } else if (decision.state == control::NavigatorState::kStuck) {
      out.failure = "stuck: " + decision.reason;
    } else if (state.t >= *deadline_) {
      out.failure = fmt::format("not there after {:g} s, {:.2f} m left", step_.timeout_s,
                                decision.remaining_m);
    }
    if (!out.failure.empty()) {
      out.done = true;
      out.twist = {};
    }
    return out;
  }

 private:
  GotoStep step_;
  BehaviourContext context_;
  control::Navigator& navigator_;
  std::optional<Time> deadline_;
};

}  // namespace

std::unique_ptr<Behaviour> MakeBehaviour(const StepAction& action, const BehaviourContext& context,
                                         control::Navigator& navigator) {
  struct Maker {
    const BehaviourContext& context;
    control::Navigator& navigator;
    std::unique_ptr<Behaviour> operator()(const GotoStep& s) const {
      return std::make_unique<GotoBehaviour>(s, context, navigator);
    }
    std::unique_ptr<Behaviour> operator()(const FixateStep& s) const {
      return std::make_unique<GazeBehaviour>(s, context);
    }
    std::unique_ptr<Behaviour> operator()(const LookAtStep& s) const {
      return std::make_unique<GazeBehaviour>(s, context);
    }
    std::unique_ptr<Behaviour> operator()(const SaccadeStep& s) const {
      return std::make_unique<SaccadeBehaviour>(s, context);
    }
    std::unique_ptr<Behaviour> operator()(const WaitStep& s) const {
      return std::make_unique<WaitBehaviour>(s);
    }
  };
  return std::visit(Maker{context, navigator}, action);
}

std::string StepName(const StepAction& action) {
  static constexpr const char* kNames[] = {"goto", "fixate", "look_at", "saccade", "wait"};
  static_assert(std::variant_size_v<StepAction> == std::size(kNames));
  return kNames[action.index()];
}

}  // namespace horopter::scenarios
