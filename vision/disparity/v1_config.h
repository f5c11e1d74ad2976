// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/closed_form_config.h"
#include "vision/disparity/fill_in.h"
#include "vision/disparity/pyramid.h"

namespace horopter::vision {

/// The population of 2009: orientations theta = i * pi / 8, and phase shifts per orientation. Loops
/// over as many run at their fastest.
inline constexpr int kOrientations = 8;
inline constexpr int kPhaseShifts = 7;

/// How the model is computed.
enum class V1Form {
  /// As published: each pixel has orientations x phase shifts energy neurons, whose activity is
  /// decoded. The readable reference.
  kPopulation,
  /// One complex product for each orientation, which holds the energy at every phase shift:
  /// energy^2 = |L|^2 + |R|^2 + 2 |L| |R| cos(phase difference + shift). Hypotheses compete by it.
  kClosedForm
};

/// How the population's activity becomes a disparity.
enum class V1Decoding {
  /// 2009: the centre of mass of each orientation, then the intersection of their constraints.
  kCentreOfMass,
  /// 2018: a linear readout of cells that sum over orientations (LinearReadout).
  kLinear
};

/// Parameters of the V1 binocular energy model; those of the population form come first.
///
/// "2009" below is the model of Chessa, Sabatini & Solari, "A fast joint bioinspired algorithm for
/// optic flow and two-dimensional disparity estimation", ICVS 2009; "2018" that of Chessa & Solari,
/// "A computational model for the neural representation and estimation of the binocular vector
/// disparity from convergent stereo image pairs", Int. J. Neural Systems 28:1850029. The defaults
/// are those of the preset "checked"; Preset("paper_2009") takes the additions away.
struct V1Config {
  V1Form form = V1Form::kPopulation;
  /// Read when `form` is kClosedForm, and then alone.
  ClosedFormConfig closed_form;

  // --- Input ---

  /// Side of the window whose mean and deviation normalise every level of the pyramid
  /// (NormaliseLocally) [px]; 0 = none (2009), since the energies are normalised anyhow. 2018: 5.
  /// The contrast that counts half is noise_grey, as far as it is left at a level.
  int normalisation_px = 0;

  // --- Simple cells: the Gabor bank ---

  /// Orientations theta = i * pi / orientations, 2 to 16. 2009: 8. 2018: 18 over the full circle,
  /// which are 9, each with its phase shifts both ways round.
  int orientations = kOrientations;
  /// Width of the filters. 2009 and 2018: 11x11.
  int filter_px = 11;
  /// Radial peak frequency [cycles/px]. 2009: 0.25, the highest that an octave pyramid needs. 2018:
  /// 1 / 3.8.
  double peak_frequency = 0.25;
  /// Deviation of the Gaussian envelope [px]: a bandwidth of a third of the peak frequency. 2009.
  /// 2018: 1.2 sqrt(2 ln 2) / (2 pi f0 / 3), which is 2.56.
  double envelope_sigma_px = 2.25;

  // --- Population: binocular energy and its decoding ---

  /// Phase shifts of each orientation, 3 to 15. 2009: 7. 2018: 11.
  int phase_shifts = kPhaseShifts;
  /// The phase shifts prefer disparities spread evenly over +-this. 2009: 1.5 px in steps of 0.5.
  /// 2018: 0.76 px, since half an octave needs less.
  double max_disparity_px = 1.5;
  /// Power to which energies |L + R exp(i phase)| are raised. 1 (2009), or as 2018 has it 0.18: a
  /// static nonlinearity that lets weak orientations speak.
  double energy_exponent = 1;
  /// How activity is decoded. 2009's is precise for a single pixel; 2018's has no threshold.
  V1Decoding decoding = V1Decoding::kCentreOfMass;
  /// Gain of the linear readout, relative to the one that is unbiased where all orientations have
  /// equal energy (LinearReadout). 2018 takes the gain from the image's largest response; measured
  /// on the pair that was published with it, 1.3 comes nearest to its field (1.2 to 1.4 alike).
  double readout_gain = 1;
  /// Part of a pooling neighbourhood that must have texture and lie within both images for the
  /// linear readout to say anything. 2018: 1, which leaves 5 px along borders to be filled in; at
  /// 0.5 it speaks up to the border itself.
  double min_pooled = 0.5;
  /// Responses, scaled over phase to [0, 1], count in the centre of mass from here up. 2009: 0.7.
  double response_threshold = 0.7;
  /// Count responses by their excess over the threshold, not by their value. 2009: false. The
  /// centre of mass then moves with the disparity steadily instead of in steps of the phase grid.
  bool soft_threshold = true;
  /// Semi-saturation of the centre of mass's divisive normalisation [grey levels, as the energies].
  double saturation_grey = 0.5;
  /// Deviation of the sensor's noise at full size [grey levels]; an octave halves it. 2009 and 2018
  /// have only a threshold against rounding. 1 suits a good camera's 8 bits; say more for a noisier
  /// one.
  double noise_grey = 1;
  /// A pixel is textureless at a scale where its mean binocular energy is below this multiple of
  /// what noise alone makes. Over a pixel's population noise deviates by about a fifth of its mean.
  /// Normalised input deviates by 1 at most and noise alone by 0.7, so that it takes a small
  /// multiple there: 2018 drops what has a 2e-5th of the image's largest energy.
  double min_signal_to_noise = 2;
  /// Peak of an orientation, relative to the mean response of the pixel, from which it counts.
  /// 0 = any: the intersection of constraints copes with weak orientations, and gains by them.
  double min_orientation_response = 0;

  // --- Intersection of constraints ---

  /// Orientations that must count at a pixel, for the centre of mass as the rest of these. 2009: 3.
  int min_orientations = 3;
  /// Smallest ratio of the eigenvalues of the least squares: below it the pixel sees one direction
  /// only (the aperture problem).
  double min_conditioning = 0.05;
  /// Weigh each orientation by its energy. 2009: false, all that count count alike.
  bool energy_weights = true;

  // --- Spatial pooling ---

  /// Deviation of the Gaussian over which neighbours share what they see [px]; 0 = none (2009).
  /// 2018: 11 / 6, cut at 11x11. The linear readout pools normalised responses, as 2018 does, the
  /// centre of mass its constraints.
  double pooling_sigma_px = 1.5;

  // --- Coarse to fine ---

  /// Size of the pyramid's levels, each against the one before. 2009: octaves. 2018: half octaves.
  PyramidStep pyramid = PyramidStep::kOctave;
  /// Levels; the reach is +-max_disparity_px * the sum of factor^level. 2009: 6, +-94 px. 2018: 9,
  /// +-40 px.
  int scales = 6;
  /// Levels stop before an image side would be less than this.
  int min_side_px = 8;
  /// Decodings per scale, each around the last one's result. 2009 and 2018: 1.
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

  // --- Fill-in ---

  /// Give pixels without a response the step of those around them at every scale, and what is
  /// invalid in the end the disparity around it (FillIn), marked as such. 2009: false. 2018: true,
  /// with a bilateral filter of 15x15 px, deviation 2.5 px, over a third of the image's range.
  bool fill_in = false;
  FillInConfig fill;

  /// Every field that does not hold, of the form that is chosen.
  std::vector<hardware::FieldError> Validate() const;

  /// Closed form: "accurate": its defaults. "fast": fewer neighbours, steps, octaves explored and
  /// intersections, and a lower least coherence. "realtime": "fast" at half size, doubled, with a
  /// higher one. "dense": "accurate", filled in.
  /// Population form: "checked": the defaults above. "cautious": what a robot may drive by, webcam
  /// noise and only what the finest octave itself sees, at the price of density. "paper_2009" and
  /// "paper_2018": the published models alone. Where 2018's leaves a choice: as readout_gain and
  /// min_signal_to_noise say, and FillIn's filter, of like reach, in place of the bilateral one.
  /// @throws std::invalid_argument that lists the known names.
  static V1Config Preset(std::string_view name);
};

}  // namespace horopter::vision
