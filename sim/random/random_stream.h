// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace horopter::sim {

/// Mixes 64 bits so that neighbouring inputs give unrelated outputs (the finaliser of SplitMix64,
/// Steele, Lea & Flood 2014).
constexpr std::uint64_t MixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1), one number for every index of a stream, in any order.
constexpr double UniformOf(std::uint64_t stream, std::uint64_t index) {
  return static_cast<double>(MixBits(stream ^ MixBits(index)) >> 11) * (1.0 / (1ULL << 53));
}

/// A stream of random numbers of its own for every thing that is random: the same (seed, name)
/// gives the same numbers whatever other streams exist, so that turning one effect on changes no
/// other. Results are the same on every platform (no std:: distributions).
class RandomStream {
 public:
  /// @param name what the stream is for, e.g. "camera.left.noise"
  RandomStream(std::uint64_t seed, std::string_view name);

  std::uint64_t Next();

  /// Uniform in [low, high).
  double Uniform(double low, double high);

  /// Zero mean, unit variance.
  double Gaussian();

 private:
  std::uint64_t state_;
};

}  // namespace horopter::sim
