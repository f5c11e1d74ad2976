// SPDX-License-Identifier: Apache-2.0
#include "accuracy_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace horopter::vision::testing {
namespace {

constexpr double kWidth = 760, kHeight = 480, kLeft = 70, kRight = 130, kTop = 40, kBottom = 50;

/// A logarithmic axis over whole decades' parts, from its first pixel to its last.
class LogAxis {
 public:
  LogAxis(double low, double high, double first_px, double last_px)
      : low_(std::log10(low) - 0.1),
        high_(std::log10(high) + 0.1),
        first_(first_px),
        last_(last_px) {}

  double At(double value) const {
    return first_ + (std::log10(value) - low_) / (high_ - low_) * (last_ - first_);
  }
  /// 1, 2 and 5 times powers of ten.
  std::vector<double> Ticks() const {
    std::vector<double> ticks;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
      for (const double part : {1.0, 2.0, 5.0}) {
        const double tick = part * std::pow(10, decade);
        if (std::log10(tick) >= low_ && std::log10(tick) <= high_) ticks.push_back(tick);
      }
    }
    return ticks;
  }

 private:
  double low_, high_, first_, last_;
};

double Bad2(const MethodResult& result) {
  constexpr std::size_t kTwoPixels = 2;
  constexpr double kLeast = 1e-3;  // a logarithm has no zero
  return std::max(result.score.bad_estimated[kTwoPixels], kLeast);
}

/// Ours stand out; peers get a colour for each method.
std::string ColourOf(const std::string& name) {
  static const std::map<std::string, std::string> colours = {{"v1", "#c8321e"},
                                                             {"dis", "#2a6fbb"},
                                                             {"farneback", "#7a7a7a"},
                                                             {"sgbm", "#2e8b57"},
                                                             {"bm", "#9467bd"}};
  const auto found = colours.find(name.substr(0, name.find(':')));
  return found == colours.end() ? "#000000" : found->second;
}

std::string Grid(const LogAxis& ms, const LogAxis& bad) {
  const double right = kWidth - kRight, bottom = kHeight - kBottom;
  std::string svg;
  for (const double tick : ms.Ticks()) {
    svg += fmt::format(
        "<path d='M{0:.1f} {1}V{2}' stroke='#e0e0e0'/><text x='{0:.1f}' y='{3}' "
        "text-anchor='middle'>{4:g}</text>\n",
        ms.At(tick), kTop, bottom, bottom + 18, tick);
  }
  for (const double tick : bad.Ticks()) {
    svg += fmt::format(
        "<path d='M{0} {1:.1f}H{2}' stroke='#e0e0e0'/><text x='{3}' y='{4:.1f}' "
        "text-anchor='end'>{5:g}</text>\n",
        kLeft, bad.At(tick), right, kLeft - 8, bad.At(tick) + 4, tick);
  }
  return svg;
}

/// Finds room for labels, each beside its dot, or above or below where another one is.
class Labels {
 public:
  /// @return the base line of a label that begins at x, as near to y as there is room
  double Place(double x, double y, const std::string& text) {
    constexpr double kLine = 14, kCharacter = 6.6;
    const double end = x + kCharacter * static_cast<double>(text.size());
    for (const double move : {0.0, -kLine, kLine, -2 * kLine, 2 * kLine}) {
      const bool taken = std::any_of(placed_.begin(), placed_.end(), [&](const Box& box) {
        return x < box.end && end > box.begin && std::abs(box.y - (y + move)) < kLine;
      });
      if (taken) continue;
      placed_.push_back({x, end, y + move});
      return y + move;
    }
    return y;
  }

 private:
  struct Box {
    double begin, end, y;
  };
  std::vector<Box> placed_;
};

}  // namespace

std::string AccuracyPlot(const std::string& title, const std::vector<MethodResult>& results) {
  std::vector<MethodResult> shown;
  for (const MethodResult& r : results) {
    if (r.score.estimated > 0) shown.push_back(r);
  }
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
      "font-family='sans-serif' font-size='12'>\n<rect width='100%' height='100%' fill='white'/>\n"
      "<text x='{2}' y='22' font-size='15'>{3}</text>\n",
      kWidth, kHeight, kLeft, title);
  if (!shown.empty()) {
    const auto [fast, slow] =
        std::minmax_element(shown.begin(), shown.end(),
                            [](const auto& a, const auto& b) { return a.median_ms < b.median_ms; });
    const auto [good, poor] = std::minmax_element(
        shown.begin(), shown.end(), [](const auto& a, const auto& b) { return Bad2(a) < Bad2(b); });
    const LogAxis ms(fast->median_ms, slow->median_ms, kLeft, kWidth - kRight);
    const LogAxis bad(Bad2(*good), Bad2(*poor), kHeight - kBottom, kTop);
    svg += Grid(ms, bad);
    Labels labels;
    for (const MethodResult& r : shown) {
      const double x = ms.At(r.median_ms), y = bad.At(Bad2(r));
      const double radius = 9 * std::sqrt(r.score.density);
      svg += fmt::format(
          "<circle cx='{0:.1f}' cy='{1:.1f}' r='{2:.1f}' fill='{3}' fill-opacity='.75'/>"
          "<text x='{4:.1f}' y='{5:.1f}' fill='{3}'>{6}</text>\n",
          x, y, radius, ColourOf(r.name), x + radius + 3,
          labels.Place(x + radius + 3, y + 4, r.name), r.name);
    }
  }
  return svg + fmt::format(
                   "<text x='{}' y='{}' text-anchor='middle'>median time [ms]</text>\n"
                   "<text transform='translate(16 {}) rotate(-90)' text-anchor='middle'>share of "
                   "estimates off by more than 2 px</text>\n<text x='{}' y='22' text-anchor='end' "
                   "fill='#606060'>area: density; better is lower left</text>\n</svg>\n",
                   (kLeft + kWidth - kRight) / 2, kHeight - 12, (kTop + kHeight - kBottom) / 2,
                   kWidth - 20);
}

}  // namespace horopter::vision::testing
