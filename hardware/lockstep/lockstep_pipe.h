// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hardware/interfaces/byte_stream.h"
#include "hardware/lockstep/lockstep_clock.h"
#include "hardware/types/config_error.h"

namespace horopter::hardware {

/// How an asynchronous serial line is set.
struct SerialLine {
  int baud = 115200;  ///< bits per second, each way
  int data_bits = 8;
  bool parity = false;
  int stop_bits = 1;

  /// A start bit, data, parity and stop bits: 10 for 8N1, 11 for the Koala's 8N2.
  int bits_per_byte() const { return 1 + data_bits + (parity ? 1 : 0) + stop_bits; }

  std::vector<FieldError> Validate() const;
};

/// The two ends of a full-duplex serial line in lockstep time.
///
/// Bytes leave back to back and arrive one by one: the n-th byte (from 1) of a burst that began at
/// t arrives at t + n bits_per_byte / baud, rounded to the nanosecond, so that a long burst does
/// not drift. A write while earlier bytes are still on the line queues behind them; Write() itself
/// takes no time.
///
/// Each end keeps the contract of ByteStream. After one end is closed, the other still receives
/// what was under way. Destroying an end closes it. A Read() that has to wait must come from a
/// participant of the clock (std::logic_error otherwise); once the clock is stopped, it returns
/// kDisconnected. Writing and closing are safe from any thread, and reproducible from participants.
/// The clock must outlive both ends.
struct LockstepPipe {
  /// @throws ConfigError naming every bad field of `line`.
  LockstepPipe(LockstepClock& clock, const SerialLine& line);

  std::unique_ptr<ByteStream> host;
  std::unique_ptr<ByteStream> device;
};

}  // namespace horopter::hardware
