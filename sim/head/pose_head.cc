// SPDX-License-Identifier: Apache-2.0
#include "sim/head/pose_head.h"

#include <string>

namespace horopter::sim {

void PoseHead(World& world, const hardware::HeadAngles& angles) {
  const hardware::HeadAxisArray position = hardware::ToArray(angles);
  bool any = false;
  for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
    const std::string name(hardware::kHeadAxisNames[axis]);
    const int joint = mj_name2id(&world.model(), mjOBJ_JOINT, name.c_str());
    if (joint < 0) continue;
    world.mutable_data().qpos[world.model().jnt_qposadr[joint]] = position[axis];
    any = true;
  }
  if (!any) {
    throw SceneError(world.path().string() +
                     " has no head: no joint named neck_pan, left_pan, right_pan, ...");
  }
  world.Forward();
}

}  // namespace horopter::sim
