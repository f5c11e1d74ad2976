// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "hardware/interfaces/byte_stream.h"
#include "hardware/interfaces/clock.h"

namespace horopter::hardware {

/// The contract of `ByteStream`, over implementations.
///
/// `Traits` is default-constructible, connects two ends that the test's thread may read and write,
/// and has
/// - `ByteStream& near_end()`, `ByteStream& far_end()`;
/// - `Clock& clock()`;
/// - `Duration patience()`: longer than 2000 bytes need to arrive.
template <typename Traits>
class ByteStreamContract : public testing::Test {
 protected:
  using Bytes = std::vector<std::uint8_t>;

  ByteStream& near_end() { return traits_.near_end(); }
  ByteStream& far_end() { return traits_.far_end(); }
  Time Soon() { return traits_.clock().Now() + traits_.patience(); }

  static Bytes Counting(int count) {
    Bytes bytes(count);
    for (int i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7);
    return bytes;
  }

  /// Reads until `count` bytes have come, `chunk` at most at a time, or an error.
  Bytes ReadAll(ByteStream& stream, std::size_t count, std::size_t chunk) {
    Bytes all, buffer(chunk);
    while (all.size() < count) {
      const auto n = stream.Read(buffer, Soon());
      if (!n.ok()) {
        ADD_FAILURE() << "after " << all.size() << " bytes: " << n.error().message;
        return all;
      }
      EXPECT_GE(*n, 1u);
      EXPECT_LE(*n, chunk);
      all.insert(all.end(), buffer.begin(), buffer.begin() + *n);
    }
    return all;
  }

  /// The error of a one-byte read; a byte that comes fails the test.
  ErrorCode ReadError(ByteStream& stream, Time deadline) {
    std::array<std::uint8_t, 1> buffer{};
    const auto n = stream.Read(buffer, deadline);
    EXPECT_FALSE(n.ok()) << "read a byte";
    return n.ok() ? ErrorCode::kUnavailable : n.error().code;
  }

  ErrorCode WriteError(ByteStream& stream) {
    const auto written = stream.Write(Counting(1));
    EXPECT_FALSE(written.ok()) << "wrote a byte";
    return written.ok() ? ErrorCode::kUnavailable : written.error().code;
  }

  Traits traits_;
};
TYPED_TEST_SUITE_P(ByteStreamContract);

TYPED_TEST_P(ByteStreamContract, BytesComeInOrderOnceEachInBothDirections) {
  const auto sent = this->Counting(2000);
  ASSERT_TRUE(this->near_end().Write(sent).ok());
  EXPECT_EQ(this->ReadAll(this->far_end(), sent.size(), 77), sent);
  ASSERT_TRUE(this->far_end().Write(sent).ok());
  EXPECT_EQ(this->ReadAll(this->near_end(), sent.size(), 4096), sent);
}

TYPED_TEST_P(ByteStreamContract, WritesMayBeSplitAndMergedButNeverReordered) {
  const auto sent = this->Counting(300);
  for (std::size_t i = 0; i < sent.size(); i += 30) {
    ASSERT_TRUE(this->near_end().Write({sent.data() + i, 30}).ok());
  }
  EXPECT_EQ(this->ReadAll(this->far_end(), sent.size(), 1), sent);
}

TYPED_TEST_P(ByteStreamContract, NothingTwiceAndNothingInvented) {
  ASSERT_TRUE(this->near_end().Write(this->Counting(3)).ok());
  this->ReadAll(this->far_end(), 3, 8);
  EXPECT_EQ(this->ReadError(this->far_end(), this->Soon()), ErrorCode::kTimeout);
  EXPECT_EQ(this->ReadError(this->near_end(), this->Soon()), ErrorCode::kTimeout);
}

TYPED_TEST_P(ByteStreamContract, AReadWaitsForItsDeadlineAndNotLess) {
  Clock& clock = this->traits_.clock();
  const Time deadline = clock.Now() + FromSeconds(0.005);
  EXPECT_EQ(this->ReadError(this->far_end(), deadline), ErrorCode::kTimeout);
  EXPECT_GE(clock.Now(), deadline);
}

TYPED_TEST_P(ByteStreamContract, APassedDeadlineStillReadsWhatIsThere) {
  ASSERT_TRUE(this->near_end().Write(this->Counting(1)).ok());
  this->traits_.clock().SleepUntil(this->Soon());
  std::array<std::uint8_t, 4> buffer{};
  const auto n = this->far_end().Read(buffer, Time{});
  ASSERT_TRUE(n.ok()) << n.error().message;
  EXPECT_EQ(*n, 1u);
  EXPECT_EQ(this->ReadError(this->far_end(), Time{}), ErrorCode::kTimeout);
}

TYPED_TEST_P(ByteStreamContract, EmptyBuffersSucceedAndMoveNothing) {
  EXPECT_TRUE(this->near_end().Write({}).ok());
  const auto none = this->far_end().Read({}, this->Soon());
  ASSERT_TRUE(none.ok()) << none.error().message;
  EXPECT_EQ(*none, 0u);
  ASSERT_TRUE(this->near_end().Write(this->Counting(1)).ok());
  const auto still_none = this->far_end().Read({}, this->Soon());
  ASSERT_TRUE(still_none.ok());
  EXPECT_EQ(*still_none, 0u);
  EXPECT_EQ(this->ReadAll(this->far_end(), 1, 1), this->Counting(1));
}

TYPED_TEST_P(ByteStreamContract, AClosedEndIsDisconnectedForEverAndClosingIsIdempotent) {
  ASSERT_TRUE(this->far_end().Write(this->Counting(5)).ok());
  this->near_end().Close();
  this->near_end().Close();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(this->ReadError(this->near_end(), this->Soon()), ErrorCode::kDisconnected);
    EXPECT_EQ(this->WriteError(this->near_end()), ErrorCode::kDisconnected);
  }
}

TYPED_TEST_P(ByteStreamContract, TheOtherEndReadsEverythingSentBeforeTheCloseAndThenKnows) {
  const auto sent = this->Counting(50);
  ASSERT_TRUE(this->near_end().Write(sent).ok());
  this->near_end().Close();
  EXPECT_EQ(this->ReadAll(this->far_end(), sent.size(), 16), sent);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(this->ReadError(this->far_end(), this->Soon()), ErrorCode::kDisconnected);
  }
  EXPECT_EQ(this->WriteError(this->far_end()), ErrorCode::kDisconnected);
}

REGISTER_TYPED_TEST_SUITE_P(ByteStreamContract, BytesComeInOrderOnceEachInBothDirections,
                            WritesMayBeSplitAndMergedButNeverReordered,
                            NothingTwiceAndNothingInvented, AReadWaitsForItsDeadlineAndNotLess,
                            APassedDeadlineStillReadsWhatIsThere, EmptyBuffersSucceedAndMoveNothing,
                            AClosedEndIsDisconnectedForEverAndClosingIsIdempotent,
                            TheOtherEndReadsEverythingSentBeforeTheCloseAndThenKnows);

}  // namespace horopter::hardware
