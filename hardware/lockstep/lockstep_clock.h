// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "hardware/interfaces/clock.h"

namespace horopter::hardware {

/// Thrown out of a wait that ended because the clock was stopped.
class LockstepStopped : public std::runtime_error {
 public:
  LockstepStopped() : std::runtime_error("the lockstep clock was stopped") {}
};

/// Simulated time shared by threads, which moves only when all of them wait.
///
/// Every thread that takes time is a participant. One participant runs at a time; the others wait
/// for a time (SleepUntil) or an event (WaitFor). When the running one begins to wait, the clock
/// picks the participant whose wait ends earliest, at equal times the one that was added first,
/// moves to that time and lets it run. A run is therefore the same on every machine and under any
/// load, as if it were single-threaded, although each driver keeps its own thread and its own
/// blocking code.
///
/// Use: add all participants, hand each to its thread, Start(), and bind in each thread:
///
///     LockstepClock clock([&](Time t) { while (world.now() + world.step() <= t) world.Step(); });
///     auto driver = clock.AddParticipant("koala driver");
///     std::thread thread([&, self = std::move(driver)]() mutable { self.Bind(); Drive(clock); });
///     clock.Start();
///
/// Rules that the clock cannot check: a participant must not wait by other means for something
/// that another one does (join, a mutex held across a wait), since the other one is not running;
/// and once the clock has started, participants are added by a thread that is running on it, or
/// their order is not reproducible. A participant that leaves (its handle is destroyed) holds
/// nobody up.
///
/// When no wait has an end, time stands still until Stop(), until somebody joins, or until an
/// event from outside is announced.
class LockstepClock final : public Clock {
 public:
  /// Brings the world to the given time. Called with strictly increasing times, before Now() shows
  /// them, never by two threads at once but by any of the participants' threads. Must not wait on
  /// this clock. What it throws stops the clock and comes out of every participant's wait.
  using Advance = std::function<void(Time)>;

  /// The time at which an event ends a wait, given what has happened so far; nothing while none is
  /// in sight. Times that have passed count as now. Called with the clock's lock held, by any
  /// thread; must not throw.
  using NextEvent = std::function<std::optional<Time>()>;

  enum class Wake { kDeadline, kEvent, kStopped };

  /// A thread's seat at the clock. Leaves when destroyed, which its own thread does once it has
  /// bound. The clock must outlive it.
  class Participant {
   public:
    Participant() = default;
    ~Participant() { Leave(); }
    Participant(Participant&& other) noexcept;
    Participant& operator=(Participant&& other) noexcept;

    /// Makes the calling thread this participant and waits for its turn to run.
    /// @throws std::logic_error when the participant is bound already or has left, or the thread
    ///         is bound to another one; LockstepStopped when the clock has been stopped.
    void Bind();

    /// Gives up the seat; what destruction does.
    void Leave();

   private:
    friend class LockstepClock;
    Participant(LockstepClock* clock, int id) : clock_(clock), id_(id) {}

    LockstepClock* clock_ = nullptr;
    int id_ = -1;
  };

  explicit LockstepClock(Advance advance = {});
  /// @pre all participants have left.
  ~LockstepClock() override;
  LockstepClock(const LockstepClock&) = delete;
  LockstepClock& operator=(const LockstepClock&) = delete;

  /// A new participant, due at once; the order of these calls decides who runs first at equal
  /// times. @param name for error messages.
  [[nodiscard]] Participant AddParticipant(std::string name);

  /// Lets the participants run. Idempotent.
  void Start();

  /// Ends every wait, now and later; time stands still from then on. Allowed from any thread,
  /// idempotent. Afterwards participants run at the same time: they should only unwind.
  void Stop();

  bool stopped() const;

  Time Now() const override { return Time(Duration(now_ns_.load(std::memory_order_acquire))); }

  /// Waits until Now() == t exactly, or returns at once when t has passed. Time::max() is never.
  /// @throws std::logic_error when the calling thread is no participant; LockstepStopped, or what
  ///         the advance hook threw, once the clock is stopped.
  void SleepUntil(Time t) override;

  /// Waits for an event or a deadline, whichever comes first; an event at the deadline counts as
  /// an event. What streams are built from.
  /// @throws std::logic_error when the calling thread is no participant.
  Wake WaitFor(Time deadline, const NextEvent& next_event);

  /// To be called after something that another participant's NextEvent looks at has changed:
  /// makes the change count when all are waiting, as they can be when it came from outside.
  void Announce();

 private:
  struct Seat {
    std::string name;
    std::thread::id thread;            ///< none until bound
    Time deadline{};                   ///< of the wait it is in
    const NextEvent* event = nullptr;  ///< likewise; owned by the waiting thread's stack
    std::condition_variable turn{};
  };

  /// All of these expect the lock to be held.
  Seat* SeatOfThisThread();
  Time EndOfWait(const Seat& seat) const;
  void PassTheTurn();
  void AwaitTurn(std::unique_lock<std::mutex>& lock, Seat& seat);
  void StopLocked();

  void BindThisThread(int id);
  void Remove(int id);

  const Advance advance_;
  std::atomic<std::int64_t> now_ns_{0};

  mutable std::mutex mutex_;
  std::map<int, Seat> seats_;  ///< by id, which is the order of joining
  Seat* running_ = nullptr;    ///< whose turn it is, even before its thread has bound
  int next_id_ = 0;
  bool started_ = false;
  bool stopped_ = false;
  std::exception_ptr failure_;  ///< what the advance hook threw
};

}  // namespace horopter::hardware
