// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>
#include <string>
#include <vector>

#include "sim/random/random_stream.h"

namespace horopter::sim {

/// What printed things are laid out with. Lengths in metres on the surface, x right and y down.

struct Rectangle {
  double left_m;
  double top_m;
  double right_m;
  double bottom_m;

  double width_m() const { return right_m - left_m; }
  double height_m() const { return bottom_m - top_m; }
  bool Contains(double x, double y) const {
    return x >= left_m && x < right_m && y >= top_m && y < bottom_m;
  }
};

/// A saturated colour of a drawn hue and value, B G R.
cv::Vec3f RandomColour(RandomStream& random, float saturation);

/// Colour of a hue (0 red, 120 green, 240 blue), saturation 0 to 1 and value 0 to 255, B G R.
cv::Vec3f HueColour(double hue_deg, float saturation, float value);

/// Words of random length in lines that fill a rectangle: print that is too small to read.
class TextBlock {
 public:
  TextBlock(RandomStream& random, const Rectangle& area, double line_m);

  bool Inked(double x, double y) const;

 private:
  Rectangle area_;
  double line_m_;
  std::vector<std::vector<double>> edges_;  ///< per line, ascending: word begins, ends, begins ...
};

/// A word in capital letters that fills a rectangle, as bold as a brand's name.
class Lettering {
 public:
  /// @param word may be empty: no ink then
  Lettering(const std::string& word, const Rectangle& area);

  /// How much of the point is ink, 0 to 1.
  float Ink(double x, double y) const;

 private:
  Rectangle area_;
  cv::Mat1b mask_;
};

/// The vertical bars of an article number.
class Barcode {
 public:
  Barcode(RandomStream& random, const Rectangle& area);

  const Rectangle& area() const { return area_; }
  /// @pre the point is in area()
  bool Inked(double x) const;

 private:
  Rectangle area_;
  std::vector<double> edges_;
};

}  // namespace horopter::sim
