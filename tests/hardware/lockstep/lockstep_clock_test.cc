// SPDX-License-Identifier: Apache-2.0
#include "hardware/lockstep/lockstep_clock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace horopter::hardware {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

Time At(Duration d) { return Time(d); }

/// Threads on one clock, in the order of Add(). No lock guards what the bodies write: that one at
/// a time runs is the clock's promise, and the thread sanitizer checks it.
class Crew {
 public:
  explicit Crew(LockstepClock& clock) : clock_(clock) {}

  void Add(const std::string& name, std::function<void()> body) {
    threads_.emplace_back([self = clock_.AddParticipant(name), body = std::move(body)]() mutable {
      try {
        self.Bind();
        body();
      } catch (const LockstepStopped&) {
      }
    });
  }

  void Run() {
    clock_.Start();
    Join();
  }

  void Join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  LockstepClock& clock_;
  std::vector<std::thread> threads_;
};

TEST(LockstepClock, WakesByTimeThenByOrderOfJoining) {
  LockstepClock clock;
  std::vector<std::string> log;
  Crew crew(clock);
  const auto sleeper = [&](const std::string& name, std::vector<Duration> times) {
    crew.Add(name, [&clock, &log, name, times] {
      for (const Duration t : times) {
        clock.SleepUntil(At(t));
        EXPECT_EQ(clock.Now(), At(t));
        log.push_back(name + std::to_string(t.count()));
      }
    });
  };
  sleeper("a", {30ns, 40ns});
  sleeper("b", {10ns, 40ns});
  sleeper("c", {20ns, 30ns, 40ns});
  crew.Run();
  EXPECT_THAT(log, ElementsAre("b10", "c20", "a30", "c30", "a40", "b40", "c40"));
  EXPECT_EQ(clock.Now(), At(40ns));
}

TEST(LockstepClock, PassedTimesReturnAtOnceAndKeepTheTurn) {
  LockstepClock clock;
  std::vector<int> log;
  Crew crew(clock);
  crew.Add("first", [&] {
    clock.SleepUntil(At(5ms));
    log.push_back(1);
    clock.SleepUntil(At(5ms));
    clock.SleepUntil(At(1ms));
    log.push_back(2);
    EXPECT_EQ(clock.Now(), At(5ms));
  });
  crew.Add("second", [&] {
    clock.SleepUntil(At(5ms));
    log.push_back(3);
  });
  crew.Run();
  EXPECT_THAT(log, ElementsAre(1, 2, 3));
}

TEST(LockstepClock, NobodyRunsBeforeStart) {
  LockstepClock clock;
  bool started = false;
  Crew crew(clock);
  for (int i = 0; i < 3; ++i) {
    crew.Add("early", [&] { EXPECT_TRUE(started); });
  }
  started = true;
  crew.Run();
}

TEST(LockstepClock, WaitsForAParticipantWhoseThreadIsLate) {
  LockstepClock clock;
  auto late = clock.AddParticipant("late");
  bool late_ran = false;
  Crew crew(clock);
  crew.Add("prompt", [&] {
    EXPECT_TRUE(late_ran) << "the one added first runs first, whichever thread is there first";
    clock.SleepUntil(At(1s));
  });
  clock.Start();
  EXPECT_EQ(clock.Now(), At(0ns));
  std::thread thread([&, self = std::move(late)]() mutable {
    self.Bind();
    late_ran = true;
  });
  thread.join();
  crew.Join();
  EXPECT_EQ(clock.Now(), At(1s));
}

TEST(LockstepClock, AdvancesTheWorldToEveryTimeBeforeItShows) {
  std::vector<std::int64_t> steps;
  const LockstepClock* seen = nullptr;
  LockstepClock clock([&](Time t) {
    EXPECT_LT(seen->Now(), t);
    steps.push_back(t.time_since_epoch().count());
  });
  seen = &clock;
  Crew crew(clock);
  const auto check_world = [&] { EXPECT_EQ(steps.back(), clock.Now().time_since_epoch().count()); };
  crew.Add("even", [&] {
    for (const Duration t : {2ns, 4ns, 6ns}) clock.SleepUntil(At(t)), check_world();
  });
  crew.Add("odd", [&] {
    for (const Duration t : {3ns, 4ns, 5ns}) clock.SleepUntil(At(t)), check_world();
  });
  crew.Run();
  EXPECT_THAT(steps, ElementsAre(2, 3, 4, 5, 6));
}

TEST(LockstepClock, AnEventEndsAWaitBeforeItsDeadline) {
  LockstepClock clock;
  std::optional<Time> event;  // guarded by the turn
  std::vector<LockstepClock::Wake> wakes;
  Crew crew(clock);
  crew.Add("waiter", [&] {
    wakes.push_back(clock.WaitFor(At(100ms), [&] { return event; }));
    EXPECT_EQ(clock.Now(), At(30ms));
    event.reset();
    wakes.push_back(clock.WaitFor(At(100ms), [&] { return event; }));
    EXPECT_EQ(clock.Now(), At(100ms));
    event = At(120ms);
    wakes.push_back(clock.WaitFor(At(120ms), [&] { return event; }));
    EXPECT_EQ(clock.Now(), At(120ms));
  });
  crew.Add("sender", [&] {
    clock.SleepUntil(At(10ms));
    event = At(30ms);
  });
  crew.Run();
  using Wake = LockstepClock::Wake;
  EXPECT_THAT(wakes, ElementsAre(Wake::kEvent, Wake::kDeadline, Wake::kEvent));
}

TEST(LockstepClock, ALeavingParticipantHoldsNobodyUp) {
  LockstepClock clock;
  auto never_bound = clock.AddParticipant("never bound");
  Crew crew(clock);
  crew.Add("leaves at once", [] {});
  crew.Add("stays", [&] {
    for (int i = 1; i <= 10; ++i) clock.SleepUntil(At(i * 1ms));
  });
  clock.Start();
  never_bound.Leave();
  crew.Join();
  EXPECT_EQ(clock.Now(), At(10ms));
}

TEST(LockstepClock, AParticipantMayAddAnotherWhileItRuns) {
  LockstepClock clock;
  std::vector<std::string> log;
  Crew crew(clock), later(clock);
  crew.Add("parent", [&] {
    clock.SleepUntil(At(10ms));
    later.Add("child", [&] {
      log.push_back("child at " + std::to_string(clock.Now().time_since_epoch() / 1ms));
      clock.SleepUntil(At(20ms));
      log.push_back("child");
    });
    log.push_back("parent");
    clock.SleepUntil(At(20ms));
    log.push_back("parent");
  });
  crew.Run();
  later.Join();
  EXPECT_THAT(log, ElementsAre("parent", "child at 10", "parent", "child"));
}

TEST(LockstepClock, StopEndsEveryWaitAlsoThoseWithoutEnd) {
  LockstepClock clock;
  int stopped = 0;
  std::mutex mutex;
  Crew crew(clock);
  for (int i = 0; i < 3; ++i) {
    crew.Add("for ever", [&] {
      try {
        clock.SleepUntil(Time::max());
      } catch (const LockstepStopped&) {
        const std::lock_guard lock(mutex);
        ++stopped;
        throw;
      }
      ADD_FAILURE() << "Time::max() has come";
    });
  }
  crew.Add("stopper", [&] {
    clock.SleepUntil(At(1s));
    clock.Stop();
    clock.Stop();
    EXPECT_THROW(clock.SleepUntil(At(2s)), LockstepStopped);
    EXPECT_EQ(clock.WaitFor(At(2s), {}), LockstepClock::Wake::kStopped);
  });
  crew.Run();
  EXPECT_EQ(stopped, 3);
  EXPECT_TRUE(clock.stopped());
  EXPECT_EQ(clock.Now(), At(1s)) << "time stands still once stopped";
}

TEST(LockstepClock, StopBeforeStartReleasesThoseThatBind) {
  LockstepClock clock;
  Crew crew(clock);
  crew.Add("bound too early", [] { ADD_FAILURE() << "ran on a stopped clock"; });
  clock.Stop();
  crew.Run();
}

TEST(LockstepClock, WhatTheWorldThrowsComesOutOfEveryWait) {
  LockstepClock clock([](Time t) {
    if (t > At(5ms)) throw std::runtime_error("the world broke");
  });
  int caught = 0;
  std::mutex mutex;
  Crew crew(clock);
  for (int i = 0; i < 3; ++i) {
    crew.Add("participant", [&, i] {
      try {
        for (int k = 1;; ++k) clock.SleepUntil(At(k * 1ms + i * 1us));
      } catch (const std::runtime_error& error) {
        const std::lock_guard lock(mutex);
        caught += std::string(error.what()) == "the world broke";
      }
    });
  }
  crew.Run();
  EXPECT_EQ(caught, 3);
  EXPECT_EQ(clock.Now(), At(5ms)) << "no time is shown that the world has not reached";
}

TEST(LockstepClock, MisuseIsRefusedWithTheRemedy) {
  LockstepClock clock;
  try {
    clock.SleepUntil(At(1ms));
    FAIL() << "a stranger slept";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("Bind()"), std::string::npos);
  }
  auto a = clock.AddParticipant("a");
  auto b = clock.AddParticipant("b");
  clock.Start();
  a.Bind();
  EXPECT_THROW(a.Bind(), std::logic_error);
  EXPECT_THROW(b.Bind(), std::logic_error);
  a.Leave();
  EXPECT_THROW(a.Bind(), std::logic_error);
  LockstepClock::Participant moved = std::move(b);
  moved.Bind();
}

/// Three threads that sleep pseudo-random times, each from its own stream but fed by what the
/// others wrote last, so that any change of order changes everything after it.
std::vector<std::uint64_t> RunOfThree() {
  std::vector<std::uint64_t> log;
  std::uint64_t shared = 1;
  LockstepClock clock([&](Time t) { shared ^= t.time_since_epoch().count(); });
  Crew crew(clock);
  for (std::uint64_t id = 1; id <= 3; ++id) {
    crew.Add("thread", [&, id] {
      for (int i = 0; i < 60; ++i) {
        shared = (shared + id) * 6364136223846793005u + 1442695040888963407u;
        log.push_back(shared);
        clock.SleepUntil(clock.Now() + Duration(shared >> 62));  // 0 to 3 ns: many ties
      }
    });
  }
  crew.Run();
  return log;
}

TEST(LockstepClock, FiftyRunsOfThreeThreadsAreEqual) {
  const std::vector<std::uint64_t> first = RunOfThree();
  ASSERT_EQ(first.size(), 180u);
  for (int i = 1; i < 50; ++i) ASSERT_EQ(RunOfThree(), first) << "run " << i;
}

}  // namespace
}  // namespace horopter::hardware
