// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace horopter::scenarios {

/// Style sheet of every report: light and dark, narrow screens, print; no external resource. Its
/// colour variables (--ink, --soft, --line, --pass, --fail, --warn, ...) are what inline SVG uses.
std::string_view ReportStyle();

/// Turns the list of frames into a slider. Without it the page shows all frames, one below the
/// other, and lacks nothing.
std::string_view FrameSliderScript();

}  // namespace horopter::scenarios
