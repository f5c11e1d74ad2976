// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/world_state.h"

namespace horopter::sim {

WorldState ReadWorldState(const World& world) {
  const mjModel& model = world.model();
  const mjData& data = world.data();
  WorldState state{world.now(), {}, {}, world.Contacts()};
  for (int body = 1; body < model.nbody; ++body) {
    hardware::Pose X_WB = hardware::Pose::Identity();
    X_WB.translation() = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * body);
    X_WB.linear() =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + 9 * body);
    state.bodies.push_back({world.Name(mjOBJ_BODY, body), X_WB});
  }
  for (int joint = 0; joint < model.njnt; ++joint) {
    const int type = model.jnt_type[joint];
    if (type != mjJNT_HINGE && type != mjJNT_SLIDE) continue;
    state.joints.push_back({world.Name(mjOBJ_JOINT, joint),
                            type == mjJNT_HINGE ? JointKind::kHinge : JointKind::kSlide,
                            data.qpos[model.jnt_qposadr[joint]],
                            data.qvel[model.jnt_dofadr[joint]]});
  }
  return state;
}

}  // namespace horopter::sim
