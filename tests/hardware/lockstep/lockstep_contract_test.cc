// SPDX-License-Identifier: Apache-2.0
#include "hardware/lockstep/lockstep_clock.h"
#include "hardware/lockstep/lockstep_pipe.h"
#include "tests/hardware/interfaces/contract_byte_stream.h"
#include "tests/hardware/interfaces/contract_clock.h"

namespace horopter::hardware {
namespace {

/// The test's thread, alone on a lockstep clock.
class LockstepClockTraits {
 public:
  LockstepClockTraits() {
    clock_.Start();
    self_.Bind();
  }
  Clock& clock() { return clock_; }
  static std::optional<Duration> step() { return Duration(0); }

 protected:
  LockstepClock clock_;
  LockstepClock::Participant self_ = clock_.AddParticipant("test");
};

template <int kBaud, int kStopBits>
class LockstepPipeTraits : public LockstepClockTraits {
 public:
  ByteStream& near_end() { return *pipe_.host; }
  ByteStream& far_end() { return *pipe_.device; }
  static Duration patience() { return FromSeconds(2100.0 * (9 + kStopBits) / kBaud); }

 private:
  LockstepPipe pipe_{clock_, {.baud = kBaud, .stop_bits = kStopBits}};
};

INSTANTIATE_TYPED_TEST_SUITE_P(Lockstep, ClockContract, LockstepClockTraits);

using Lines = testing::Types<LockstepPipeTraits<38400, 2>, LockstepPipeTraits<9600, 1>>;
INSTANTIATE_TYPED_TEST_SUITE_P(LockstepPipe, ByteStreamContract, Lines);

}  // namespace
}  // namespace horopter::hardware
