// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/time.h"
#include "scenarios/results/append_file.h"
#include "scenarios/results/hasher.h"
#include "sim/truth/correspondence.h"
#include "sim/truth/ground_truth.h"
#include "sim/truth/scene_legend.h"
#include "sim/truth/world_state.h"

namespace horopter::scenarios {

/// What one camera delivered, and what is true of it. What is not given is not written.
struct DatasetEye {
  sim::EyeView view;
  cv::Mat bgr;  ///< CV_8UC3 of the view's size
  std::optional<sim::EyeTruth> truth;
  std::optional<sim::CorrespondenceField> to_other_eye;
  /// Where what the previous frame showed at a pixel is now; on the previous frame's pixels.
  std::optional<sim::CorrespondenceField> flow_from_previous;
};

/// Two cameras of one instant. A head with several pairs names them ("peripheral", "foveal").
struct DatasetPair {
  std::string name;  ///< empty when there is only one pair
  DatasetEye left;
  DatasetEye right;
};

/// Disparity between two cameras of a frame that need not be a pair.
struct DatasetDisparity {
  std::string from;  ///< as the camera's image is named, without .png; the maps have its size
  std::string to;
  sim::CorrespondenceField field;
};

struct DatasetFrame {
  hardware::Time t{};
  hardware::HeadAngles head;
  std::vector<DatasetPair> pairs;
  std::vector<DatasetDisparity> between;
  std::optional<sim::WorldState> state;
};

/// SHA-256 of what a scene is made of.
struct SceneHashes {
  std::string mjcf;                          ///< its text, includes resolved
  std::string textures;                      ///< their pixels, as they were drawn
  std::map<std::string, std::string> files;  ///< by path below the scenes folder
};

/// What is said of the data set as a whole.
struct DatasetInfo {
  std::string scene;                  ///< below the scenes folder
  std::optional<std::uint64_t> seed;  ///< none: nothing was varied
  std::string gl_renderer;
  std::map<std::string, std::string> versions;  ///< of what made it, by name
  std::string robot;
  std::string gl_backend;
  std::string command;  ///< the command line that made it
  std::string request;  ///< JSON of what was asked for, defaults filled in; empty: not said
  /// Parts of the camera's profile that the images do not show, each with the reason.
  std::map<std::string, std::string> left_out_of_profile;
  SceneHashes scene_sha256;
};

struct DatasetOptions {
  /// 16-bit PNG besides the exact formats: depth, KITTI disparity and flow, each with its own range
  /// and steps; what does not fit is counted in the manifest as `left_out`.
  bool png16 = false;
  double depth_units_per_m = 1000;
};

/// Writes a folder of rendered views with their truth:
///
///   manifest.json   scene, seed, request, versions, GL renderer, conventions, hashes of all images
///                   and, when it is complete, of all else: `files` has tables, and every frame's
///                   SHA256SUMS in place of the frame's files; `complete` is false until Finish()
///                   replaces it, which is the last thing it does
///   index.csv       a row per frame: folder, time, head angles; appended when the frame is there
///   legend.csv      names of parts and objects by the values in the id pictures
///   000000/ ...     one folder per frame, which appears whole or not at all:
///     left.png right.png                  the images
///     cameras.yaml                        both cameras (camera_yaml.h)
///     left_depth.pfm                      depth along the optical axis [m]; inf = nothing
///     left_normals.pfm                    unit normals in the optical frame, x y z; inf = nothing
///     left_parts.png left_objects.png     16 bits: id plus one; 0 = nothing
///     left_disparity.flo                  vector disparity to the right eye; right_... to the left
///     left_visibility.png                 255 seen in both, 128 occluded in the other eye, 64 out
///                                         of its view, 0 nothing (Middlebury's values and one
///                                         more)
///     left_flow_previous_to_this.flo left_flow_previous_to_this_visibility.png
///                                         on the pixels of the previous frame's left image: what
///                                         it showed at (x, y) is in this one at (x+dx, y+dy)
///     A_to_B_disparity.flo A_to_B_visibility.png   between any two cameras, on the pixels of A
///     poses.csv joints.csv contacts.csv   state of the world (state_tables.h)
///     SHA256SUMS                          of all these, as `sha256sum -c` reads them
///
/// Of a pair with a name every file of its own begins with that name: peripheral_left.png.
class DatasetWriter {
 public:
  /// Creates the folder, which must not exist or be empty.
  /// @param legend of the scene; empty when no truth will be written
  /// @throws ResultsError when it holds something or cannot be written
  DatasetWriter(std::filesystem::path folder, const DatasetInfo& info,
                const std::optional<sim::SceneLegend>& legend, const DatasetOptions& options = {});
  DatasetWriter(const DatasetWriter&) = delete;
  DatasetWriter& operator=(const DatasetWriter&) = delete;
  /// Without Finish() the folder keeps saying that the data set is incomplete.
  ~DatasetWriter() = default;

  /// @return the frame's folder
  /// @throws std::invalid_argument when a picture or map has not its camera's size or two pairs
  ///         share a name; ResultsError. Of the frame then nothing is left.
  std::filesystem::path AddFrame(const DatasetFrame& frame);

  /// Says that the data set is complete, and hashes what is in it. To be called once, after the
  /// last frame.
  /// @param others files beside the writer's own, by name in the folder
  /// @param outcome JSON of what came of the robot's motion; empty: not said
  /// @throws ResultsError when one of them cannot be read
  void Finish(const std::vector<std::string>& others = {}, const std::string& outcome = "");

  const std::filesystem::path& folder() const { return folder_; }
  int frame_count() const { return frame_count_; }

 private:
  void WriteManifest(bool complete) const;

  std::filesystem::path folder_;
  DatasetInfo info_;
  std::optional<sim::SceneLegend> legend_;
  DatasetOptions options_;
  std::optional<AppendFile> index_;
  int frame_count_ = 0;
  std::map<std::string, std::string> image_hashes_;  ///< SHA-256 of camera images, by relative path
  std::map<std::string, std::string> file_hashes_;   ///< likewise of tables and lists of hashes
  std::string outcome_;
  std::map<std::string, int> left_out_;  ///< pixels per 16-bit picture, where any
};

}  // namespace horopter::scenarios
