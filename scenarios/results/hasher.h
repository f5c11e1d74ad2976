// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

namespace horopter::scenarios {

/// Content hash of images and decisions: SHA-256 (FIPS 180-4, by OpenSSL) over what it is given, in
/// order.
///
/// Numbers enter as eight little-endian bytes, so that a hash does not depend on the machine's byte
/// order; text and images enter with their size before them, so that ("ab", "c") and ("a", "bc")
/// differ.
class Hasher {
 public:
  /// @throws std::runtime_error when OpenSSL has no SHA-256 to give
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
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  using Context = std::unique_ptr<evp_md_ctx_st, Free>;

  static Context MakeContext();

  Context context_;
};

}  // namespace horopter::scenarios
