// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"

namespace horopter::hardware {

/// The contract of `CameraPair`, over implementations. Instantiate DeviceContract beside it.
///
/// `Traits` is default-constructible, makes a fresh pair of cameras, and has
/// - `CameraPair& device()`, `Clock& clock()`;
/// - `Duration frame_period()`: after this long there is a new frame;
/// - `void ChangeView()`: makes the next frame differ from the last;
/// - `static constexpr bool kSameInstant`: both eyes show one instant, as without injected skew.
template <typename Traits>
class CameraPairContract : public testing::Test {
 protected:
  CameraPair& cameras() { return traits_.device(); }
  Clock& clock() { return traits_.clock(); }

  void SetUpActive() {
    ASSERT_TRUE(cameras().Configure().ok());
    ASSERT_TRUE(cameras().Activate().ok());
  }

  void Pass(Duration d) { clock().SleepUntil(clock().Now() + d); }

  StereoFrame Grab() {
    auto frame = cameras().Grab();
    EXPECT_TRUE(frame.ok()) << (frame.ok() ? "" : frame.error().message);
    return frame.ok() ? *std::move(frame) : StereoFrame{};
  }

  static bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
    if (a.size() != b.size() || a.type() != b.type()) return false;
    for (int row = 0; row < a.rows; ++row) {
      if (std::memcmp(a.ptr(row), b.ptr(row), a.cols * a.elemSize()) != 0) return false;
    }
    return true;
  }

  Traits traits_;
};
TYPED_TEST_SUITE_P(CameraPairContract);

TYPED_TEST_P(CameraPairContract, GrabIsRefusedUnlessActive) {
  const auto expect_refused = [this](const char* when) {
    const auto refused = this->cameras().Grab();
    ASSERT_FALSE(refused.ok()) << when;
    EXPECT_EQ(refused.error().code, ErrorCode::kNotActive) << when;
  };
  expect_refused("unconfigured");
  ASSERT_TRUE(this->cameras().Configure().ok());
  expect_refused("inactive");
  ASSERT_TRUE(this->cameras().Activate().ok());
  EXPECT_TRUE(this->cameras().Grab().ok());
  this->cameras().Deactivate();
  expect_refused("deactivated");
}

TYPED_TEST_P(CameraPairContract, ImagesAreBgrOfTheSizeThatTheModelStates) {
  this->SetUpActive();
  const StereoFrame frame = this->Grab();
  for (const Eye eye : kBothEyes) {
    const CameraModel model = this->cameras().model(eye);
    EXPECT_EQ(frame[eye].bgr.type(), CV_8UC3) << ToString(eye);
    EXPECT_EQ(frame[eye].bgr.cols, model.width()) << ToString(eye);
    EXPECT_EQ(frame[eye].bgr.rows, model.height()) << ToString(eye);
  }
}

TYPED_TEST_P(CameraPairContract, FramesAreCapturedBeforeTheyAreDeliveredAndNotInTheFuture) {
  this->SetUpActive();
  for (int i = 0; i < 3; ++i) {
    this->Pass(this->traits_.frame_period());
    const StereoFrame frame = this->Grab();
    EXPECT_LE(frame.left.t_capture, frame.t_delivered);
    EXPECT_LE(frame.right.t_capture, frame.t_delivered);
    EXPECT_LE(frame.t_delivered, this->clock().Now());
  }
}

TYPED_TEST_P(CameraPairContract, BothEyesShowOneInstant) {
  if (!TypeParam::kSameInstant) GTEST_SKIP() << "these cameras are not synchronised";
  this->SetUpActive();
  for (int i = 0; i < 3; ++i) {
    const StereoFrame frame = this->Grab();
    EXPECT_EQ(frame.left.t_capture, frame.right.t_capture);
    this->Pass(this->traits_.frame_period());
  }
}

TYPED_TEST_P(CameraPairContract, GrabGivesTheNewestFrameAndSequenceNumbersIncrease) {
  this->SetUpActive();
  StereoFrame last = this->Grab();
  for (const int periods : {1, 1, 5}) {
    this->Pass(periods * this->traits_.frame_period());
    const Time now = this->clock().Now();
    const StereoFrame frame = this->Grab();
    EXPECT_GT(frame.sequence, last.sequence);
    EXPECT_GT(frame.left.t_capture, last.left.t_capture);
    EXPECT_GE(frame.left.t_capture, now - 2 * this->traits_.frame_period()) << "a stale frame";
    last = frame;
  }
}

TYPED_TEST_P(CameraPairContract, AFrameKeepsItsPixelsWhenTheNextIsGrabbed) {
  this->SetUpActive();
  const StereoFrame first = this->Grab();
  const cv::Mat left = first.left.bgr.clone(), right = first.right.bgr.clone();
  this->traits_.ChangeView();
  this->Pass(2 * this->traits_.frame_period());
  const StereoFrame second = this->Grab();
  EXPECT_FALSE(this->SamePixels(second.left.bgr, left)) << "the view should have changed";
  EXPECT_TRUE(this->SamePixels(first.left.bgr, left));
  EXPECT_TRUE(this->SamePixels(first.right.bgr, right));
  EXPECT_NE(first.left.bgr.data, first.right.bgr.data);
}

REGISTER_TYPED_TEST_SUITE_P(CameraPairContract, GrabIsRefusedUnlessActive,
                            ImagesAreBgrOfTheSizeThatTheModelStates,
                            FramesAreCapturedBeforeTheyAreDeliveredAndNotInTheFuture,
                            BothEyesShowOneInstant,
                            GrabGivesTheNewestFrameAndSequenceNumbersIncrease,
                            AFrameKeepsItsPixelsWhenTheNextIsGrabbed);

}  // namespace horopter::hardware
