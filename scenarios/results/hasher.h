// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// Content hash of images and decisions: SHA-256 (FIPS 180-4) over what it is given, in order.
///
/// Numbers enter as eight little-endian bytes, so that a hash does not depend on the machine's byte
/// order; text and images enter with their size before them, so that ("ab", "c") and ("a", "bc")
/// differ.
class Hasher {
 public:
  Hasher();

  /// Exactly these bytes, without their number.
  void Update(std::span<const std::byte> bytes);
  void Update(std::string_view text);
  void Update(const char* text) { Update(std::string_view(text)); }
  /// Type, size and pixels; a view into a larger image hashes as its copy does.
  void Update(const cv::Mat& image);
  /// The bit pattern; every NaN is the same one.
  void Update(double value);
  void Update(std::uint64_t value);
  void Update(std::int64_t value) { Update(static_cast<std::uint64_t>(value)); }
  void Update(int value) { Update(static_cast<std::int64_t>(value)); }
  void Update(bool value) { Update(static_cast<std::uint64_t>(value)); }

  /// 64 hexadecimal digits of all that was given so far; more may follow.
  std::string Hex() const;

 private:
  void Compress(const std::uint8_t* block);

  std::array<std::uint32_t, 8> state_;
  std::array<std::uint8_t, 64> block_{};
  std::size_t filled_ = 0;         ///< bytes of block_ in use
  std::uint64_t total_bytes_ = 0;  ///< given so far
};

}  // namespace horopter::scenarios
