// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/device.h"

namespace horopter::hardware {

/// The contract of `Device`, over implementations of every kind of device.
///
/// `Traits` is default-constructible, makes a fresh device, and has
/// - `device()`: a reference to it;
/// - where the device has a link that can be lost: `void BreakLink()`, which cuts it and lets the
///   device notice, and `void MendLink()`.
template <typename Traits>
class DeviceContract : public testing::Test {
 protected:
  Device& device() { return traits_.device(); }
  Traits traits_;
};
TYPED_TEST_SUITE_P(DeviceContract);

TYPED_TEST_P(DeviceContract, ANewDeviceIsUnconfigured) {
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kUnconfigured);
}

TYPED_TEST_P(DeviceContract, ConfigureLeavesItInactive) {
  ASSERT_TRUE(this->device().Configure().ok());
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kInactive);
}

TYPED_TEST_P(DeviceContract, ConfiguringAgainSucceedsAndChangesNothing) {
  ASSERT_TRUE(this->device().Configure().ok());
  EXPECT_TRUE(this->device().Configure().ok());
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kInactive);
  ASSERT_TRUE(this->device().Activate().ok());
  EXPECT_TRUE(this->device().Configure().ok());
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kActive);
}

TYPED_TEST_P(DeviceContract, ActivationNeedsConfiguration) {
  const auto refused = this->device().Activate();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kNotActive);
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kUnconfigured);
}

TYPED_TEST_P(DeviceContract, ActivationIsIdempotent) {
  ASSERT_TRUE(this->device().Configure().ok());
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(this->device().Activate().ok());
    EXPECT_EQ(this->device().lifecycle(), Lifecycle::kActive);
  }
}

TYPED_TEST_P(DeviceContract, DeactivationIsIdempotentAndLeavesUnconfiguredAsItIs) {
  this->device().Deactivate();
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kUnconfigured);
  ASSERT_TRUE(this->device().Configure().ok());
  this->device().Deactivate();
  EXPECT_EQ(this->device().lifecycle(), Lifecycle::kInactive);
  ASSERT_TRUE(this->device().Activate().ok());
  for (int i = 0; i < 2; ++i) {
    this->device().Deactivate();
    EXPECT_EQ(this->device().lifecycle(), Lifecycle::kInactive);
  }
}

TYPED_TEST_P(DeviceContract, ItCanBeActivatedAgain) {
  ASSERT_TRUE(this->device().Configure().ok());
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(this->device().Activate().ok());
    EXPECT_EQ(this->device().lifecycle(), Lifecycle::kActive);
    this->device().Deactivate();
  }
}

TYPED_TEST_P(DeviceContract, OnlyConfigureLeavesTheFaultOfALostLinkAndNeverIntoActive) {
  if constexpr (requires { this->traits_.BreakLink(); }) {
    for (const bool active : {false, true}) {
      TypeParam traits;
      Device& device = traits.device();
      ASSERT_TRUE(device.Configure().ok());
      if (active) {
        ASSERT_TRUE(device.Activate().ok());
      }
      traits.BreakLink();
      EXPECT_EQ(device.lifecycle(), Lifecycle::kFault);
      traits.MendLink();
      EXPECT_EQ(device.lifecycle(), Lifecycle::kFault);
      const auto refused = device.Activate();
      ASSERT_FALSE(refused.ok());
      EXPECT_EQ(refused.error().code, ErrorCode::kNotActive);
      device.Deactivate();
      EXPECT_EQ(device.lifecycle(), Lifecycle::kFault);
      ASSERT_TRUE(device.Configure().ok());
      EXPECT_EQ(device.lifecycle(), Lifecycle::kInactive);
    }
  } else {
    GTEST_SKIP() << "this device has no link that could be lost";
  }
}

REGISTER_TYPED_TEST_SUITE_P(DeviceContract, ANewDeviceIsUnconfigured, ConfigureLeavesItInactive,
                            ConfiguringAgainSucceedsAndChangesNothing, ActivationNeedsConfiguration,
                            ActivationIsIdempotent,
                            DeactivationIsIdempotentAndLeavesUnconfiguredAsItIs,
                            ItCanBeActivatedAgain,
                            OnlyConfigureLeavesTheFaultOfALostLinkAndNeverIntoActive);

}  // namespace horopter::hardware
