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

FaultyCameras::FaultyCameras(hardware::CameraPair& inner, const std::vector<Fault>& faults)
    : inner_(inner), faults_(faults) {}

hardware::Result<hardware::StereoFrame> FaultyCameras::Grab() {
  auto grabbed = inner_.Grab();
  if (!grabbed.ok()) return grabbed;
  hardware::StereoFrame frame = std::move(grabbed).value();
  const hardware::Time t = frame.left.t_capture;
  for (const Eye eye : hardware::kBothEyes) {
    Freeze(eye, eye == Eye::kLeft ? frame.left : frame.right);
  }
  for (const Fault& fault : faults_) {
    if (std::holds_alternative<SwappedPair>(fault.kind) && fault.when.Contains(t)) {
      std::swap(frame.left, frame.right);
    }
  }
  return frame;
}

void FaultyCameras::Freeze(Eye eye, EyeImage& image) {
  const bool frozen = Active<FrozenFrames>(faults_, eye, image.t_capture);
  if (!frozen || unfrozen_[eye].bgr.empty()) unfrozen_[eye] = Copy(image);
  if (frozen) image.bgr = unfrozen_[eye].bgr.clone();
}

}  // namespace horopter::sim
