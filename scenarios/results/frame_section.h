// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/embedded_pictures.h"

namespace horopter::scenarios {

/// The frames of a report: for each, what the robot saw above how wrong its depth was, with
/// legends. Element ids are frame-INDEX.
std::string FrameSection(const std::vector<EmbeddedFrame>& frames);

}  // namespace horopter::scenarios
