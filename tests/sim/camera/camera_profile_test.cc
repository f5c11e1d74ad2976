// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/camera_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace horopter::sim {
namespace {

using testing::HasSubstr;

TEST(CameraProfile, EveryNamedProfileHoldsAndBearsItsName) {
  for (const std::string& name : CameraProfile::Names()) {
    const CameraProfile profile = CameraProfile::Named(name);
    EXPECT_EQ(profile.name, name);
    EXPECT_TRUE(profile.Validate().empty()) << name;
    EXPECT_NO_THROW(profile.lens.Model(640, 480, 1)) << name;
  }
}

TEST(CameraProfile, UnknownNameListsTheKnownOnes) {
  try {
    CameraProfile::Named("webcam");
    FAIL();
  } catch (const hardware::ConfigError& e) {
    for (const std::string& name : CameraProfile::Names()) {
      EXPECT_THAT(e.what(), HasSubstr(name));
    }
  }
}

TEST(CameraProfile, EveryBadFieldIsNamedAtOnce) {
  CameraProfile profile;
  profile.lens.vignetting = 1.5;
  profile.exposure.gain = 0;
  profile.noise.bits = 9;
  profile.noise.read_noise_dn = std::numeric_limits<double>::quiet_NaN();
  profile.shutter.readout_s = -1;
  profile.timing.drop_probability = 0.1;  // without a rate
  std::vector<std::string> fields;
  for (const auto& error : profile.Validate()) fields.push_back(error.field);
  EXPECT_THAT(fields,
              testing::UnorderedElementsAre("camera.lens.vignetting", "camera.exposure.gain",
                                            "camera.noise.bits", "camera.noise.read_noise_dn",
                                            "camera.shutter.readout_s", "camera.timing.rate_hz"));
}

TEST(LensProfile, ModelHasTheFieldOfViewAspectAndPrincipalPointAskedFor) {
  const LensProfile lens{
      .distortion = {.k1 = -0.2}, .principal_point_offset_px = {8, -6}, .pixel_aspect = 1.1};
  const hardware::CameraModel model = lens.Model(320, 240, 1.0);
  const hardware::Intrinsics& in = model.intrinsics();
  EXPECT_DOUBLE_EQ(in.fx, 160 / std::tan(0.5));
  EXPECT_DOUBLE_EQ(in.fy, 1.1 * in.fx);
  EXPECT_DOUBLE_EQ(in.cx, 159.5 + 4) << "half the width, half the offset";
  EXPECT_DOUBLE_EQ(in.cy, 119.5 - 3);
  EXPECT_EQ(model.distortion().k1, -0.2);
}

}  // namespace
}  // namespace horopter::sim
