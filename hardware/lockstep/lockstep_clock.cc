// SPDX-License-Identifier: Apache-2.0
#include "hardware/lockstep/lockstep_clock.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace horopter::hardware {

LockstepClock::Participant::Participant(Participant&& other) noexcept
    : clock_(std::exchange(other.clock_, nullptr)), id_(std::exchange(other.id_, -1)) {}

LockstepClock::Participant& LockstepClock::Participant::operator=(Participant&& other) noexcept {
  if (this != &other) {
    Leave();
    clock_ = std::exchange(other.clock_, nullptr);
    id_ = std::exchange(other.id_, -1);
  }
  return *this;
}

void LockstepClock::Participant::Bind() {
  if (clock_ == nullptr) throw std::logic_error("a lockstep participant that has left cannot bind");
  clock_->BindThisThread(id_);
}

void LockstepClock::Participant::Leave() {
  if (clock_ != nullptr) std::exchange(clock_, nullptr)->Remove(id_);
}

LockstepClock::LockstepClock(Advance advance) : advance_(std::move(advance)) {}

LockstepClock::~LockstepClock() { assert(seats_.empty()); }

LockstepClock::Participant LockstepClock::AddParticipant(std::string name) {
  const std::lock_guard lock(mutex_);
  const int id = next_id_++;
  Seat& seat = seats_[id];
  seat.name = std::move(name);
  seat.deadline = Now();
  PassTheTurn();
  return Participant(this, id);
}

void LockstepClock::Start() {
  const std::lock_guard lock(mutex_);
  started_ = true;
  PassTheTurn();
}

void LockstepClock::Stop() {
  const std::lock_guard lock(mutex_);
  StopLocked();
}

bool LockstepClock::stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void LockstepClock::SleepUntil(Time t) {
  if (Now() >= t) return;
  if (WaitFor(t, {}) != Wake::kStopped) return;
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  throw LockstepStopped();
}

LockstepClock::Wake LockstepClock::WaitFor(Time deadline, const NextEvent& next_event) {
  std::unique_lock lock(mutex_);
  if (stopped_) return Wake::kStopped;
  Seat* const seat = SeatOfThisThread();
  if (seat == nullptr) {
    throw std::logic_error(
        "a thread that is no participant waits on a lockstep clock: AddParticipant() and Bind() "
        "it first");
  }
  seat->deadline = deadline;
  seat->event = next_event ? &next_event : nullptr;
  running_ = nullptr;
  PassTheTurn();
  AwaitTurn(lock, *seat);
  const bool event = seat->event != nullptr && [&] {
    const std::optional<Time> at = next_event();
    return at.has_value() && *at <= Now();
  }();
  seat->event = nullptr;
  if (stopped_) return Wake::kStopped;
  return event ? Wake::kEvent : Wake::kDeadline;
}

void LockstepClock::Announce() {
  const std::lock_guard lock(mutex_);
  PassTheTurn();
}

LockstepClock::Seat* LockstepClock::SeatOfThisThread() {
  const auto self = std::this_thread::get_id();
  const auto found = std::find_if(seats_.begin(), seats_.end(), [self](const auto& entry) {
    return entry.second.thread == self;
  });
  return found == seats_.end() ? nullptr : &found->second;
}

Time LockstepClock::EndOfWait(const Seat& seat) const {
  Time end = seat.deadline;
  if (seat.event != nullptr) {
    if (const std::optional<Time> at = (*seat.event)()) end = std::min(end, *at);
  }
  return std::max(end, Now());
}

void LockstepClock::PassTheTurn() {
  if (!started_ || stopped_ || running_ != nullptr) return;
  Seat* next = nullptr;
  Time earliest = Time::max();
  for (auto& [id, seat] : seats_) {
    const Time end = EndOfWait(seat);
    if (end < earliest) {
      earliest = end;
      next = &seat;
    }
  }
  if (next == nullptr) return;
  if (earliest > Now()) {
    try {
      if (advance_) advance_(earliest);
    } catch (...) {
      failure_ = std::current_exception();
      StopLocked();
      return;
    }
    now_ns_.store(earliest.time_since_epoch().count(), std::memory_order_release);
  }
  running_ = next;
  next->turn.notify_one();
}

void LockstepClock::AwaitTurn(std::unique_lock<std::mutex>& lock, Seat& seat) {
  seat.turn.wait(lock, [this, &seat] { return running_ == &seat || stopped_; });
}

void LockstepClock::StopLocked() {
  stopped_ = true;
  for (auto& [id, seat] : seats_) seat.turn.notify_one();
}

void LockstepClock::BindThisThread(int id) {
  std::unique_lock lock(mutex_);
  Seat& seat = seats_.at(id);
  if (seat.thread != std::thread::id{}) {
    throw std::logic_error("lockstep participant \"" + seat.name + "\" is bound already");
  }
  if (const Seat* other = SeatOfThisThread()) {
    throw std::logic_error("this thread is lockstep participant \"" + other->name +
                           "\" and cannot also be \"" + seat.name + "\"");
  }
  seat.thread = std::this_thread::get_id();
  AwaitTurn(lock, seat);
  if (failure_) std::rethrow_exception(failure_);
  if (stopped_) throw LockstepStopped();
}

void LockstepClock::Remove(int id) {
  const std::lock_guard lock(mutex_);
  const auto found = seats_.find(id);
  if (running_ == &found->second) running_ = nullptr;
  seats_.erase(found);
  PassTheTurn();
}

}  // namespace horopter::hardware
