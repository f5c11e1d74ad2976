// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/axis_faults.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

using hardware::HeadAxis;
using hardware::Time;

constexpr HeadAxis kPan = HeadAxis::kLeftPan;
constexpr std::uint64_t kSeed = 7;

Time At(double s) { return Time(hardware::FromSeconds(s)); }
TimeWindow Window(double from_s, double until_s) { return {At(from_s), At(until_s)}; }

TEST(AxisFaults, WithoutFaultsMotorEyeAndEncoderAreOne) {
  AxisFaults faults({}, kPan, kSeed);
  EXPECT_TRUE(faults.none());
  for (const double motor : {0.0, 0.3, -0.1234567}) {
    const AxisFaults::Load load = faults.Follow(motor, 0.7, At(1));
    EXPECT_EQ(load.position_rad, motor);
    EXPECT_EQ(load.speed_rad_s, 0.7);
    EXPECT_EQ(faults.Read(motor, At(1)), motor);
  }
}

TEST(AxisFaults, BacklashLeavesTheEyeHalfItsWidthBehindTheMotor) {
  AxisFaults faults({{Backlash{kPan, 0.02}}}, kPan, kSeed);
  faults.Follow(0, 0, At(0));
  double motor = 0;
  AxisFaults::Load load;
  for (; motor < 0.5; motor += 0.001) load = faults.Follow(motor, 1, At(0.1));
  EXPECT_NEAR(load.position_rad, motor - 0.001 - 0.01, 1e-12);
  EXPECT_EQ(load.speed_rad_s, 1) << "the motor takes it along";
  const double turned_at = load.position_rad;
  for (int i = 0; i < 15; ++i) {
    motor -= 0.001;
    load = faults.Follow(motor, -1, At(0.2));
    EXPECT_NEAR(load.position_rad, turned_at, 1e-12) << "crossing the play";
    EXPECT_EQ(load.speed_rad_s, 0);
  }
  for (; motor > 0; motor -= 0.001) load = faults.Follow(motor, -1, At(0.3));
  EXPECT_NEAR(load.position_rad, motor + 0.001 + 0.01, 1e-12);
  EXPECT_NEAR(faults.Read(load.position_rad, At(0.3)), motor + 0.001, 1e-12)
      << "the encoder reads the motor";
}

TEST(AxisFaults, AZeroThatIsOffMovesTheEyeAndNotTheReading) {
  const std::vector<Fault> all{{ZeroOff{hardware::Eye::kLeft, 0.03, -0.02}}};
  AxisFaults pan(all, kPan, kSeed), tilt(all, HeadAxis::kLeftTilt, kSeed);
  EXPECT_EQ(pan.Follow(0.1, 0, At(1)).position_rad, 0.13);
  EXPECT_DOUBLE_EQ(pan.Read(0.13, At(1)), 0.1);
  EXPECT_EQ(tilt.Follow(0.1, 0, At(1)).position_rad, 0.08);
  EXPECT_TRUE(AxisFaults(all, HeadAxis::kRightPan, kSeed).none());
}

TEST(AxisFaults, BiasMovesTheReadingAndNotTheEye) {
  AxisFaults faults({{EncoderBias{kPan, 0.05}, Window(2, 3)}}, kPan, kSeed);
  EXPECT_EQ(faults.Follow(0.1, 0, At(2.5)).position_rad, 0.1);
  EXPECT_EQ(faults.Read(0.1, At(1.999)), 0.1);
  EXPECT_DOUBLE_EQ(faults.Read(0.1, At(2)), 0.15);
  EXPECT_EQ(faults.Read(0.1, At(3)), 0.1) << "over when it is over";
}

TEST(AxisFaults, NoiseHasItsDeviationAndNoMean) {
  AxisFaults faults({{EncoderNoise{kPan, 0.01}}}, kPan, kSeed);
  double sum = 0, squares = 0;
  constexpr int kReadings = 4000;
  for (int i = 0; i < kReadings; ++i) {
    const double error = faults.Read(0.2, At(1)) - 0.2;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kReadings, 0, 0.01 * 4 / std::sqrt(kReadings));
  EXPECT_NEAR(std::sqrt(squares / kReadings), 0.01, 0.0005);
}

TEST(AxisFaults, NoiseOfOneAxisDependsOnNoOtherFault) {
  const Fault noise{EncoderNoise{kPan, 0.01}};
  const Fault other{EncoderNoise{HeadAxis::kRightPan, 0.02}};
  AxisFaults alone({noise}, kPan, kSeed);
  AxisFaults among({other, {Backlash{HeadAxis::kRightPan, 0.1}}, noise, {SwappedPair{}}}, kPan,
                   kSeed);
  AxisFaults twice({noise, noise}, kPan, kSeed);
  AxisFaults reseeded({noise}, kPan, kSeed + 1);
  int twice_differs = 0, reseeded_differs = 0;
  for (int i = 0; i < 20; ++i) {
    const double reading = alone.Read(0, At(1));
    EXPECT_EQ(among.Read(0, At(1)), reading);
    twice_differs += twice.Read(0, At(1)) != 2 * reading;
    reseeded_differs += reseeded.Read(0, At(1)) != reading;
  }
  EXPECT_EQ(twice_differs, 20) << "two of a kind draw apart";
  EXPECT_EQ(reseeded_differs, 20);
}

TEST(AxisFaults, NoiseDoesNotDependOnWhenItBegins) {
  AxisFaults always({{EncoderNoise{kPan, 0.01}}}, kPan, kSeed);
  AxisFaults later({{EncoderNoise{kPan, 0.01}, Window(1, 2)}}, kPan, kSeed);
  for (int i = 0; i < 30; ++i) {
    const Time t = At(0.1 * i);
    const double reading = always.Read(0.5, t);
    EXPECT_EQ(later.Read(0.5, t), i >= 10 && i < 20 ? reading : 0.5) << i;
  }
}

TEST(AxisFaults, StuckOnlyWithinItsWindow) {
  const AxisFaults faults({{StuckAxis{kPan}, Window(1, 2)}}, kPan, kSeed);
  EXPECT_FALSE(faults.Stuck(At(0.999)));
  EXPECT_TRUE(faults.Stuck(At(1)));
  EXPECT_FALSE(faults.Stuck(At(2)));
}

TEST(TimeWindow, FromTheStartMeansBeforeItToo) {
  EXPECT_TRUE(TimeWindow{}.Contains(At(-0.4)));
  EXPECT_FALSE(Window(0.1, 2).Contains(At(-0.4)));
}

TEST(Faults, NamesEveryBadField) {
  const std::vector<hardware::FieldError> errors =
      Validate({{Backlash{kPan, -1}},
                {DarkEye{hardware::Eye::kLeft, 2}},
                {LostFrames{hardware::Eye::kLeft, std::nan("")}},
                {SwappedPair{}, Window(3, 3)}});
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_EQ(errors[0].field, "faults[0].width_rad");
  EXPECT_EQ(errors[1].field, "faults[1].light");
  EXPECT_EQ(errors[2].field, "faults[2].share");
  EXPECT_EQ(errors[3].field, "faults[3].until_s");
}

}  // namespace
}  // namespace horopter::sim
