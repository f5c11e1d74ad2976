// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace horopter::sim {

/// The modelview matrix of an eye at `from` that looks along `forward`, in the floating-point steps
/// of mjr_render, so that the pixels are the same bits: OpenGL's eye axes, x right, y up, -z
/// forward.
Eigen::Matrix4f LookAlong(const float from[3], const float forward[3], const float up[3]);

/// An upright direction for a light that looks along `forward`, as mjr_render picks it.
Eigen::Vector3f UprightFor(const float forward[3]);

}  // namespace horopter::sim
