// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::vision {

/// Parameters of the closed form. "Measured" is on the Motorcycle pair, verged by (2, 0.3, 0.5) deg
/// (results/paper/disparity.md has the ablation); the defaults are those of the preset "accurate".
struct ClosedFormConfig {
  // --- Simple cells ---

  /// Orientations theta = i * pi / orientations. Measured, on all three turns: 8 add 0.1 to 0.3
  /// points of density and nothing to the median; 4 cost 0.4 to 1 point.
  int orientations = 6;
  /// Width of the filters.
  int filter_px = 9;
  /// Radial peak frequency [cycles/px] and deviation of the envelope [px]. Receptive fields much
  /// smaller than the published ones (0.25, 2.25) keep to one side of a depth edge; pooling makes
  /// up for what they lose in noise.
  double peak_frequency = 0.38;
  double envelope_sigma_px = 1.2;
  /// Semi-saturation of the divisive normalisation [grey levels].
  double saturation_grey = 0.5;

  // --- Where hypotheses come from ---

  /// The coarsest octave, where every disparity within +-search_x_px, +-search_y_px (at full size)
  /// competes. No range need be known beforehand: at 1/16 there are few pixels to try them at, and
  /// so wide a range (45 % of a VGA image's width, and what a head's eyes are apart vertically,
  /// with room to spare) takes a twentieth of the time. Disparities beyond it are not found: a
  /// larger image of the same scene needs a larger one.
  int search_octave = 4;
  int search_x_px = 288;
  int search_y_px = 48;
  /// Octaves, of 1 (half size) to search_octave - 1, where all disparities between the field's 2
  /// and 98 % compete anew, at the pixel's own dy and one above and below; to < from: none. It
  /// finds what is too small for the coarser octaves.
  int explore_from = 1;
  int explore_to = 2;
  /// Neighbours whose disparity is tried, in four directions at each of these distances [px]; the
  /// fourth in three directions, so that they fill kLanes with the pixel's own. Near ones carry a
  /// surface on, far ones across what hides it: without the two farthest density falls by 4 to 7
  /// points.
  std::array<int, 4> neighbour_px = {1, 4, 14, 44};
  /// Competitions for each octave. Measured: a second one finds a point of density more and as
  /// many false matches among them as a lower min_coherence lets in, which costs no time.
  int rounds = 1;
  /// Also disparities 2 px from the pixel's own compete, in the first round of octaves from this
  /// one on.
  int try_steps_from = 0;
  /// What the pixel's own hypothesis has ahead of others, as a part of perfect correlation: without
  /// it a slanted surface becomes stairs of equally good hypotheses.
  double favour_own = 0.02;
  /// The last octave that is matched; the field is then doubled to full size. 0: full size.
  int finest_octave = 0;
  /// Octaves are not matched where noise is more than this multiple of the texture's contrast
  /// (NoiseLevel of the image, TextureLevel at half its size): receptive fields as small as these
  /// are drowned by it. Each octave has about a third of the noise of the one before.
  double max_noise_to_texture = 1;

  // --- Pooling: domain transform filters of the left image's colours ---

  /// Deviation [px] on plain ground, and the sum of colour differences that counts as much as that
  /// many pixels. Scores decide between surfaces, so that a small step of colour stops them: pooled
  /// across edges they make half as many false matches again. Of scores:
  double score_pool_px = 4;
  double score_pool_grey = 20;
  /// Of binocular products, which only average: wider is smoother, and edges matter less.
  double product_pool_px = 4;
  double product_pool_grey = 60;

  // --- Refinement ---

  /// Intersections of constraints for each octave, at least `rounds`: the ones beyond follow the
  /// last competition.
  int iterations = 3;
  /// Before each, the field is averaged over this many pixels to either side, as far as they lie
  /// within smooth_step_px. Pooled products tell a neighbourhood's mean correction, so that they
  /// must be added to its mean disparity: added to each pixel's own they leave its noise.
  int smooth_px = 4;
  double smooth_step_px = 1;
  /// Part of the trace added to the diagonal of the least squares: where all orientations see one
  /// direction, the field does not move along the other.
  double ridge = 0.02;
  /// Largest step of an intersection [px]; a phase says no more than +-1.3.
  double max_step_px = 2;
  /// Median of the disparity after each octave: 0 (none), 3 or 5. Without it false matches of a few
  /// pixels reach the next octave, and 12 points of density are lost to the checks.
  int median_px = 5;

  // --- Checks ---

  /// Pooled binocular correlation of the winning hypothesis below which it is invalid. It is that
  /// of the last competition, before the intersections of constraints that follow. Chosen for a
  /// density of 0.80 on the least dense of the three turns.
  double min_coherence = 0.23;
  /// Largest distance between a pixel and where its match points back to [px]; 0 = no check, half
  /// the time and half as many false matches again.
  double left_right_px = 0.8;
  /// Smallest segment of smooth disparity that is kept [px], and the largest step inside one: false
  /// matches come as islands.
  int min_segment_px = 200;
  double segment_step_px = 1;
  /// Give invalid pixels the disparity around them (FillIn), marked as such.
  bool fill_in = false;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;
};

}  // namespace horopter::vision
