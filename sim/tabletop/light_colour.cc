// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/light_colour.h"

#include <cmath>

namespace horopter::sim {

namespace {

double Cubic(double a, double b, double c, double d, double x) {
  return ((a * x + b) * x + c) * x + d;
}

/// Linear red, green, blue (sRGB primaries) of the black body at unit luminance.
Eigen::Vector3d BlackBody(double kelvin) {
  const double k = 1000 / kelvin;
  const double x = kelvin < 4000 ? Cubic(-0.2661239, -0.2343589, 0.8776956, 0.179910, k)
                                 : Cubic(-3.0258469, 2.1070379, 0.2226347, 0.240390, k);
  const double y = kelvin < 2222   ? Cubic(-1.1063814, -1.34811020, 2.18555832, -0.20219683, x)
                   : kelvin < 4000 ? Cubic(-0.9549476, -1.37418593, 2.09137015, -0.16748867, x)
                                   : Cubic(3.0817580, -5.87338670, 3.75112997, -0.37001483, x);
  const Eigen::Vector3d XYZ(x / y, 1, (1 - x - y) / y);
  Eigen::Matrix3d rgb_from_XYZ;
  rgb_from_XYZ << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  return (rgb_from_XYZ * XYZ).cwiseMax(0.0);
}

}  // namespace

Eigen::Vector3d LightColour(double colour_temperature_k) {
  const Eigen::Vector3d white = BlackBody(6500);
  const Eigen::Vector3d ratio = BlackBody(colour_temperature_k).cwiseQuotient(white);
  const double luminance = Eigen::Vector3d(0.2126, 0.7152, 0.0722).dot(ratio);
  return (ratio / luminance).array().pow(1 / 2.2).matrix();
}

}  // namespace horopter::sim
