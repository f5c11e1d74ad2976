// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/mount_faults.h"

#include <fmt/format.h>

#include <utility>

namespace horopter::sim {
namespace {

using hardware::Eye;

/// From a body up to the world, the world left out.
std::vector<int> Ancestry(const mjModel& model, int body) {
  std::vector<int> bodies;
  for (; body != 0; body = model.body_parentid[body]) bodies.push_back(body);
  return bodies;
}

/// Turn of a camera about its optical centre, in MuJoCo's camera axes (x right, y up, z backward).
Eigen::Quaterniond Turn(const MisalignedEye& eye) {
  const Eigen::AngleAxisd pitch(-eye.pitch_rad, Eigen::Vector3d::UnitX());
  const Eigen::AngleAxisd roll(-eye.roll_rad, Eigen::Vector3d::UnitZ());
  return pitch * roll;
}

mjtNum* PositionOf(mjModel& model, int body, int camera) {
  return body >= 0 ? model.body_pos + 3 * body : model.cam_pos + 3 * camera;
}

}  // namespace

MountFaults::MountFaults(World& world, const std::vector<Fault>& faults,
                         hardware::PerEye<std::string> cameras)
    : world_(world), cameras_(std::move(cameras)) {
  for (const Fault& fault : faults) {
    if (const auto* baseline = std::get_if<WrongBaseline>(&fault.kind)) {
      baselines_.push_back({*baseline, fault.when});
    } else if (const auto* eye = std::get_if<MisalignedEye>(&fault.kind)) {
      misaligned_.push_back({*eye, fault.when});
    }
  }
  if (none()) return;
  FindMounts();
  RequireApart();
}

void MountFaults::FindMounts() {
  mjModel& model = world_.mutable_model();
  hardware::PerEye<std::vector<int>> chains;
  for (const Eye eye : hardware::kBothEyes) {
    mounts_[eye].camera = world_.Id(mjOBJ_CAMERA, cameras_[eye]);
    chains[eye] = Ancestry(model, model.cam_bodyid[mounts_[eye].camera]);
  }
  while (!chains.left.empty() && !chains.right.empty() &&
         chains.left.back() == chains.right.back()) {
    chains.left.pop_back();
    chains.right.pop_back();
  }
  for (const Eye eye : hardware::kBothEyes) {
    Mount& mount = mounts_[eye];
    if (!chains[eye].empty()) mount.body = chains[eye].back();
    mount.sound_position =
        Eigen::Map<const Eigen::Vector3d>(PositionOf(model, mount.body, mount.camera));
    const mjtNum* wxyz = model.cam_quat + 4 * mount.camera;
    mount.sound_camera = Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  }
}

void MountFaults::RequireApart() const {
  double nearest = 0;
  for (const auto& baseline : baselines_) nearest += std::min(0.0, baseline.what.error_m);
  const double apart = (mounts_.left.sound_position - mounts_.right.sound_position).norm();
  if (apart + nearest > 0 || baselines_.empty()) return;
  throw hardware::ConfigError(
      {{"faults.wrong_baseline.error_m", fmt::format("{:g}", nearest),
        fmt::format("must leave the eyes, {:g} m apart, on their own sides", apart)}});
}

void MountFaults::Update(hardware::Time t) {
  bool changed = false;
  const auto look = [&](auto& faults) {
    for (auto& fault : faults) {
      const bool active = fault.when.Contains(t);
      changed = changed || active != fault.active;
      fault.active = active;
    }
  };
  look(baselines_);
  look(misaligned_);
  if (!changed) return;
  for (const Eye eye : hardware::kBothEyes) Place(eye);
  world_.Forward();
}

double MountFaults::BaselineError() const {
  double error_m = 0;
  for (const auto& baseline : baselines_) {
    if (baseline.active) error_m += baseline.what.error_m;
  }
  return error_m;
}

void MountFaults::Place(Eye eye) {
  mjModel& model = world_.mutable_model();
  const Mount& mount = mounts_[eye];
  const Mount& other = mounts_[eye == Eye::kLeft ? Eye::kRight : Eye::kLeft];
  const Eigen::Vector3d outward = (mount.sound_position - other.sound_position).normalized();
  Eigen::Map<Eigen::Vector3d>{PositionOf(model, mount.body, mount.camera)} =
      mount.sound_position + outward * BaselineError() / 2;
  Eigen::Quaterniond q = mount.sound_camera;
  for (const auto& fault : misaligned_) {
    if (fault.active && fault.what.eye == eye) q = q * Turn(fault.what);
  }
  Eigen::Map<Eigen::Vector4d>{model.cam_quat + 4 * mount.camera} << q.w(), q.x(), q.y(), q.z();
}

}  // namespace horopter::sim
