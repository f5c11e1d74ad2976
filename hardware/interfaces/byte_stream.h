// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hardware/types/result.h"
#include "hardware/types/time.h"

namespace horopter::hardware {

/// An ordered, reliable stream of bytes: a serial port, a socket, or a lockstep queue.
///
/// Contract:
/// - Read() waits until at least one byte is there or `deadline` has come. It returns how many
///   bytes it stored (1 to buffer.size()); kTimeout when none came; kDisconnected once the other
///   end is closed and everything it sent has been read. Bytes come in order, once each, split and
///   merged at will.
/// - Write() accepts all bytes or returns kDisconnected.
/// - Close() is idempotent; reads and writes after it return kDisconnected.
/// - An empty buffer reads and writes zero bytes and succeeds on an open stream.
class ByteStream {
 public:
  virtual ~ByteStream() = default;

  virtual Result<std::size_t> Read(std::span<std::uint8_t> buffer, Time deadline) = 0;
  virtual Result<void> Write(std::span<const std::uint8_t> bytes) = 0;
  virtual void Close() = 0;
};

}  // namespace horopter::hardware
