// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"

/// Equations (1) and (2) of Chessa et al. 2014 ("3D Reconstruction"), in the paper's own axes.
///
/// Frame P: origin midway between the optical centres, x right, y up, z backward (the cameras look
/// along -z). Image coordinates are normalised (focal length 1, principal point and distortion
/// taken out), x right and y up. The paper's alpha is positive to the right, beta positive down.
/// Everything outside this header uses body axes and optical frames.
namespace horopter::vision {

/// Rotation that maps the paper's axes into body axes: p_H = PaperToBody() * p_P.
Eigen::Matrix3d PaperToBody();

/// One eye as equation (1) sees it: the numerators' and the denominator's coefficients.
struct PaperEye {
  Eigen::Vector3d right;    ///< of x: (cos a, 0, sin a)
  Eigen::Vector3d up;       ///< of y: (sin a sin b, cos b, -cos a sin b)
  Eigen::Vector3d forward;  ///< of the denominator: (sin a cos b, -sin b, -cos a cos b)
  Eigen::Vector3d centre;   ///< optical centre; (-+b/2, 0, 0) in the paper
};

/// An eye that turns by pan and tilt (body conventions: pan positive to the left) about its optical
/// centre, as the paper has it, or about a point `axis_to_optical_centre_m` behind that.
PaperEye EyeFromAngles(const hardware::PanTilt& angles, hardware::Eye eye, double baseline_m,
                       double axis_to_optical_centre_m = 0);

/// An eye anywhere in the head. @param X_HC optical frame in the head frame
PaperEye EyeFromPose(const hardware::Pose& X_HC);

/// A 4x3 system A F = b for one pair of homologous image points.
struct EquationTwo {
  Eigen::Matrix<double, 4, 3> A;
  Eigen::Vector4d b;
};

/// Both rows of equation (2) for each eye.
/// @param left, right normalised image points, y up
EquationTwo MakeEquationTwo(const PaperEye& left_eye, const Eigen::Vector2d& left,
                            const PaperEye& right_eye, const Eigen::Vector2d& right);

/// The ordinary least squares solution (A^T A)^-1 A^T b, in closed form.
/// @return F in frame P; not finite when the two rays are parallel
Eigen::Vector3d SolveNormalEquations(const EquationTwo& system);

}  // namespace horopter::vision
