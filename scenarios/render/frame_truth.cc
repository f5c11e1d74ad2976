// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/frame_truth.h"

#include <stdexcept>
#include <utility>

#include "sim/truth/correspondence.h"

namespace horopter::scenarios {
namespace {

using hardware::Eye;

DatasetEye& EyeOf(DatasetPair& pair, Eye eye) { return eye == Eye::kLeft ? pair.left : pair.right; }

Eye Other(Eye eye) { return eye == Eye::kLeft ? Eye::kRight : Eye::kLeft; }

}  // namespace

FrameTruth::FrameTruth(const RenderRequest& request, const mjModel& model)
    : request_(request), shapes_(std::make_shared<const sim::SceneShapes>(model)) {}

FrameTruth::Scene FrameTruth::SceneOf(const mjData& data) const {
  return std::make_shared<const sim::SceneSnapshot>(shapes_, data);
}

void FrameTruth::Add(const std::vector<hardware::PerEye<Scene>>& scenes, DatasetFrame& frame) {
  std::vector<SeenPair> seen;
  for (std::size_t i = 0; i < frame.pairs.size(); ++i) {
    DatasetPair& pair = frame.pairs[i];
    const auto see = [&](Eye eye) {
      const Scene& scene = scenes[i][eye];
      return Seen{scene, sim::CaptureEyeTruth(*scene, EyeOf(pair, eye).view)};
    };
    const SeenPair& now = seen.emplace_back(SeenPair{see(Eye::kLeft), see(Eye::kRight)});
    for (const Eye eye : hardware::kBothEyes) {
      DatasetEye& image = EyeOf(pair, eye);
      image.truth = now[eye].truth;
      image.to_other_eye = sim::TrueCorrespondence(
          *now[eye].scene, now[eye].truth, *now[Other(eye)].scene, EyeOf(pair, Other(eye)).view);
      if (previous_.empty()) continue;
      const Seen& before = previous_[i][eye];
      image.flow_from_previous =
          sim::TrueFlow(*before.scene, before.truth, *now[eye].scene, image.view);
    }
  }
  AddBetween(scenes, frame);
  previous_ = std::move(seen);
}

void FrameTruth::AddBetween(const std::vector<hardware::PerEye<Scene>>& scenes,
                            DatasetFrame& frame) const {
  const auto named = [&](const std::string& stem) -> Camera {
    for (std::size_t i = 0; i < frame.pairs.size(); ++i) {
      DatasetPair& pair = frame.pairs[i];
      for (const Eye eye : hardware::kBothEyes) {
        const std::string name = (pair.name.empty() ? "" : pair.name + "_") + ToString(eye);
        if (name == stem) return {&EyeOf(pair, eye), scenes[i][eye]};
      }
    }
    throw std::logic_error("no camera " + stem);
  };
  for (const std::string& asked : request_.between) {
    const std::size_t colon = asked.find(':');
    const std::string one = asked.substr(0, colon), other = asked.substr(colon + 1);
    const Camera first = named(one), second = named(other);
    const auto field = [](const Camera& from, const Camera& to) {
      return sim::TrueCorrespondence(*from.scene, *from.eye->truth, *to.scene, to.eye->view);
    };
    frame.between.push_back({one, other, field(first, second)});
    frame.between.push_back({other, one, field(second, first)});
  }
}

}  // namespace horopter::scenarios
