// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/ground_truth.h"

namespace horopter::sim {
namespace {

EyeTruth CaptureEye(Renderer& renderer, const EyeView& view) {
  RenderedView seen =
      renderer.Render(view.X_WC, view.camera, {.rgb = false, .depth = true, .ids = true});
  return {view, seen.depth, seen.ids};
}

}  // namespace

GroundTruth CaptureGroundTruth(const World& world, Renderer& renderer, const EyeView& left,
                               const EyeView& right, const hardware::Pose& X_WBase,
                               const hardware::HeadAngles& head) {
  return {world.now(),     CaptureEye(renderer, left), CaptureEye(renderer, right), X_WBase, head,
          world.Contacts()};
}

}  // namespace horopter::sim
