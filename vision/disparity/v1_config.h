// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/closed_form_config.h"

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
