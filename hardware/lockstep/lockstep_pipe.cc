// SPDX-License-Identifier: Apache-2.0
#include "hardware/lockstep/lockstep_pipe.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::hardware {
namespace {

Error Disconnected(std::string message) {
  return Error{ErrorCode::kDisconnected, std::move(message)};
}

/// One direction of the line: bytes on their way and when each arrives.
class Lane {
 public:
  explicit Lane(const SerialLine& line) : line_(line) {}

  void Send(std::span<const std::uint8_t> bytes, Time now) {
    if (now > Arrival(sent_)) {
      burst_start_ = now;
      sent_ = 0;
    }
    for (const std::uint8_t byte : bytes) under_way_.push_back({Arrival(++sent_), byte});
  }

  /// Moves what has arrived by `now` into `buffer`; returns how much.
  std::size_t Receive(std::span<std::uint8_t> buffer, Time now) {
    std::size_t n = 0;
    while (n < buffer.size() && !under_way_.empty() && under_way_.front().arrival <= now) {
      buffer[n++] = under_way_.front().value;
      under_way_.pop_front();
    }
    return n;
  }

  std::optional<Time> next_arrival() const {
    if (under_way_.empty()) return std::nullopt;
    return under_way_.front().arrival;
  }

  void Clear() { under_way_.clear(); }

 private:
  struct Byte {
    Time arrival;
    std::uint8_t value;
  };

  /// When the n-th byte of the present burst is there.
  Time Arrival(std::int64_t n) const {
    constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
    const std::int64_t bits = n * line_.bits_per_byte();
    const std::int64_t seconds = bits / line_.baud;
    const std::int64_t rest = bits % line_.baud * kNanosecondsPerSecond;
    return burst_start_ +
           Duration(seconds * kNanosecondsPerSecond + (rest + line_.baud / 2) / line_.baud);
  }

  const SerialLine line_;
  std::deque<Byte> under_way_;
  Time burst_start_{};
  std::int64_t sent_ = 0;  ///< bytes in the present burst
};

enum End { kHost = 0, kDevice = 1 };

struct Line {
  explicit Line(const SerialLine& settings) : towards{Lane(settings), Lane(settings)} {}

  std::mutex mutex;  ///< taken after the clock's, never before
  Lane towards[2];   ///< towards[kHost]: what the host will read
  bool closed[2] = {false, false};
};

class PipeEnd final : public ByteStream {
 public:
  PipeEnd(LockstepClock& clock, std::shared_ptr<Line> line, End self)
      : clock_(clock),
        line_(std::move(line)),
        self_(self),
        peer_(self == kHost ? kDevice : kHost) {}

  ~PipeEnd() override { Close(); }

  Result<std::size_t> Read(std::span<std::uint8_t> buffer, Time deadline) override {
    const LockstepClock::NextEvent next_event = [this] { return NextEvent(); };
    for (;;) {
      if (const auto result = TryRead(buffer)) return *result;
      if (clock_.Now() >= deadline)
        return Error{ErrorCode::kTimeout, "no byte before the deadline"};
      if (clock_.WaitFor(deadline, next_event) == LockstepClock::Wake::kStopped) {
        return Disconnected("the lockstep clock was stopped");
      }
    }
  }

  Result<void> Write(std::span<const std::uint8_t> bytes) override {
    {
      const std::lock_guard lock(line_->mutex);
      if (line_->closed[self_]) return Disconnected("this end of the line is closed");
      if (line_->closed[peer_]) return Disconnected("the other end of the line is closed");
      line_->towards[peer_].Send(bytes, clock_.Now());
    }
    clock_.Announce();
    return {};
  }

  void Close() override {
    {
      const std::lock_guard lock(line_->mutex);
      if (line_->closed[self_]) return;
      line_->closed[self_] = true;
      line_->towards[self_].Clear();
    }
    clock_.Announce();
  }

 private:
  /// What Read() returns without waiting; nothing when it has to wait.
  std::optional<Result<std::size_t>> TryRead(std::span<std::uint8_t> buffer) {
    const std::lock_guard lock(line_->mutex);
    Lane& lane = line_->towards[self_];
    if (line_->closed[self_]) return Disconnected("this end of the line is closed");
    if (buffer.empty()) return std::size_t{0};
    if (const std::size_t n = lane.Receive(buffer, clock_.Now())) return n;
    if (line_->closed[peer_] && !lane.next_arrival()) {
      return Disconnected("the other end of the line is closed");
    }
    return std::nullopt;
  }

  std::optional<Time> NextEvent() {
    const std::lock_guard lock(line_->mutex);
    if (line_->closed[self_]) return clock_.Now();
    if (const auto arrival = line_->towards[self_].next_arrival()) return arrival;
    if (line_->closed[peer_]) return clock_.Now();
    return std::nullopt;
  }

  LockstepClock& clock_;
  const std::shared_ptr<Line> line_;  // shared by the two ends, whichever lives longer
  const End self_;
  const End peer_;
};

}  // namespace

std::vector<FieldError> SerialLine::Validate() const {
  FieldChecker check("line.");
  check.Require(baud >= 1, "baud", baud, "must be at least 1");
  check.Require(data_bits >= 5 && data_bits <= 9, "data_bits", data_bits, "must be 5 to 9");
  check.Require(stop_bits == 1 || stop_bits == 2, "stop_bits", stop_bits, "must be 1 or 2");
  return check.Take();
}

LockstepPipe::LockstepPipe(LockstepClock& clock, const SerialLine& line) {
  ThrowIfAny(line.Validate());
  const auto shared = std::make_shared<Line>(line);
  host = std::make_unique<PipeEnd>(clock, shared, kHost);
  device = std::make_unique<PipeEnd>(clock, shared, kDevice);
}

}  // namespace horopter::hardware
