// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/frame_faults.h"

#include <algorithm>

#include "sim/random/random_stream.h"

namespace horopter::sim {

using hardware::Eye;
using hardware::Time;

FrameFaults::FrameFaults(const std::vector<Fault>& faults, std::uint64_t seed) {
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (const auto* lost = std::get_if<LostFrames>(&faults[i].kind)) {
      losses_.push_back({*lost, faults[i].when, RandomStream(seed, StreamName(faults, i)).Next()});
    } else if (const auto* dark = std::get_if<DarkEye>(&faults[i].kind)) {
      darkness_.push_back({*dark, faults[i].when});
    }
  }
}

double FrameFaults::Light(Eye eye, Time t) const {
  double light = 1;
  for (const Darkness& dark : darkness_) {
    if (dark.what.eye == eye && dark.when.Contains(t)) light *= dark.what.light;
  }
  return light;
}

bool FrameFaults::Loses(Eye eye, std::uint64_t frame, Time t) const {
  if (frame == 0) return false;
  return std::any_of(losses_.begin(), losses_.end(), [&](const Loss& loss) {
    return loss.what.eye == eye && loss.when.Contains(t) &&
           UniformOf(loss.stream, frame) < loss.what.share;
  });
}

}  // namespace horopter::sim
