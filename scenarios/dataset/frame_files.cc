// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/frame_files.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "scenarios/dataset/camera_yaml.h"
#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/dataset/state_tables.h"

namespace horopter::scenarios {
namespace {

using sim::CorrespondenceField;
using sim::Visibility;

cv::Mat1b VisibilityPicture(const CorrespondenceField& field) {
  cv::Mat1b picture(field.visibility.size(), std::uint8_t{0});
  picture.setTo(255, field.Mask(Visibility::kVisible));
  picture.setTo(128, field.Mask(Visibility::kOccluded));
  picture.setTo(64, field.Mask(Visibility::kOutOfView));
  return picture;
}

/// Collects the files of one eye, all of whose names begin alike.
class EyeFiles {
 public:
  EyeFiles(const DatasetEye& eye, std::string stem, FrameFiles* files)
      : eye_(eye), stem_(std::move(stem)), files_(files) {}

  void Image() {
    RequireSize("image", eye_.bgr.size());
    if (eye_.bgr.type() != CV_8UC3) {
      throw std::invalid_argument(fmt::format("{}: an image has three channels of 8 bits", stem_));
    }
    files_->images.push_back(stem_ + ".png");
    Add(".png", EncodePng(eye_.bgr));
  }

  void Truth(const sim::SceneLegend* legend, const DatasetOptions& options) {
    RequireSize("depth", eye_.truth->depth.size());
    RequireSize("ids", eye_.truth->ids.size());
    RequireSize("normals", eye_.truth->normals.size());
    Add("_depth.pfm", EncodePfm(eye_.truth->depth));
    Add("_normals.pfm", EncodePfm(eye_.truth->normals));
    Add("_parts.png", EncodePng(PackIds(eye_.truth->ids)));
    if (legend != nullptr) {
      Add("_objects.png", EncodePng(PackIds(legend->Objects(eye_.truth->ids))));
    }
    if (options.png16) Add("_depth.png", PackDepth(eye_.truth->depth, options.depth_units_per_m));
  }

  /// @param toward_right whether the other eye is the right one: KITTI's disparity is
  ///        x_left - x_right in either
  void Disparity(bool toward_right, const DatasetOptions& options) {
    const CorrespondenceField& field = *eye_.to_other_eye;
    RequireSize("disparity", field.dx.size());
    Add("_disparity.flo", EncodeFlo({field.dx, field.dy}));
    Add("_visibility.png", EncodePng(VisibilityPicture(field)));
    if (!options.png16) return;
    const cv::Mat1f positive = toward_right ? cv::Mat1f(-field.dx) : field.dx;
    Add("_disparity.png", PackKittiDisparity(positive));
  }

  void Flow(const DatasetOptions& options) {
    const CorrespondenceField& field = *eye_.flow_from_previous;
    RequireSize("flow", field.dx.size());
    Add("_flow_previous_to_this.flo", EncodeFlo({field.dx, field.dy}));
    Add("_flow_previous_to_this_visibility.png", EncodePng(VisibilityPicture(field)));
    if (options.png16) Add("_flow_previous_to_this.png", PackKittiFlow({field.dx, field.dy}));
  }

 private:
  void RequireSize(const char* what, const cv::Size& size) const {
    const hardware::CameraModel& camera = eye_.view.camera;
    if (size == cv::Size(camera.width(), camera.height())) return;
    throw std::invalid_argument(fmt::format("{}: {} of {}x{} for a camera of {}x{}", stem_, what,
                                            size.width, size.height, camera.width(),
                                            camera.height()));
  }

  void Add(const char* ending, std::string bytes) {
    files_->bytes[stem_ + ending] = std::move(bytes);
  }
  void Add(const char* ending, const Packed& packed) {
    if (packed.left_out > 0) files_->left_out[stem_ + ending] = packed.left_out;
    Add(ending, EncodePng(packed.pixels));
  }

  const DatasetEye& eye_;
  std::string stem_;
  FrameFiles* files_;
};

/// @pre the images are in `files`
void AddBetween(const DatasetDisparity& disparity, FrameFiles* files) {
  for (const std::string& camera : {disparity.from, disparity.to}) {
    if (files->bytes.count(camera + ".png") > 0) continue;
    throw std::invalid_argument(fmt::format("disparity of a camera '{}' without image", camera));
  }
  const std::string stem = disparity.from + "_to_" + disparity.to;
  const CorrespondenceField& field = disparity.field;
  files->bytes[stem + "_disparity.flo"] = EncodeFlo({field.dx, field.dy});
  files->bytes[stem + "_visibility.png"] = EncodePng(VisibilityPicture(field));
}

}  // namespace

FrameFiles EncodeFrame(const DatasetFrame& frame, const sim::SceneLegend* legend,
                       const DatasetOptions& options) {
  FrameFiles files;
  for (const DatasetPair& pair : frame.pairs) {
    const std::string prefix = pair.name.empty() ? "" : pair.name + "_";
    if (files.bytes.count(prefix + "cameras.yaml") > 0) {
      throw std::invalid_argument(fmt::format("two pairs of cameras named '{}'", pair.name));
    }
    files.bytes[prefix + "cameras.yaml"] = EncodeCameras({pair.left.view, pair.right.view});
    for (const hardware::Eye side : hardware::kBothEyes) {
      const bool left = side == hardware::Eye::kLeft;
      const DatasetEye& eye = left ? pair.left : pair.right;
      EyeFiles eye_files(eye, prefix + ToString(side), &files);
      eye_files.Image();
      if (eye.truth) eye_files.Truth(legend, options);
      if (eye.to_other_eye) eye_files.Disparity(left, options);
      if (eye.flow_from_previous) eye_files.Flow(options);
    }
  }
  for (const DatasetDisparity& disparity : frame.between) AddBetween(disparity, &files);
  if (frame.state) {
    files.bytes["poses.csv"] = EncodePoses(frame.state->bodies);
    files.bytes["joints.csv"] = EncodeJoints(frame.state->joints);
    files.bytes["contacts.csv"] = EncodeContacts(frame.state->contacts);
  }
  return files;
}

}  // namespace horopter::scenarios
