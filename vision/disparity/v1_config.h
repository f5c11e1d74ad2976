// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::vision {

/// Orientations theta = i * pi / 8 of the Gabor bank, and phase shifts per orientation.
inline constexpr int kOrientations = 8;
inline constexpr int kPhaseShifts = 7;

/// How the model is computed.
enum class V1Form {
  /// As published: each pixel has kOrientations x kPhaseShifts energy neurons, whose activity is
  /// decoded. The readable reference.
  kPopulation,
  /// One complex product for each orientation, which holds the energy at every phase shift:
  /// energy^2 = |L|^2 + |R|^2 + 2 |L| |R| cos(phase difference + shift). Hypotheses compete by it.
  kClosedForm
};

/// Parameters of the closed form. "Measured" is on the Motorcycle pair, verged by (2, 0.3, 0.5) deg
/// (results/paper/disparity.md has the ablation); the defaults are those of the preset "accurate".
struct ClosedFormConfig {
  // --- Simple cells ---

  /// Orientations theta = i * pi / orientations. Measured, on all three turns: 8 change density by
  /// -0.9 to +0.7 points, the median by at most 0.002 px; 4 cost 0.6 to 0.8 points.
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
  /// competes. No range need be known beforehand: at 1/16 there are few pixels to try them at.
  int search_octave = 4;
  int search_x_px = 288;
  int search_y_px = 48;
  /// Octaves, of 1 (half size) to search_octave - 1, where all disparities between the field's 2
  /// and 98 % compete anew, at the pixel's own dy and one above and below; to < from: none. It
  /// finds what is too small for the coarser octaves.
  int explore_from = 1;
  int explore_to = 2;
  /// Neighbours whose disparity is tried, in four directions at each of these distances [px]; the
  /// fourth in three directions, so that they fill kLanes with the pixel's own.
  std::array<int, 4> neighbour_px = {1, 4, 14, 44};
  /// Competitions for each octave.
  int rounds = 2;
  /// Also disparities 2 px from the pixel's own compete, in the first round of octaves from this
  /// one on.
  int try_steps_from = 0;
  /// What the pixel's own hypothesis has ahead of others, as a part of perfect correlation: without
  /// it a slanted surface becomes stairs of equally good hypotheses.
  double favour_own = 0.02;
  /// The last octave that is matched; the field is then doubled to full size. 0: full size.
  int finest_octave = 0;

  // --- Pooling: domain transform filters of the left image's colours ---

  /// Deviation [px] on plain ground, and the sum of colour differences that counts as much as that
  /// many pixels. Of scores:
  double score_pool_px = 4;
  double score_pool_grey = 20;
  /// Of binocular products.
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
  /// Part of the trace added to the diagonal of the least squares.
  double ridge = 0.02;
  /// Largest step of an intersection [px].
  double max_step_px = 2;
  /// Median of the disparity after each octave: 0 (none), 3 or 5.
  int median_px = 5;

  // --- Checks ---

  /// Pooled binocular correlation of the winning hypothesis below which it is invalid.
  double min_coherence = 0.31;
  /// Largest distance between a pixel and where its match points back to [px]; 0 = no check, and
  /// half the time.
  double left_right_px = 0.8;
  /// Smallest segment of smooth disparity that is kept [px], and the largest step inside one.
  int min_segment_px = 200;
  double segment_step_px = 1;
  /// Give invalid pixels the disparity around them (FillIn), marked as such.
  bool fill_in = false;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;
};

/// Parameters of the V1 binocular energy model; those of the population form come first.
///
/// "2009" below is the model of Chessa, Sabatini & Solari, "A fast joint bioinspired algorithm for
/// optic flow and two-dimensional disparity estimation", ICVS 2009. The defaults are those of the
/// preset "checked"; Preset("paper_2009") takes the additions away.
struct V1Config {
  V1Form form = V1Form::kPopulation;
  /// Read when `form` is kClosedForm, and then alone.
  ClosedFormConfig closed_form;

  // --- Simple cells: the Gabor bank ---

  /// Width of the filters. 2009: 11x11.
  int filter_px = 11;
  /// Radial peak frequency [cycles/px]. 2009: 0.25, the highest that an octave pyramid needs.
  double peak_frequency = 0.25;
  /// Deviation of the Gaussian envelope [px]: a bandwidth of a third of the peak frequency. 2009.
  double envelope_sigma_px = 2.25;

  // --- Population: binocular energy and its decoding ---

  /// The phase shifts prefer disparities spread evenly over +-this. 2009: 1.5 px in steps of 0.5.
  double max_disparity_px = 1.5;
  /// Responses, scaled over phase to [0, 1], count in the centre of mass from here up. 2009: 0.7.
  double response_threshold = 0.7;
  /// Count responses by their excess over the threshold, not by their value. 2009: false. The
  /// centre of mass then moves with the disparity steadily instead of in steps of the phase grid.
  bool soft_threshold = true;
  /// Semi-saturation of the divisive normalisation [grey levels].
  double saturation_grey = 0.5;
  /// Deviation of the sensor's noise at full size [grey levels]; an octave halves it. 2009 has only
  /// a threshold against rounding. 1 suits a good camera's 8 bits; say more for a noisier one.
  double noise_grey = 1;
  /// A pixel is textureless at a scale where its mean binocular energy is below this multiple of
  /// what noise alone makes. Over a pixel's population noise deviates by about a fifth of its mean.
  double min_signal_to_noise = 2;
  /// Peak of an orientation, relative to the mean response of the pixel, from which it counts.
  /// 0 = any: the intersection of constraints copes with weak orientations, and gains by them.
  double min_orientation_response = 0;

  // --- Intersection of constraints ---

  /// Orientations that must count at a pixel. 2009: 3.
  int min_orientations = 3;
  /// Smallest ratio of the eigenvalues of the least squares: below it the pixel sees one direction
  /// only (the aperture problem).
  double min_conditioning = 0.05;
  /// Weigh each orientation by its energy. 2009: false, all that count count alike.
  bool energy_weights = true;
  /// Deviation of the Gaussian over which neighbours share their constraints [px]; 0 = none (2009).
  /// The spatial pooling of Chessa & Solari 2018, done on constraints.
  double pooling_sigma_px = 1.5;

  // --- Coarse to fine ---

  /// Octaves; the reach is +-max_disparity_px * (2^scales - 1). 2009: 6, +-94 px.
  int scales = 6;
  /// Octaves stop before an image side would be less than this.
  int min_side_px = 8;
  /// Decodings per scale, each around the last one's result. 2009: 1.
  int iterations = 2;
  /// Median of the disparity after each scale: 0 (none, 2009), 3 or 5.
  int median_px = 5;
  /// Where the finest scales see nothing, a coarser estimate is kept up to this many octaves; an
  /// unconfirmed one is invalid. 2009: all.
  int max_kept_octaves = 2;

  // --- Checks ---

  /// Smallest binocular correlation of a match, -1 to 1 (PopulationDisparity): it finds what only
  /// one eye sees, and matches beyond the reach. Below it the match is invalid. -1 = any (2009).
  double min_correlation = 0.45;
  /// Largest distance between a pixel and where its match in the right image points back to [px];
  /// 0 = no check (2009). It finds occlusions and most false matches, at twice the time.
  double left_right_px = 1;
  /// Pixels this close to the border of either image are invalid [px]: the receptive fields of
  /// their coarser octaves see mostly the repeated border. 0 = none (2009).
  int border_px = 0;
  /// Smallest segment of smooth disparity that is kept [px]; 0 = any (2009). It finds the islands
  /// of false matches that plain surfaces and unreachable disparities leave.
  int min_segment_px = 200;
  /// Largest step of disparity between neighbours of one segment [px].
  double segment_step_px = 1;

  /// Every field that does not hold, of the form that is chosen.
  std::vector<hardware::FieldError> Validate() const;

  /// Closed form: "accurate": its defaults. "fast": one round, fewer octaves explored. "realtime":
  /// the same at half size, doubled. "dense": "accurate", filled in.
  /// Population form: "checked": the defaults above. "cautious": what a robot may drive by, webcam
  /// noise and only what the finest octave itself sees, at the price of density. "paper_2009": the
  /// published model alone.
  /// @throws std::invalid_argument that lists the known names.
  static V1Config Preset(std::string_view name);
};

}  // namespace horopter::vision
