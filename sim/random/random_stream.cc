// SPDX-License-Identifier: Apache-2.0
#include "sim/random/random_stream.h"

#include <cmath>

namespace horopter::sim {
namespace {

constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15ULL;

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) : state_(MixBits(seed)) {
  for (const char c : name) {
    state_ = MixBits(state_ ^ static_cast<unsigned char>(c)) + kGoldenGamma;
  }
}

std::uint64_t RandomStream::Next() {
  state_ += kGoldenGamma;
  return MixBits(state_);
}

double RandomStream::Uniform(double low, double high) {
  constexpr double kUnit = 1.0 / (1ULL << 53);
  return low + (high - low) * static_cast<double>(Next() >> 11) * kUnit;
}

double RandomStream::Gaussian() {
  // Box-Muller; 1 - u keeps the logarithm finite.
  const double radius = std::sqrt(-2 * std::log(1 - Uniform(0, 1)));
  return radius * std::cos(2 * M_PI * Uniform(0, 1));
}

}  // namespace horopter::sim
