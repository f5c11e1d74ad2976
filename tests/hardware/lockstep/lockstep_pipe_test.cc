// SPDX-License-Identifier: Apache-2.0
#include "hardware/lockstep/lockstep_pipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

namespace horopter::hardware {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr SerialLine kKoalaLine{.baud = 38400, .data_bits = 8, .parity = false, .stop_bits = 2};

Time At(Duration d) { return Time(d); }

Result<void> Send(ByteStream& stream, const std::string& text) {
  return stream.Write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// One thread at both ends: writing never waits.
class LockstepPipeTest : public testing::Test {
 protected:
  LockstepPipeTest() {
    clock_.Start();
    self_.Bind();
  }

  /// What one Read() with room for 64 bytes brings; empty on a time-out.
  std::string Receive(ByteStream& stream, Time deadline = Time::max()) {
    std::array<std::uint8_t, 64> buffer{};
    const auto n = stream.Read(buffer, deadline);
    if (!n.ok()) {
      EXPECT_EQ(n.error().code, ErrorCode::kTimeout) << n.error().message;
      return "";
    }
    return {buffer.begin(), buffer.begin() + *n};
  }

  ErrorCode ReadError(ByteStream& stream, Time deadline = Time::max()) {
    std::array<std::uint8_t, 4> buffer{};
    const auto n = stream.Read(buffer, deadline);
    EXPECT_FALSE(n.ok());
    return n.ok() ? ErrorCode::kUnavailable : n.error().code;
  }

  LockstepClock clock_;
  LockstepClock::Participant self_ = clock_.AddParticipant("test");
  LockstepPipe pipe_{clock_, kKoalaLine};
};

TEST_F(LockstepPipeTest, BytesArriveOneByOneElevenBitTimesApart) {
  ASSERT_TRUE(Send(*pipe_.host, "abc"));
  std::vector<std::int64_t> arrivals;
  for (const char expected : {'a', 'b', 'c'}) {
    EXPECT_EQ(Receive(*pipe_.device), std::string(1, expected));
    arrivals.push_back(clock_.Now().time_since_epoch().count());
  }
  // 11 bits at 38400 baud: 286458.33 ns each.
  EXPECT_THAT(arrivals, ElementsAre(286'458, 572'917, 859'375));
}

TEST_F(LockstepPipeTest, ALongBurstDoesNotDrift) {
  ASSERT_TRUE(Send(*pipe_.host, std::string(38400, 'x')));
  clock_.SleepUntil(At(11s) - 1ns);
  std::vector<std::uint8_t> buffer(40000);
  EXPECT_EQ(*pipe_.device->Read(buffer, At(0s)), 38399u);
  EXPECT_EQ(*pipe_.device->Read(buffer, Time::max()), 1u);
  EXPECT_EQ(clock_.Now(), At(11s));
}

TEST_F(LockstepPipeTest, WritesQueueBehindBytesStillOnTheLine) {
  ASSERT_TRUE(Send(*pipe_.host, "ab"));
  clock_.SleepUntil(At(100us));
  ASSERT_TRUE(Send(*pipe_.host, "c"));
  clock_.SleepUntil(At(859'375ns) - 1ns);
  EXPECT_EQ(Receive(*pipe_.device), "ab");
  EXPECT_EQ(Receive(*pipe_.device), "c");
  EXPECT_EQ(clock_.Now(), At(859'375ns));
}

TEST_F(LockstepPipeTest, AnIdleLineStartsANewBurst) {
  ASSERT_TRUE(Send(*pipe_.host, "a"));
  clock_.SleepUntil(At(10ms));
  ASSERT_TRUE(Send(*pipe_.host, "b"));
  clock_.SleepUntil(At(10'286'458ns) - 1ns);
  EXPECT_EQ(Receive(*pipe_.device), "a");
  EXPECT_EQ(Receive(*pipe_.device), "b");
  EXPECT_EQ(clock_.Now(), At(10'286'458ns));
}

TEST_F(LockstepPipeTest, TheTwoDirectionsDoNotDelayEachOther) {
  ASSERT_TRUE(Send(*pipe_.host, std::string(100, 'x')));
  ASSERT_TRUE(Send(*pipe_.device, "r"));
  EXPECT_EQ(Receive(*pipe_.host), "r");
  EXPECT_EQ(clock_.Now(), At(286'458ns));
}

TEST_F(LockstepPipeTest, DeadlineComesExactlyAndAByteArrivingThenStillCounts) {
  EXPECT_EQ(Receive(*pipe_.device, At(3ms)), "");
  EXPECT_EQ(clock_.Now(), At(3ms));
  ASSERT_TRUE(Send(*pipe_.host, "a"));
  EXPECT_EQ(Receive(*pipe_.device, At(3ms) + 286'457ns), "");
  EXPECT_EQ(Receive(*pipe_.device, At(3ms) + 286'458ns), "a");
}

TEST_F(LockstepPipeTest, WhatWasUnderWayArrivesAfterTheSenderCloses) {
  ASSERT_TRUE(Send(*pipe_.host, "ab"));
  pipe_.host->Close();
  EXPECT_EQ(Receive(*pipe_.device), "a");
  EXPECT_EQ(Receive(*pipe_.device), "b");
  EXPECT_EQ(clock_.Now(), At(572'917ns));
  EXPECT_EQ(ReadError(*pipe_.device), ErrorCode::kDisconnected);
  EXPECT_EQ(clock_.Now(), At(572'917ns));
}

TEST_F(LockstepPipeTest, DestroyingAnEndClosesIt) {
  pipe_.device.reset();
  EXPECT_EQ(ReadError(*pipe_.host), ErrorCode::kDisconnected);
  EXPECT_EQ(Send(*pipe_.host, "x").error().code, ErrorCode::kDisconnected);
}

TEST_F(LockstepPipeTest, AStoppedClockDisconnectsReaders) {
  clock_.Stop();
  EXPECT_EQ(ReadError(*pipe_.host), ErrorCode::kDisconnected);
}

TEST_F(LockstepPipeTest, AStrangerMayNotWaitOnIt) {
  std::thread([this] {
    std::array<std::uint8_t, 4> buffer{};
    EXPECT_THROW(static_cast<void>(pipe_.host->Read(buffer, Time::max())), std::logic_error);
  }).join();
}

TEST(SerialLine, CountsTheBitsOfAByte) {
  EXPECT_EQ(SerialLine{}.bits_per_byte(), 10);
  EXPECT_EQ(kKoalaLine.bits_per_byte(), 11);
  EXPECT_EQ((SerialLine{9600, 7, true, 1}).bits_per_byte(), 10);
}

TEST(SerialLine, EveryBadFieldIsReported) {
  LockstepClock clock;
  try {
    const LockstepPipe pipe(clock, {.baud = 0, .data_bits = 12, .parity = false, .stop_bits = 0});
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    ASSERT_EQ(error.errors().size(), 3u);
    EXPECT_EQ(error.errors()[0].ToString(), "line.baud = 0: must be at least 1");
  }
}

/// An instrument that answers each line with its number, 300 us later.
void Echo(LockstepClock& clock, ByteStream& stream) {
  int lines = 0;
  std::array<std::uint8_t, 16> buffer{};
  for (;;) {
    const auto n = stream.Read(buffer, Time::max());
    if (!n.ok()) return;
    for (std::size_t i = 0; i < *n; ++i) {
      if (buffer[i] != '\n') continue;
      clock.SleepUntil(clock.Now() + 300us);
      if (!Send(stream, std::to_string(++lines) + "\n").ok()) return;
    }
  }
}

/// Asks at a fixed period; returns when each byte of an answer came.
std::vector<std::int64_t> Ask(LockstepClock& clock, ByteStream& stream, Duration period) {
  std::vector<std::int64_t> log;
  std::array<std::uint8_t, 16> buffer{};
  for (int i = 1; i <= 8; ++i) {
    EXPECT_TRUE(Send(stream, "H\n").ok());
    for (std::uint8_t last = 0; last != '\n';) {
      const auto n = stream.Read(buffer, clock.Now() + 20ms);
      if (!n.ok()) return log;
      last = buffer[*n - 1];
      log.push_back(clock.Now().time_since_epoch().count() * 256 + last);
    }
    clock.SleepUntil(At(i * period));
  }
  stream.Close();
  return log;
}

std::vector<std::vector<std::int64_t>> TwoDriversAndTheirInstruments() {
  LockstepClock clock;
  LockstepPipe koala(clock, kKoalaLine), ptu(clock, {.baud = 9600});
  std::vector<std::vector<std::int64_t>> logs(2);
  std::vector<std::thread> threads;
  const auto add = [&](const char* name, auto body) {
    threads.emplace_back([self = clock.AddParticipant(name), body]() mutable {
      self.Bind();
      body();
    });
  };
  add("koala", [&] { Echo(clock, *koala.device); });
  add("ptu", [&] { Echo(clock, *ptu.device); });
  add("base driver", [&] { logs[0] = Ask(clock, *koala.host, 10ms); });
  add("head driver", [&] { logs[1] = Ask(clock, *ptu.host, 15ms); });
  clock.Start();
  for (std::thread& thread : threads) thread.join();
  return logs;
}

TEST(LockstepPipe, FiftyRunsOfTwoDriversAgainstTheirInstrumentsAreEqual) {
  const auto first = TwoDriversAndTheirInstruments();
  ASSERT_EQ(first[0].size(), 16u);  // eight answers of a digit and a newline
  ASSERT_EQ(first[1].size(), 16u);
  // 22 bits of request, 300 us of thought, 11 bits of answer.
  EXPECT_EQ(first[0][0] / 256, 572'917 + 300'000 + 286'458);
  for (int i = 1; i < 50; ++i) ASSERT_EQ(TwoDriversAndTheirInstruments(), first) << "run " << i;
}

}  // namespace
}  // namespace horopter::hardware
