// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/field_visitor.h"

#include <fmt/format.h>

#include <cmath>

namespace horopter::scenarios {

bool Range::Contains(double value) const {
  return std::isfinite(value) && value <= max && (above_min ? value > min : value >= min);
}

std::string Range::ToString() const {
  const bool low = std::isfinite(min);
  const bool high = std::isfinite(max);
  if (low && above_min) {
    return fmt::format("greater than {}", min) + (high ? fmt::format(" and at most {}", max) : "");
  }
  if (low && high) return fmt::format("from {} to {}", min, max);
  if (low) return fmt::format("at least {}", min);
  return high ? fmt::format("at most {}", max) : "";
}

}  // namespace horopter::scenarios
