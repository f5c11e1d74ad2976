// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace horopter::vision {

/// The deviation of an image's noise, from the image alone [grey levels]: the median magnitude of a
/// second difference in x and y, which cancels brightness, slopes and straight edges (the operator
/// of Immerkaer, "Fast Noise Variance Estimation", CVIU 1996). Fine texture counts as noise: an
/// upper bound. 0 for an image with a side under 3 px.
double NoiseLevel(const cv::Mat1f& grey);

/// The contrast of what is textured in an image, noise included, in the unit of NoiseLevel [grey
/// levels]: the same differences, of which a fifth is larger. Of an image of half the size, where
/// little noise is left, it tells what texture the full one has to set against its noise.
double TextureLevel(const cv::Mat1f& grey);

/// What is left of white noise of the full image at an octave of its [1 4 6 4 1]/16 pyramid.
double NoiseAtOctave(double noise_grey, int octave);

}  // namespace horopter::vision
