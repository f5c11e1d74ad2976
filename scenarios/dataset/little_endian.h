// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// Four bytes, lowest first, whatever the machine's own order is.
inline void Append32(std::uint32_t value, std::string* bytes) {
  for (int shift = 0; shift < 32; shift += 8) *bytes += static_cast<char>(value >> shift & 0xff);
}
inline void AppendFloat(float value, std::string* bytes) {
  Append32(std::bit_cast<std::uint32_t>(value), bytes);
}

/// @pre offset + 4 <= bytes.size()
inline std::uint32_t Read32(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) {
    value = value << 8 | static_cast<std::uint8_t>(bytes[offset + static_cast<std::size_t>(i)]);
  }
  return value;
}
inline float ReadFloat(std::string_view bytes, std::size_t offset) {
  return std::bit_cast<float>(Read32(bytes, offset));
}

}  // namespace horopter::scenarios
