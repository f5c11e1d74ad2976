// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "vision/disparity/cell_image.h"
#include "vision/disparity/edge_map.h"

namespace horopter::vision {

/// One octave of one eye's image, as the search reads it.
struct ViewOctave {
  int width = 0;
  int height = 0;
  PaddedMap<float> grey;
  cv::Mat colour;  ///< CV_8UC1 or CV_8UC3
  CellImage cells;
  EdgeMap edges;
};

/// The octaves of an eye's image: [1 4 6 4 1]/16 and every second pixel, pixel (x, y) of one on
/// (2x, 2y) of the one before. Buffers are kept from image to image.
class ViewPyramid {
 public:
  /// The octaves' images.
  /// @param image CV_8UC1 or CV_8UC3
  /// @param octaves at most so many, none with a side under 2 px but the first
  void Build(const cv::Mat& image, int octaves);

  /// Cells and edges of the octaves from `finest` on, or of the coarsest alone where there are
  /// fewer.
  /// @param noise_grey deviation of the image's noise [grey levels]: edges count from
  ///   kEdgeNoise times that on, as much of it as pyramids leave
  void Respond(int finest, double noise_grey, const CellBank& bank,
               const ClosedFormKernels& kernels);
  static constexpr double kEdgeNoise = 6;

  int size() const { return size_; }
  int finest() const { return finest_; }
  /// Of the full image (NoiseLevel).
  double noise_grey() const { return noise_grey_; }
  /// Of the second octave, or the only one (TextureLevel).
  double texture_grey() const { return texture_grey_; }
  const ViewOctave& operator[](int octave) const { return octaves_[octave]; }

 private:
  void Halve(int octave);

  int size_ = 0;
  int finest_ = 0;
  double noise_grey_ = 0;
  double texture_grey_ = 0;
  cv::Mat1b grey_8_;
  std::vector<ViewOctave> octaves_;
};

}  // namespace horopter::vision
