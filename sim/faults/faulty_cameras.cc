// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/faulty_cameras.h"

#include <utility>

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::EyeImage;

EyeImage Copy(const EyeImage& image) { return {image.bgr.clone(), image.t_capture}; }

/// Whether a fault of this kind is there for the eye at time t.
template <typename Kind>
bool Active(const std::vector<Fault>& faults, Eye eye, hardware::Time t) {
  for (const Fault& fault : faults) {
    const auto* kind = std::get_if<Kind>(&fault.kind);
    if (kind != nullptr && kind->eye == eye && fault.when.Contains(t)) return true;
  }
  return false;
}

}  // namespace

FaultyCameras::FaultyCameras(hardware::CameraPair& inner, const std::vector<Fault>& faults,
                             std::uint64_t seed)
    : inner_(inner), faults_(faults) {
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (const auto* lost = std::get_if<LostFrames>(&faults[i].kind)) {
      losses_.push_back({*lost, faults[i].when, RandomStream(seed, StreamName(faults, i))});
    }
  }
}

hardware::Result<hardware::StereoFrame> FaultyCameras::Grab() {
  auto grabbed = inner_.Grab();
  if (!grabbed.ok()) return grabbed;
  hardware::StereoFrame frame = std::move(grabbed).value();
  const hardware::Time t = frame.left.t_capture;
  for (const Eye eye : hardware::kBothEyes) {
    EyeImage& image = eye == Eye::kLeft ? frame.left : frame.right;
    Darken(eye, image);
    Freeze(eye, image);
    Lose(eye, image);
  }
  for (const Fault& fault : faults_) {
    if (std::holds_alternative<SwappedPair>(fault.kind) && fault.when.Contains(t)) {
      std::swap(frame.left, frame.right);
    }
  }
  return frame;
}

void FaultyCameras::Darken(Eye eye, EyeImage& image) const {
  for (const Fault& fault : faults_) {
    const auto* dark = std::get_if<DarkEye>(&fault.kind);
    if (dark == nullptr || dark->eye != eye || !fault.when.Contains(image.t_capture)) continue;
    image.bgr.convertTo(image.bgr, -1, dark->light);
  }
}

void FaultyCameras::Freeze(Eye eye, EyeImage& image) {
  const bool frozen = Active<FrozenFrames>(faults_, eye, image.t_capture);
  if (!frozen || unfrozen_[eye].bgr.empty()) unfrozen_[eye] = Copy(image);
  if (frozen) image.bgr = unfrozen_[eye].bgr.clone();
}

void FaultyCameras::Lose(Eye eye, EyeImage& image) {
  bool lost = false;
  for (Loss& loss : losses_) {
    if (loss.what.eye != eye) continue;
    // Drawn for every frame, so that what is lost does not depend on when the fault begins.
    const bool hit = loss.random.Uniform(0, 1) < loss.what.share;
    lost = lost || (hit && loss.when.Contains(image.t_capture));
  }
  if (lost && !delivered_[eye].bgr.empty()) {
    image = Copy(delivered_[eye]);
  } else {
    delivered_[eye] = Copy(image);
  }
}

}  // namespace horopter::sim
