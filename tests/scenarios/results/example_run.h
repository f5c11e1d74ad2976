// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <system_error>

#include "scenarios/results/frame_pictures.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// An empty folder of the test's own, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::path(::testing::TempDir()) / "results_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp " + pattern);
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string ContentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A run that failed one of its expectations, with text that has to be escaped everywhere.
inline RunSummary ExampleSummary() {
  RunSummary run;
  run.scenario = "first_waypoint";
  run.description = "Drives round a box that stands between the robot and its goal.";
  run.file = "scenarios/koala/first_waypoint.yaml";
  run.seed = 18446744073709551615u;
  run.backend = "sim";
  run.faults = {"swapped_pair: from_s 0, until_s 3600"};
  run.outcome = Outcome::kFailed;
  run.expectations = {
      {"reached within 0.15 m before 60 s", 0.1, 0.15, "m", ExpectationOutcome::kPassed, "reached",
       ""},
      {"clearance >= 0.05 m", 0.031415926535897934, 0.05, "m", ExpectationOutcome::kFailed,
       "clearance", "came within 0.031 m of <obstacle> \"red & tall\" at 7.4 s"},
      {"contacts 0", 0, 0, "", ExpectationOutcome::kPassed, "contacts", ""},
      {"fixation.error_deg.p95 <= 0.5", std::nullopt, 0.5, "deg",
       ExpectationOutcome::kNotApplicable, "fixation.error_deg.p95",
       "nothing was fixated in this run"},
      {"depth.abs_rel.median <= 0.03", 0.0213, 0.03, "", ExpectationOutcome::kPassed,
       "depth.abs_rel.median", ""}};
  run.metrics = {{"clearance", 0.031415926535897934}, {"contacts", 0}, {"path.length_m", 3.75}};
  run.image_hash = std::string(64, 'a');
  run.decision_hash = std::string(64, 'b');
  run.timing_ms = {{"disparity", {41.25, 55.5, 30}},  {"physics", {2.5, 3.1, 15000}},
                   {"render", {18.9, 22.4, 30}},      {"reconstruction", {6.1, 7.4, 30}},
                   {"segmentation", {9.8, 11.2, 30}}, {"navigation", {0.04, 0.09, 30}}};
  run.sim_s = 30.1;
  run.wall_s = 12.75;
  run.gl_renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  run.machine = {"Example & Sons 3000", 2, 0.75};
  run.versions = {{"horopter", "0.1.0 (abc1234-dirty)"},
                  {"program", "0123456789ab"},
                  {"mujoco", "2.2.2"},
                  {"opencv", "4.6.0"}};
  run.directory = "first_waypoint/seed_1";
  return run;
}

inline std::vector<std::pair<double, double>> Box(double x, double y, double half_x,
                                                  double half_y) {
  return {{x - half_x, y - half_y},
          {x + half_x, y - half_y},
          {x + half_x, y + half_y},
          {x - half_x, y + half_y}};
}

/// A room of 5.2 m x 3.6 m with a detour round the box in its middle.
inline PlanRecord ExamplePlan() {
  PlanRecord plan;
  plan.shapes = {{"wall_south", "wall", Box(2.0, -1.85, 2.65, 0.05)},
                 {"wall_north", "wall", Box(2.0, 1.85, 2.65, 0.05)},
                 {"wall_west", "wall", Box(-0.65, 0, 0.05, 1.9)},
                 {"wall_east", "wall", Box(4.65, 0, 0.05, 1.9)},
                 {"table", "furniture", Box(3.9, -1.3, 0.5, 0.35)},
                 {"shelf", "furniture", Box(1.0, 1.6, 0.8, 0.18)},
                 {"box", "obstacle", Box(1.8, 0.05, 0.15, 0.15)},
                 {"cylinder", "obstacle", {}},
                 {"board", "board", Box(4.5, 0.9, 0.02, 0.3)}};
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * M_PI * i / 24;
    plan.shapes[7].outline_m.emplace_back(2.9 + 0.16 * std::cos(angle),
                                          0.9 + 0.16 * std::sin(angle));
  }
  for (int i = 0; i <= 300; ++i) {
    const double t_s = 0.1 * i;
    const double x = 3.6 * i / 300;
    const double detour = -0.55 * std::exp(-std::pow((x - 1.8) / 0.6, 2));
    PathPoint point;
    point.t_s = t_s;
    point.true_pose = {{x, detour, 0.2}};
    point.odometry = {x * 1.01, detour + 0.02 * x, 0.21};
    plan.path.push_back(point);
  }
  plan.goals_m = {{3.6, 0}};
  plan.waypoints_m = {{1.3, -0.6}, {2.3, -0.5}};
  plan.robot_radius_m = 0.19;
  return plan;
}

inline FrameRecord ExampleFrame(int index) {
  FrameRecord frame;
  frame.index = index;
  frame.t_capture = hardware::Time(hardware::FromSeconds(index));
  frame.odometry = {0.12 * index * 1.01, 0.0, 0.21};
  frame.true_pose = ExamplePlan().path[std::min(300, 10 * index)].true_pose;
  frame.angles.left.pan_rad = -0.05;
  frame.angles.right.pan_rad = 0.05;
  frame.step = index < 22 ? "goto" : "fixate";
  frame.decision = index == 3 ? "obstacle at 1.1 m, waypoint \"right\", <freer>" : "to the goal";
  frame.depth = DepthScore{0.81, 0.02 + 0.01 * std::sin(index * 0.7), 0.05, -0.012};
  if (index >= 22) frame.fixation_error_deg = 0.4 / (index - 20);
  frame.clearance_m = 0.03 + 0.02 * std::abs(index - 15);
  frame.disparity_density = 0.87;
  frame.regions = 14;
  return frame;
}

/// A floor that recedes, a back wall and a box, seen with noise: pictures of plausible content.
inline FrameImages ExampleImages(int index, cv::Size size = {320, 240}) {
  std::mt19937 random(index + 1);
  std::normal_distribution<float> noise(0, 1);
  const int horizon = size.height * 2 / 5;
  const cv::Rect box(size.width / 2 - 20 - 2 * index, horizon - 20, 40 + 3 * index, 60 + 2 * index);
  hardware::StereoFrame frame;
  frame.left.bgr = cv::Mat(size, CV_8UC3);
  cv::Mat1f truth(size);
  cv::Mat1f depth(size);
  vision::DisparityField field{cv::Mat1f(size), cv::Mat1f(size), cv::Mat1f(size), cv::Mat1b(size)};
  vision::RegionMap regions;
  regions.labels = cv::Mat1i(size, 0);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const bool in_box = box.contains({x, y});
      const float floor_m = y > horizon ? 0.35f * size.height / (y - horizon) : 4.f;
      truth(y, x) = in_box ? 2.4f - 0.06f * index : std::min(4.f, floor_m);
      const bool valid = (x / 7 + y / 9) % 11 != 0 && x > 12;
      depth(y, x) = valid ? truth(y, x) * (1 + 0.03f * truth(y, x) * noise(random))
                          : std::numeric_limits<float>::quiet_NaN();
      field.dx(y, x) = valid ? 26.f - 60.f / truth(y, x) + 0.3f * noise(random) : std::nanf("");
      field.dy(y, x) = 0;
      field.valid(y, x) = valid ? 255 : 0;
      const int shade = static_cast<int>(40 + 20 * ((x / 12 + y / 12) % 2) + 6 * noise(random));
      frame.left.bgr.at<cv::Vec3b>(y, x) =
          in_box ? cv::Vec3b(cv::saturate_cast<uchar>(shade), cv::saturate_cast<uchar>(shade), 190)
          : y > horizon ? cv::Vec3b(cv::saturate_cast<uchar>(90 + shade),
                                    cv::saturate_cast<uchar>(110 + shade),
                                    cv::saturate_cast<uchar>(120 + shade))
                        : cv::Vec3b(cv::saturate_cast<uchar>(150 + shade / 2),
                                    cv::saturate_cast<uchar>(140 + shade / 2),
                                    cv::saturate_cast<uchar>(130 + shade / 2));
      regions.labels(y, x) = in_box ? 1 : y > horizon + 1 ? 2 : y < horizon - 1 ? 3 : 0;
    }
  }
  cv::rectangle(regions.labels, box, 0, 2);
  frame.right.bgr = frame.left.bgr.clone();
  regions.regions = {{1,
                      box.area(),
                      box,
                      {box.x + box.width / 2., box.y + box.height / 2.},
                      {},
                      {900, 2.4 - 0.06 * index, 2.2, 0.1, 2.3}},
                     {2,
                      20000,
                      {0, horizon, size.width, size.height - horizon},
                      {size.width * 0.8, size.height * 0.8},
                      {},
                      {9000, 0.9, 0.6, 0.2, 0.62}},
                     {3,
                      20000,
                      {0, 0, size.width, horizon},
                      {size.width / 2., horizon / 2.},
                      {},
                      {0, 0, 0, 0, 0}}};
  return MakeFrameImages(frame, field, depth, truth, regions, {0.4, 4.5, 30, 0.25});
}

}  // namespace horopter::scenarios
