// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/frame_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/results/colourise.h"
#include "scenarios/results/html.h"
#include "scenarios/results/report_style.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

std::string Gradient(ColourMap map) {
  std::string css = "linear-gradient(to right";
  constexpr int kStops = 16;
  for (int i = 0; i <= kStops; ++i) {
    const cv::Vec3b bgr = MapColour(map, static_cast<double>(i) / kStops);
    css += fmt::format(",#{:02x}{:02x}{:02x}", bgr[2], bgr[1], bgr[0]);
  }
  return css + ")";
}

std::string Legend(ColourMap map, const std::string& low, const std::string& middle,
                   const std::string& high) {
  return fmt::format(
      "<div class=\"legend\" aria-hidden=\"true\"><i style=\"background:{}\"></i>"
      "<i class=\"none\"></i><div><span>{}</span><span>{}</span><span>{}</span></div>"
      "<span>none</span></div>",
      Gradient(map), low, middle, high);
}

std::string DepthLegend(const ColourScales& scales) {
  return Legend(ColourMap::kDepth, Quantity(scales.near_m, "m"),
                fmt::format("{:.2g} m", std::sqrt(scales.near_m * scales.far_m)),
                Quantity(scales.far_m, "m"));
}

std::string SignedLegend(ColourMap map, double limit, const char* unit, const char* low,
                         const char* high) {
  return Legend(map, fmt::format("\u2212{} {}", Quantity(limit, unit), low), "0",
                fmt::format("+{} {}", Quantity(limit, unit), high));
}

struct Caption {
  const char* title;
  std::string legend;
};

Caption CaptionOf(PictureKind kind, const ColourScales& scales) {
  switch (kind) {
    case PictureKind::kLeft:
      return {"Left eye", ""};
    case PictureKind::kRight:
      return {"Right eye", ""};
    case PictureKind::kRegions:
      return {"Regions and their mean depth", DepthLegend(scales)};
    case PictureKind::kDisparity:
      return {"Horizontal disparity (white: the horopter)",
              SignedLegend(ColourMap::kDisparity, scales.disparity_px, "px", "nearer", "farther")};
    case PictureKind::kDepth:
      return {"Estimated depth", DepthLegend(scales)};
    case PictureKind::kTrueDepth:
      return {"True depth", DepthLegend(scales)};
    case PictureKind::kDepthError:
      return {"Relative depth error",
              SignedLegend(ColourMap::kSignedError, 100 * scales.relative_error, "%", "too near",
                           "too far")};
  }
  return {"", ""};
}

std::string Figure(const EmbeddedFrame& frame, const EmbeddedFrame::Picture& picture) {
  const Caption caption = CaptionOf(picture.kind, frame.scales);
  return fmt::format(
      "<figure><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}, frame {}\">"
      "<figcaption>{}{}</figcaption></figure>\n",
      picture.data_uri, picture.width, picture.height, caption.title, frame.record.index,
      caption.title, caption.legend);
}

bool ShowsDepth(PictureKind kind) {
  return kind == PictureKind::kDepth || kind == PictureKind::kTrueDepth ||
         kind == PictureKind::kDepthError;
}

std::string Figures(const EmbeddedFrame& frame, bool depth) {
  std::string figures;
  for (const EmbeddedFrame::Picture& picture : frame.pictures) {
    if (ShowsDepth(picture.kind) == depth) figures += Figure(frame, picture);
  }
  return figures;
}

std::string Row(const char* title, const std::string& figures) {
  if (figures.empty()) return "";
  return fmt::format("<h3>{}</h3><div class=\"pictures\">\n{}</div>\n", title, figures);
}

/// The row's fourth cell: what the error picture beside it comes to.
std::string DepthVerdict(const FrameRecord& record) {
  if (!record.depth) return "<p class=\"verdict\">No truth to judge its depth by.</p>\n";
  const DepthScore& depth = *record.depth;
  std::string html = "<dl class=\"verdict\">";
  const auto add = [&html](const std::string& value, const std::string& what) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", what, value);
  };
  add(fmt::format("{:.0f} %", 100 * depth.density), "of the pixels have a depth");
  if (depth.abs_rel_median) {
    add(ShortNumber(100 * *depth.abs_rel_median) + " %", "median error of their depth");
  }
  if (depth.bias_m) {
    add(fmt::format("{:.3f} m", std::abs(*depth.bias_m)),
        fmt::format("too {} on average", *depth.bias_m < 0 ? "near" : "far"));
  }
  return html + "</dl>\n";
}

std::string Facts(const FrameRecord& record) {
  std::string facts = "<ul class=\"facts\">";
  const auto add = [&](const char* name, const std::string& value) {
    facts += fmt::format("<li><span>{}</span> <b>{}</b></li>", name, value);
  };
  if (record.clearance_m) add("clearance", Quantity(record.clearance_m, "m"));
  if (record.fixation_error_deg) add("fixation error", Quantity(record.fixation_error_deg, "deg"));
  add("regions", std::to_string(record.regions));
  const auto degrees = [](double rad) { return fmt::format("{:.1f}", rad * 180 / M_PI); };
  const auto eye = [&](const hardware::PanTilt& angles) {
    return fmt::format("{}, {} deg", degrees(angles.pan_rad), degrees(angles.tilt_rad));
  };
  add("left eye pan, tilt", eye(record.angles.left));
  add("right eye", eye(record.angles.right));
  if (record.angles.neck.pan_rad != 0 || record.angles.neck.tilt_rad != 0) {
    add("neck", eye(record.angles.neck));
  }
  return facts + "</ul>\n";
}

std::string Article(const EmbeddedFrame& frame) {
  const FrameRecord& record = frame.record;
  std::string html = fmt::format(
      "<article class=\"frame\" id=\"frame-{0}\">\n<p class=\"frame-title\">{1:.2f} s "
      "<span>frame {0}{2}{3}</span></p>\n",
      record.index, hardware::ToSeconds(record.t_capture),
      record.step.empty() ? "" : " \u00b7 " + EscapeHtml(record.step),
      record.decision.empty() ? "" : " \u00b7 " + EscapeHtml(record.decision));
  html += Facts(record);
  html += Row("What it saw", Figures(frame, false));
  const std::string depth = Figures(frame, true);
  html += Row("How wrong its depth was", depth.empty() ? "" : depth + DepthVerdict(record));
  return html + "</article>\n";
}

}  // namespace

std::string FrameSection(const std::vector<EmbeddedFrame>& frames) {
  std::string html =
      "<section class=\"card\">\n<h2>What it saw, and how wrong its depth was</h2>\n";
  if (frames.empty()) {
    return html + "<p class=\"empty\">No frame with pictures was kept in this run.</p></section>\n";
  }
  for (const EmbeddedFrame& frame : frames) html += Article(frame);
  return html + fmt::format("<script>{}</script>\n</section>\n", FrameSliderScript());
}

}  // namespace horopter::scenarios
