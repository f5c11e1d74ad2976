// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hardware/types/eye.h"
#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/render/render_request.h"
#include "sim/truth/ground_truth.h"
#include "sim/truth/scene_snapshot.h"

namespace horopter::scenarios {

/// Finds out what is true of frame after frame: depth, ids and normals of every eye, disparity
/// within pairs and between the cameras that the request names, flow from the frame before. Each
/// image has a scene of its own, that of the instant it was taken at.
class FrameTruth {
 public:
  /// Shared: the images of one instant, and the frame after, refer to it.
  using Scene = std::shared_ptr<const sim::SceneSnapshot>;

  /// @param request,model outlive this @throws SceneError
  FrameTruth(const RenderRequest& request, const mjModel& model);

  /// The scene of an instant. @param data of the model, kinematics up to date
  Scene SceneOf(const mjData& data) const;

  /// Fills a frame whose eyes have their views.
  /// @param scenes of each pair's images, in the frame's order
  void Add(const std::vector<hardware::PerEye<Scene>>& scenes, DatasetFrame& frame);

 private:
  /// What an eye saw in the frame before.
  struct Seen {
    Scene scene;
    sim::EyeTruth truth;
  };
  struct SeenPair {
    Seen left;
    Seen right;

    const Seen& operator[](hardware::Eye eye) const {
      return eye == hardware::Eye::kLeft ? left : right;
    }
  };
  struct Camera {
    const DatasetEye* eye;
    Scene scene;
  };

  void AddBetween(const std::vector<hardware::PerEye<Scene>>& scenes, DatasetFrame& frame) const;

  const RenderRequest& request_;
  std::shared_ptr<const sim::SceneShapes> shapes_;  ///< shared with every snapshot
  std::vector<SeenPair> previous_;                  ///< by pair; empty before the first frame
};

}  // namespace horopter::scenarios
