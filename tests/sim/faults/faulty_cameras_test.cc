// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/faulty_cameras.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::StereoFrame;
using hardware::Time;

Time At(double s) { return Time(hardware::FromSeconds(s)); }

/// A pair that is grabbed every 0.1 s: frame n shows the grey level n in the left eye and n + 100
/// in the right one.
class CountingCameras final : public hardware::CameraPair {
 public:
  hardware::Lifecycle lifecycle() const override { return hardware::Lifecycle::kActive; }
  hardware::Result<void> Configure() override { return {}; }
  hardware::Result<void> Activate() override { return {}; }
  void Deactivate() override {}
  hardware::CameraModel model(Eye) const override {
    return hardware::CameraModel::FromHorizontalFov(4, 3, 1);
  }
  hardware::Result<StereoFrame> Grab() override {
    StereoFrame frame;
    frame.sequence = next_++;
    frame.t_delivered = At(0.1 * static_cast<double>(frame.sequence));
    const auto level = static_cast<double>(frame.sequence);
    frame.left = {cv::Mat(3, 4, CV_8UC3, cv::Scalar::all(level)), frame.t_delivered};
    frame.right = {cv::Mat(3, 4, CV_8UC3, cv::Scalar::all(level + 100)), frame.t_delivered};
    return frame;
  }

 private:
  std::uint64_t next_ = 0;
};

struct Seen {
  int left, right;  ///< grey levels
  Time t_left, t_right;
};

std::vector<Seen> Grab(const std::vector<Fault>& faults, int frames) {
  CountingCameras inner;
  FaultyCameras cameras(inner, faults);
  std::vector<Seen> seen;
  for (int i = 0; i < frames; ++i) {
    const StereoFrame frame = cameras.Grab().value();
    EXPECT_EQ(frame.sequence, static_cast<std::uint64_t>(i));
    for (const Eye eye : hardware::kBothEyes) {
      double darkest = 0, brightest = 0;
      cv::minMaxLoc(frame[eye].bgr.reshape(1), &darkest, &brightest);
      EXPECT_EQ(darkest, brightest) << "of one grey level all over";
    }
    seen.push_back({frame.left.bgr.data[0], frame.right.bgr.data[0], frame.left.t_capture,
                    frame.right.t_capture});
  }
  return seen;
}

TEST(FaultyCameras, WithoutFaultsFramesPassUnchanged) {
  const auto seen = Grab({}, 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(seen[i].left, i);
    EXPECT_EQ(seen[i].right, i + 100);
    EXPECT_EQ(seen[i].t_left, At(0.1 * i));
  }
}

TEST(FaultyCameras, SwappedPairExchangesTheImagesForItsTime) {
  const auto seen = Grab({{SwappedPair{}, {At(0.2), At(0.4)}}}, 6);
  for (int i = 0; i < 6; ++i) {
    const bool swapped = i == 2 || i == 3;
    EXPECT_EQ(seen[i].left, swapped ? i + 100 : i);
    EXPECT_EQ(seen[i].right, swapped ? i : i + 100);
  }
}

TEST(FaultyCameras, FrozenEyeRepeatsItsLastImageAsIfNew) {
  const auto seen = Grab({{FrozenFrames{Eye::kLeft}, {At(0.3), At(0.6)}}}, 8);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(seen[i].left, i >= 3 && i < 6 ? 2 : i);
    EXPECT_EQ(seen[i].t_left, At(0.1 * i)) << "its time goes on";
    EXPECT_EQ(seen[i].right, i + 100);
  }
}

TEST(FaultyCameras, FrozenFromTheStartShowsTheFirstImageForEver) {
  const auto seen = Grab({{FrozenFrames{Eye::kRight}}}, 4);
  for (const Seen& frame : seen) EXPECT_EQ(frame.right, 100);
}

}  // namespace
}  // namespace horopter::sim
