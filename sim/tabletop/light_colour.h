// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace horopter::sim {

inline constexpr double kLowestColourTemperature_k = 1700;
inline constexpr double kHighestColourTemperature_k = 20000;

/// How much of red, green and blue a lamp of a colour temperature gives, relative to one of 6500 K
/// that is as bright (luminance of Rec. 709), in display values: what OpenGL multiplies colours by.
///
/// Chromaticity of the black body by the cubic fits of Kang et al. 2002 ("Design of advanced color
/// temperature control system for HDTV applications"), then sRGB's matrix and a gamma of 2.2.
/// @pre within the two limits
Eigen::Vector3d LightColour(double colour_temperature_k);

}  // namespace horopter::sim
