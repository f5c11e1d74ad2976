// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/frame_faults.h"

#include <gtest/gtest.h>

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::Time;

constexpr std::uint64_t kSeed = 3;
constexpr int kFrames = 2000;

Time At(double s) { return Time(hardware::FromSeconds(s)); }

TEST(FrameFaults, WithoutFaultsAllLightAndEveryFrameComes) {
  const FrameFaults sound({}, kSeed);
  EXPECT_EQ(sound.Light(Eye::kLeft, At(1)), 1);
  for (std::uint64_t n = 0; n < 50; ++n) EXPECT_FALSE(sound.Loses(Eye::kRight, n, At(1)));
}

TEST(FrameFaults, ADarkEyeKeepsItsShareOfTheLightForItsTime) {
  const FrameFaults dark({{DarkEye{Eye::kRight, 0.25}, {At(1), At(2)}}}, kSeed);
  EXPECT_EQ(dark.Light(Eye::kRight, At(0.99)), 1);
  EXPECT_EQ(dark.Light(Eye::kRight, At(1)), 0.25);
  EXPECT_EQ(dark.Light(Eye::kRight, At(2)), 1);
  EXPECT_EQ(dark.Light(Eye::kLeft, At(1.5)), 1);
}

TEST(FrameFaults, TheShareIsLostAndNeverTheFirst) {
  const FrameFaults faults({{LostFrames{Eye::kLeft, 0.3}}}, kSeed);
  int lost = 0;
  for (std::uint64_t n = 1; n <= kFrames; ++n) lost += faults.Loses(Eye::kLeft, n, At(1));
  EXPECT_NEAR(lost, 0.3 * kFrames, 80) << "4 standard deviations";
  const FrameFaults all({{LostFrames{Eye::kLeft, 1}}}, kSeed);
  EXPECT_FALSE(all.Loses(Eye::kLeft, 0, At(1)));
  EXPECT_TRUE(all.Loses(Eye::kLeft, 1, At(1)));
}

TEST(FrameFaults, WhatIsLostDependsOnSeedEyeAndNumberAlone) {
  const Fault left{LostFrames{Eye::kLeft, 0.4}}, right{LostFrames{Eye::kRight, 0.4}};
  const FrameFaults alone({left}, kSeed), both({right, left}, kSeed), reseeded({left}, kSeed + 1);
  const FrameFaults later({{LostFrames{Eye::kLeft, 0.4}, {At(3), At(100)}}}, kSeed);
  int apart = 0, eyes_differ = 0;
  for (std::uint64_t n = 1; n < 200; ++n) {
    const bool lost = alone.Loses(Eye::kLeft, n, At(5));
    EXPECT_EQ(both.Loses(Eye::kLeft, n, At(5)), lost);
    EXPECT_EQ(later.Loses(Eye::kLeft, n, At(5)), lost);
    EXPECT_FALSE(later.Loses(Eye::kLeft, n, At(2)));
    apart += reseeded.Loses(Eye::kLeft, n, At(5)) != lost;
    eyes_differ += both.Loses(Eye::kRight, n, At(5)) != lost;
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(eyes_differ, 20);
}

}  // namespace
}  // namespace horopter::sim
