// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/disparity_output.h"
#include "scenarios/cli/peak_memory.h"
#include "scenarios/cli/quiet_opencv.h"
#include "scenarios/dataset/stereo_images.h"
#include "scenarios/results/statistics.h"
#include "scenarios/runner/exit_code.h"
#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/disparity_factory.h"
#include "vision/disparity/fill_in.h"

namespace horopter::scenarios {
namespace {

constexpr const char* kWholePass = "total";

struct DisparityArguments {
  std::string left;
  std::string right;
  std::string method = "v1";
  std::string preset;
  std::string range;
  DisparityOutput output;
  bool fill_in = false;
  bool json = false;
  int repeat = 1;
};

/// "-16:64" @throws std::invalid_argument
std::optional<vision::SearchRange> ParseRange(const std::string& text) {
  if (text.empty()) return std::nullopt;
  int min_px = 0, end_px = 0, used = 0;
  const bool whole = std::sscanf(text.c_str(), "%d:%d%n", &min_px, &end_px, &used) == 2 &&
                     static_cast<std::size_t>(used) == text.size();
  if (!whole || min_px >= end_px) {
    throw std::invalid_argument(
        fmt::format("--range {}: must be MIN:MAX in px, MIN below MAX, as in -16:64", text));
  }
  return vision::SearchRange::Covering(min_px, end_px);
}

double Share(const cv::Mat1b& marked) {
  if (marked.empty()) return 0;
  return static_cast<double>(cv::countNonZero(marked)) / static_cast<double>(marked.total());
}

/// What was done, as `--json` prints it and the text is made of.
/// @param memory_before_mb what the program and its libraries hold without any images
nlohmann::ordered_json Report(const DisparityArguments& a, const vision::DisparityField& field,
                              const hardware::StageTimes& times,
                              std::optional<double> memory_before_mb) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object(), whole_ms;
  for (const auto& [stage, timing] : Summarise(times)) {
    (stage == kWholePass ? whole_ms : stages[stage]) = *timing.median_ms;
  }
  nlohmann::ordered_json report = {{"method", a.method},
                                   {"preset", a.preset},
                                   {"width", field.valid.cols},
                                   {"height", field.valid.rows},
                                   {"density", Share(field.valid)},
                                   {"filled", Share(field.filled)},
                                   {"repeat", a.repeat},
                                   {"threads", cv::getNumThreads()},
                                   {"instruction_set", vision::SelectKernels().name},
                                   {"stages_ms", stages},
                                   {"total_ms", whole_ms},
                                   {"peak_memory_mb", nullptr},
                                   {"peak_memory_before_mb", nullptr}};
  if (const auto peak_mb = PeakMemoryMb()) report["peak_memory_mb"] = *peak_mb;
  if (memory_before_mb) report["peak_memory_before_mb"] = *memory_before_mb;
  return report;
}

std::string Text(const nlohmann::ordered_json& report) {
  const double filled = report["filled"];
  std::string text =
      fmt::format("{} {}: {} x {} px, density {:.3f}{}\n", report["method"].get<std::string>(),
                  report["preset"].get<std::string>(), report["width"].get<int>(),
                  report["height"].get<int>(), report["density"].get<double>(),
                  filled > 0 ? fmt::format(" ({:.3f} filled in)", filled) : "");
  const auto line = [&text](const std::string& name, double ms) {
    text += fmt::format("  {:<16}{:10.2f} ms\n", name, ms);
  };
  for (const auto& [stage, ms] : report["stages_ms"].items()) line(stage, ms);
  line(kWholePass, report["total_ms"]);
  const auto &peak = report["peak_memory_mb"], &before = report["peak_memory_before_mb"];
  if (!peak.is_null() && !before.is_null()) {
    text += fmt::format("  {:<16}{:10.1f} MB, {:.1f} MB of it before images were read\n",
                        "peak memory", peak.get<double>(), before.get<double>());
  }
  return text;
}

StereoImages Read(const DisparityArguments& a) {
  const QuietOpenCv quiet;
  return ReadStereoImages(a.left, a.right);
}

int EstimateDisparity(DisparityArguments a) {
  const std::optional<double> memory_before_mb = PeakMemoryMb();
  const auto estimator = vision::CreateDisparityEstimator(a.method, a.preset, ParseRange(a.range));
  if (a.preset.empty()) a.preset = vision::FindDisparityMethod(a.method).presets.front();
  a.output.Validate();
  const StereoImages images = Read(a);

  hardware::StageTimes times;
  vision::DisparityField field;
  const auto pass = [&](hardware::StageTimes* pass_times) {
    field = estimator->Estimate(images.left, images.right, pass_times);
    if (!a.fill_in || !field.filled.empty()) return;
    hardware::MeasureIf(pass_times, "fill-in", [&] { vision::FillIn(images.left, {}, field); });
  };
  if (a.repeat > 1) pass(nullptr);  // buffers and caches are cold, which is not what is asked for
  for (int i = 0; i < a.repeat; ++i) times.Measure(kWholePass, [&] { pass(&times); });
  // Before anything is written: pictures take memory of their own.
  const nlohmann::ordered_json report = Report(a, field, times, memory_before_mb);
  std::vector<std::string> notes = images.notes;
  for (const std::string& note : a.output.Write(field)) notes.push_back(note);
  for (const std::string& note : notes) std::cerr << "horopter disparity: " << note << "\n";
  std::cout << (a.json ? report.dump(2) + "\n" : Text(report));
  return static_cast<int>(ExitCode::kPassed);
}

std::string Methods() {
  std::string text;
  for (const vision::DisparityMethod& method : vision::DisparityMethods()) {
    text += fmt::format("  {:<10} {}\n             {}\n", method.name, method.summary,
                        fmt::join(method.presets, ", "));
  }
  return text;
}

}  // namespace

Command AddDisparityCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("disparity", "Find the disparity of two image files");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<DisparityArguments>();
  app->add_option("LEFT", a->left, "Left image: grey or colour, 8 or 16 bits, or floats")
      ->required();
  app->add_option("RIGHT", a->right, "Right image, of the same size")->required();
  app->add_option("--method", a->method, "One of those below")->capture_default_str();
  app->add_option("--preset", a->preset, "Of the method; default: its first");
  app->add_option("--range", a->range,
                  "MIN:MAX of x_left - x_right [px] that sgbm and bm search; default 0:128");
  app->add_flag("--fill-in", a->fill_in,
                "Give invalid pixels the disparity around them; their confidence is 0");
  app->add_option("--out", a->output.field,
                  "Disparity as .flo (both components), .pfm (Middlebury) or .png (KITTI)");
  app->add_option("--confidence", a->output.confidence, "Confidence, 0 to 1, as .pfm or .png");
  app->add_option("--viz", a->output.picture, "Picture of both components with scales, as .png");
  app->add_flag("--json", a->json, "Print method, density, times and memory as JSON");
  app->add_option("--repeat", a->repeat,
                  "Estimate so many times, after one that does not count; times are medians")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app->footer("\nMethods, each with its presets:\n" + Methods() +
              "\nA .flo file holds x_right - x_left and y_right - y_left, a .pfm or .png file\n"
              "x_left - x_right. More than 8 bits are scaled by one factor for both eyes.\n"
              "\nExamples:\n"
              "  horopter disparity left.png right.png --out disparity.flo --viz disparity.png\n"
              "  horopter disparity left.png right.png --method dis --json --repeat 9\n"
              "  horopter disparity im0.png im1.png --method sgbm --range 0:64 --out disp0.pfm");
  return {app, [a] { return EstimateDisparity(*a); }};
}

}  // namespace horopter::scenarios
