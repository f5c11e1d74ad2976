// SPDX-License-Identifier: Apache-2.0
// Accuracy and time of disparity methods on real pairs with truth, as Markdown, and a plot:
//   horopter_accuracy_vision_disparity --methods v1:accurate,dis:medium --plot accuracy.svg
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "accuracy_ablation.h"
#include "accuracy_pictures.h"
#include "accuracy_plot.h"
#include "accuracy_runs.h"
#include "accuracy_scenes.h"

namespace horopter::vision::testing {
namespace {

constexpr std::size_t kTwoPixels = 2;  // of kBadLimitsPx

struct Options {
  std::vector<std::string> methods = {
      "v1:accurate", "v1:fast",       "v1:realtime",          "v1:checked",         "dis:medium",
      "dis:fast",    "dis:ultrafast", "dis:medium_unchecked", "farneback:standard", "sgbm:3way",
      "sgbm:sgbm",   "sgbm:hh4",      "bm:block_15"};
  std::vector<std::string> parts = {"scenes", "noise", "gain", "vertical", "range", "ablation"};
  std::vector<std::string> rendered;
  std::string scene;
  std::string plot;
  std::string pictures;
  std::string data;
  int repeat = 5;
};

void PrintScene(const AccuracyScene& scene, const std::vector<MethodResult>& results) {
  std::cout << fmt::format(
      "\n### {}, {}x{}\n\n| method | density | median px | bad-2 | bad-2, missing counted | ms |\n"
      "|---|---:|---:|---:|---:|---:|\n",
      scene.name, scene.pair.left.cols, scene.pair.left.rows);
  for (const MethodResult& r : results) {
    std::cout << fmt::format("| {} | {:.3f} | {:.3f} | {:.4f} | {:.3f} | {:.1f} |\n", r.name,
                             r.score.density, r.score.median_px, r.score.bad_estimated[kTwoPixels],
                             r.score.bad_known[kTwoPixels], r.median_ms);
  }
  std::cout << std::flush;
}

/// A column for each degraded pair, a row for each method: bad-2 over the estimates, and density.
struct Column {
  std::string name;
  PairWithTruth pair;
};

void PrintDegradations(const std::string& title, const std::vector<Column>& columns,
                       const std::vector<MethodChoice>& methods,
                       const std::optional<SearchRange>& range) {
  std::string header = "| method |", line = "|---|";
  std::vector<std::string> rows;
  for (const Column& column : columns) {
    header += " " + column.name + " |";
    line += "---:|";
    const auto results = RunMethods(methods, column.pair, range, 1);
    rows.resize(results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (rows[i].empty()) rows[i] = "| " + results[i].name + " |";
      rows[i] += fmt::format(" {:.3f} ({:.2f}) |", results[i].score.bad_estimated[kTwoPixels],
                             results[i].score.density);
    }
  }
  std::cout << "\n### " << title << ": bad-2 (density)\n\n" << header << "\n" << line << "\n";
  for (const std::string& row : rows) std::cout << row << "\n";
  std::cout << std::flush;
}

template <typename Values, typename Make>
std::vector<Column> Columns(const Values& values, Make make) {
  std::vector<Column> columns;
  for (const auto value : values) columns.push_back({fmt::format("{}", value), make(value)});
  return columns;
}

void PrintRobustness(const Options& options, const std::vector<MethodChoice>& methods,
                     const std::string& data) {
  const AccuracyScene scene = RealScenes(data, "Motorcycle rectified").front();
  const PairWithTruth& pair = scene.pair;
  const auto wanted = [&](const char* part) {
    return std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
  };
  const auto print = [&](const std::string& title, const std::vector<Column>& columns) {
    PrintDegradations(scene.name + ", " + title, columns, methods, scene.range);
  };
  if (wanted("noise")) {
    print("noise of both eyes, sigma in grey levels",
          Columns(std::vector{0, 2, 5, 10, 20}, [&](int sigma) { return WithNoise(pair, sigma); }));
  }
  if (wanted("gain")) {
    print("gain of the right eye over the left",
          Columns(std::vector{0.5, 0.7, 1.0, 1.4, 2.0},
                  [&](double gain) { return WithGain(pair, gain); }));
  }
  if (wanted("vertical")) {
    print("right eye moved down, in px", Columns(std::vector{0, 1, 2, 5, 10, 20}, [&](int dy) {
            return WithVerticalOffset(pair, dy);
          }));
  }
}

void PrintRange(const std::vector<MethodChoice>& methods, const std::string& data) {
  const AccuracyScene scene = RealScenes(data, "verged A").front();
  std::vector<Column> columns;
  for (const cv::Point shift : {cv::Point(0, 0),
                                {-50, 0},
                                {50, 0},
                                {-100, 0},
                                {100, 0},
                                {-200, 0},
                                {200, 0},
                                {0, -10},
                                {0, 10},
                                {0, -30},
                                {0, 30},
                                {-200, -30},
                                {200, 30}}) {
    columns.push_back(
        {fmt::format("({}, {})", shift.x, shift.y), Shifted(scene.pair, shift.x, shift.y)});
  }
  PrintDegradations(scene.name + ", right eye shifted by px", columns, methods, std::nullopt);
}

/// A row for each change, and for each verged pair its median, bad-2 and density.
void PrintAblation(const std::string& data) {
  std::cout
      << "\n### The preset accurate with one thing changed, Motorcycle verged A, B, C: median "
         "px, bad-2 (density), ms\n\n| change | A | B | C |\n|---|---:|---:|---:|\n";
  std::vector<PairWithTruth> pairs;
  for (const EyeTurn& turn : kTurns) pairs.push_back(VergedMotorcycle(data, turn));
  for (const Ablation& ablation : Ablations()) {
    std::cout << "| " << ablation.change << " |";
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const AblationResult r = RunAblation(ablation, pairs[i], kTurns[i]);
      std::cout << fmt::format(" {:.3f}, {:.3f} ({:.3f}), {:.0f} |", r.median_px, r.bad2, r.density,
                               r.ms);
    }
    std::cout << std::endl;
  }
}

void WritePictures(const std::string& file, const AccuracyScene& scene,
                   const std::vector<MethodResult>& results) {
  constexpr int kWidth = 640;
  std::vector<std::pair<std::string, DisparityField>> fields;
  for (const MethodResult& result : results) fields.emplace_back(result.name, result.field);
  if (!cv::imwrite(file, ComparePictures(scene.pair, fields, kWidth))) {
    throw std::runtime_error("cannot write " + file);
  }
}

int Run(const Options& options) {
  std::string data = options.data;
  if (data.empty()) {
    const auto folder = DataFolder();
    if (!folder) throw std::invalid_argument(kDataRemedy);
    data = *folder;
  }
  std::vector<MethodChoice> methods;
  for (const std::string& text : options.methods) methods.push_back(MethodChoice::Parse(text));
  const auto wanted = [&](const char* part) {
    return std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
  };
  if (wanted("scenes")) {
    std::vector<MethodResult> first;
    std::string first_name;
    for (const AccuracyScene& scene : RealScenes(data, options.scene)) {
      const auto results = RunMethods(methods, scene.pair, scene.range, options.repeat);
      PrintScene(scene, results);
      if (!first_name.empty()) continue;
      if (!options.pictures.empty()) WritePictures(options.pictures, scene, results);
      first = results;
      first_name = scene.name;
    }
    if (!options.plot.empty()) std::ofstream(options.plot) << AccuracyPlot(first_name, first);
  }
  for (const std::string& folder : options.rendered) {
    const AccuracyScene scene = RenderedScene(folder);
    PrintScene(scene, RunMethods(methods, scene.pair, scene.range, options.repeat));
  }
  PrintRobustness(options, methods, data);
  if (wanted("range")) PrintRange(methods, data);
  if (wanted("ablation")) PrintAblation(data);
  return 0;
}

}  // namespace
}  // namespace horopter::vision::testing

int main(int argc, char** argv) {
  horopter::vision::testing::Options options;
  CLI::App app{"Accuracy and time of disparity methods on real pairs with truth"};
  app.add_option("--methods", options.methods, "METHOD:PRESET,...")->delimiter(',');
  app.add_option("--parts", options.parts, "scenes, noise, gain, vertical, range, ablation")
      ->delimiter(',')
      ->check(CLI::IsMember({"scenes", "noise", "gain", "vertical", "range", "ablation"}));
  app.add_option("--rendered", options.rendered,
                 "Folders of data sets of `horopter render --truth`, whose first frame is a scene");
  app.add_option("--scene", options.scene, "Only scenes whose name contains this");
  app.add_option("--repeat", options.repeat, "Timed passes")->check(CLI::Range(1, 1000));
  app.add_option("--plot", options.plot, "SVG of the first scene");
  app.add_option("--pictures", options.pictures,
                 "PNG of the first scene's fields beside the truth");
  app.add_option("--data", options.data, "Folder of motorcycle/, teddy/, reindeer/");
  CLI11_PARSE(app, argc, argv);
  try {
    return horopter::vision::testing::Run(options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
