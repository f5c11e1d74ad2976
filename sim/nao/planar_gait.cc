// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/planar_gait.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "sim/nao/leg_ik.h"

namespace horopter::sim {

namespace {

using Eigen::Vector3d;
using hardware::Eye;
using hardware::FieldError;
using hardware::Pose;
using hardware::Pose2;

Eye Other(Eye side) { return side == Eye::kLeft ? Eye::kRight : Eye::kLeft; }
double Sign(Eye side) { return side == Eye::kLeft ? 1 : -1; }

Pose2 Compose(const Pose2& a, const Pose2& b) {
  const double c = std::cos(a.heading_rad), s = std::sin(a.heading_rad);
  return {a.x_m + c * b.x_m - s * b.y_m, a.y_m + s * b.x_m + c * b.y_m,
          hardware::WrapAngle(a.heading_rad + b.heading_rad)};
}

Pose2 Inverse(const Pose2& a) {
  const double c = std::cos(a.heading_rad), s = std::sin(a.heading_rad);
  return {-c * a.x_m - s * a.y_m, s * a.x_m - c * a.y_m, -a.heading_rad};
}

/// The pose reached by a constant body velocity for unit time, and back. sin(h)/h and
/// (1 - cos(h))/h, by their series where h vanishes.
struct ArcTerms {
  explicit ArcTerms(double h)
      : sine(std::abs(h) < 1e-6 ? 1 - h * h / 6 : std::sin(h) / h),
        versine(std::abs(h) < 1e-6 ? h / 2 : (1 - std::cos(h)) / h) {}
  double sine;
  double versine;
};

Pose2 Exp(const Vector3d& v) {
  const ArcTerms t(v.z());
  return {t.sine * v.x() - t.versine * v.y(), t.versine * v.x() + t.sine * v.y(), v.z()};
}

Vector3d Log(const Pose2& X) {
  const ArcTerms t(X.heading_rad);
  const double det = t.sine * t.sine + t.versine * t.versine;
  return {(t.sine * X.x_m + t.versine * X.y_m) / det, (t.sine * X.y_m - t.versine * X.x_m) / det,
          X.heading_rad};
}

double SmoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vector3d ToVector(const hardware::WalkVelocity& v) {
  return {v.forward_m_s, v.left_m_s, v.turn_rad_s};
}

}  // namespace

hardware::WalkVelocity NaoGaitConfig::MaxVelocity() const {
  return {max_step_forward_m / step_period_s, max_step_aside_m / (2 * step_period_s),
          max_step_turn_rad / (2 * step_period_s)};
}

std::vector<FieldError> NaoGaitConfig::Validate() const {
  std::vector<FieldError> errors;
  const auto check = [&errors](const char* field, double value, double low, double high) {
    if (value >= low && value <= high) return;
    errors.push_back({fmt::format("gait.{}", field), fmt::format("{}", value),
                      fmt::format("must be within [{}, {}]", low, high)});
  };
  check("step_period_s", step_period_s, 0.2, 2);
  check("max_step_forward_m", max_step_forward_m, 0.001, 0.08);
  check("max_step_aside_m", max_step_aside_m, 0.001, 0.06);
  check("max_step_turn_rad", max_step_turn_rad, 0.001, 0.5);
  check("step_height_m", step_height_m, 0, 0.04);
  check("sway_aside_m", sway_aside_m, 0, 0.04);
  check("sway_roll_rad", sway_roll_rad, 0, 0.1);
  check("sway_up_m", sway_up_m, 0, 0.008);
  check("slip_gain", slip_gain, 0, 0.2);
  check("slip_step", slip_step, 0, 0.2);
  check("slip_turn_rad", slip_turn_rad, 0, 0.1);
  return errors;
}

PlanarGait::PlanarGait(const NaoGaitConfig& config, std::uint64_t seed, hardware::Duration tick)
    : config_(config), tick_s_(hardware::ToSeconds(tick)), random_(seed, "nao.slip") {
  hardware::ThrowIfAny(config.Validate());
  ticks_per_step_ = static_cast<int>(std::lround(config.step_period_s / tick_s_));
  step_s_ = ticks_per_step_ * tick_s_;
  for (double& gain : run_gain_) gain = 1 + config.slip_gain * random_.Gaussian();
  StandAt({});
}

void PlanarGait::Move(const hardware::WalkVelocity& velocity) {
  const Vector3d wanted = ToVector(velocity);
  const Vector3d most = ToVector(config_.MaxVelocity());
  recoiling_ = false;
  wanted_ = wanted / std::max(1.0, wanted.cwiseAbs().cwiseQuotient(most).maxCoeff());
  goal_.reset();
  plan_.reset();
  walking_ = walking_ || !wanted_.isZero(0);
}

void PlanarGait::MoveTo(const Pose2& target) {
  recoiling_ = false;
  goal_ = Compose(odometry_, target);
  plan_.reset();
  wanted_.setZero();
  walking_ = true;
}

void PlanarGait::StandAt(const Pose2& X_WB) {
  actual_ = X_WB;
  for (const Eye side : hardware::kBothEyes) foot_[side] = Home(side);
  swing_from_ = swing_to_ = foot_[swing_];
}

void PlanarGait::Advance() {
  if (!walking_) return;
  if (tick_ == 0) BeginStep();
  if (!walking_) return;
  // The middle of the tick: exact for a velocity that changes linearly.
  const Velocity v = from_ + (to_ - from_) * ((tick_ + 0.5) / ticks_per_step_);
  odometry_ = Compose(odometry_, Exp(v * tick_s_));
  actual_ = Compose(actual_, Exp(Slipped(v) * tick_s_));
  if (++tick_ < ticks_per_step_) return;
  tick_ = 0;
  foot_[swing_] = swing_from_ = swing_to_;
  first_step_ = false;
  if (still_steps_ < 2) return;
  still_steps_ = 0;
  recoiling_ = false;
  walking_ = goal_.has_value() || !wanted_.isZero(0);
}

void PlanarGait::Recoil() {
  if (!walking_ || recoiling_) return;
  constexpr double kBack_m = 0.04, kBack_rad = 0.15;
  const Velocity v = from_ + (to_ - from_) * phase();
  const double time_s = std::min(kBack_m / std::max(v.head<2>().norm(), 1e-6),
                                 kBack_rad / std::max(std::abs(v.z()), 1e-6));
  MoveTo(Exp(-v * time_s));
  recoiling_ = true;
  from_ = to_ = Velocity::Zero();
  step_turn_rad_s_ = 0;
  swing_to_ = Home(swing_);
}

void PlanarGait::BeginStep() {
  const bool from_rest = from_.isZero(0) && to_.isZero(0) && still_steps_ == 0;
  from_ = to_;
  to_ = NextVelocity();
  if (from_rest) {
    if (to_.isZero(0)) {
      walking_ = false;
      return;
    }
    first_step_ = true;
  }
  swing_ = from_rest ? FirstSwing() : Other(swing_);
  still_steps_ = to_.isZero(0) ? still_steps_ + 1 : 0;
  const bool moves = !from_.isZero(0) || !to_.isZero(0);
  for (int i = 0; i < 3; ++i) {
    step_gain_[i] = run_gain_[i] + config_.slip_step * random_.Gaussian();
  }
  const double turn = config_.slip_turn_rad * random_.Gaussian();
  step_turn_rad_s_ = moves ? turn / step_s_ : 0;
  swing_from_ = foot_[swing_];
  swing_to_ = Landing();
}

PlanarGait::Velocity PlanarGait::NextVelocity() {
  if (!goal_) return wanted_;
  if (!plan_) {
    // A plan starts at rest.
    if (!from_.isZero(0)) return Velocity::Zero();
    return PlanTowards(*goal_);
  }
  if (--plan_->steps_left > 0) return plan_->velocity;
  goal_.reset();
  plan_.reset();
  return Velocity::Zero();
}

PlanarGait::Velocity PlanarGait::PlanTowards(const Pose2& goal) {
  const Velocity way = Log(Compose(Inverse(odometry_), goal));
  constexpr double kNothing = 1e-5;  // metres and radians
  if (way.cwiseAbs().maxCoeff() < kNothing) {
    goal_.reset();
    return Velocity::Zero();
  }
  const Velocity most = ToVector(config_.MaxVelocity()) * step_s_;
  // Speeding up and slowing down take half a step's way each.
  const int full_steps = std::max(
      1, static_cast<int>(std::ceil(way.cwiseAbs().cwiseQuotient(most).maxCoeff() - 1e-9)));
  plan_ = Plan{way / (full_steps * step_s_), full_steps};
  return plan_->velocity;
}

PlanarGait::Velocity PlanarGait::Slipped(const Velocity& v) const {
  return v.cwiseProduct(step_gain_) + Velocity(0, 0, step_turn_rad_s_);
}

Pose2 PlanarGait::Home(Eye side) const {
  return Compose(actual_, {0, Sign(side) * NaoLeg::kHipAside_m, 0});
}

Eye PlanarGait::FirstSwing() const {
  const double aside = std::abs(to_.z()) > 1e-6 ? to_.z() : to_.y();
  return aside > 0 ? Eye::kLeft : Eye::kRight;
}

Pose2 PlanarGait::Landing() const {
  const Pose2 body = Compose(actual_, Exp(Slipped((from_ + to_) / 2) * step_s_));
  const Velocity ahead = to_.cwiseProduct(step_gain_) * step_s_;
  const auto leads = [this](double aside) { return aside * Sign(swing_) > 0 ? 1.0 : 0.0; };
  const Pose2 stance{0.5 * ahead.x(), leads(ahead.y()) * ahead.y(), leads(ahead.z()) * ahead.z()};
  return Compose(Compose(body, stance), {0, Sign(swing_) * NaoLeg::kHipAside_m, 0});
}

double PlanarGait::phase() const { return static_cast<double>(tick_) / ticks_per_step_; }

Eye PlanarGait::stance() const { return Other(swing_); }

double PlanarGait::sway_envelope() const {
  if (!walking_) return 0;
  if (first_step_) return SmoothStep(phase());
  return still_steps_ == 2 ? 1 - SmoothStep(phase()) : 1;
}

Pose PlanarGait::X_WB() const {
  const double wave = sway_envelope() * std::sin(M_PI * phase());
  const double side = Sign(stance());
  Pose X = hardware::ToPose(actual_);
  X.translate(Vector3d(0, side * config_.sway_aside_m * wave, config_.sway_up_m * wave * wave));
  X.rotate(Eigen::AngleAxisd(-side * config_.sway_roll_rad * wave, Vector3d::UnitX()));
  return X;
}

Pose PlanarGait::X_WF(Eye side) const {
  if (!walking_) return hardware::ToPose(Home(side));
  if (side != swing_) return hardware::ToPose(foot_[side]);
  // In the air from a tenth of the step to nine tenths of it.
  const double t = std::clamp((phase() - 0.1) / 0.8, 0.0, 1.0);
  const double s = SmoothStep(t);
  const double turn = hardware::WrapAngle(swing_to_.heading_rad - swing_from_.heading_rad);
  const double lift = std::sin(M_PI * t);
  return hardware::ToPose(
      {std::lerp(swing_from_.x_m, swing_to_.x_m, s), std::lerp(swing_from_.y_m, swing_to_.y_m, s),
       swing_from_.heading_rad + s * turn},
      config_.step_height_m * lift * lift);
}

void PlanarGait::ResetOdometry() {
  if (goal_) goal_ = Compose(Inverse(odometry_), *goal_);
  odometry_ = {};
}

}  // namespace horopter::sim
