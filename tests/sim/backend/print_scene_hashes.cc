// SPDX-License-Identifier: Apache-2.0
// Prints a hash of each picture and truth of the shipped scenes at fixed gazes, one a line, for
// tests that compare processes:
//   print_scene_hashes [reverse] [threads=N]
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "sim/camera/eye_camera.h"
#include "sim/head/pose_head.h"
#include "sim/render/renderer.h"
#include "sim/textures/paint_textures.h"
#include "sim/truth/correspondence.h"
#include "sim/truth/ground_truth.h"
#include "sim/truth/scene_snapshot.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using hardware::HeadAngles;
using hardware::Pose;

struct Place {
  const char* scene;
  const char* left;
  const char* right;
};

constexpr Place kPlaces[] = {{"koala/room.xml", "left", "right"},
                             {"nao/workspace.xml", "left_eye", "right_eye"},
                             {"yorick/tabletop.xml", "left_peripheral", "right_peripheral"}};

/// Of the two poses whose views and flow are taken.
HeadAngles Gaze(int i) {
  HeadAngles gaze;
  gaze.neck = {0.1 * i, 0.2 + 0.05 * i};
  gaze.left = {-0.05, 0.1 * i};
  gaze.right = {0.05 + 0.02 * i, 0.1 * i};
  return gaze;
}

std::uint64_t Hash(const cv::Mat& image) {
  constexpr std::uint64_t kPrime = 1099511628211ull;
  std::uint64_t hash = 14695981039346656037ull;
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<std::uint8_t>(y);
    for (std::size_t i = 0; i < image.cols * image.elemSize(); ++i) hash = (hash ^ row[i]) * kPrime;
  }
  return hash;
}

/// Lines by what they are of, so that the order of making them does not show.
using Lines = std::map<std::string, std::uint64_t>;

void AddField(const std::string& name, const CorrespondenceField& field, Lines& lines) {
  lines[name + " dx"] = Hash(field.dx);
  lines[name + " dy"] = Hash(field.dy);
  lines[name + " visibility"] = Hash(field.visibility);
}

/// What a webcam makes of a view as its eye turns about an axis beside it.
cv::Mat3b Developed(Renderer& renderer, const Pose& X_WM, EyeCamera& eye) {
  EyeMotion motion;
  for (double t_s = -0.026; t_s < 0.028; t_s += 0.002) {
    const Eigen::AngleAxisd turn(2 * t_s, Eigen::Vector3d(0.2, 1, 0).normalized());
    motion.Add(t_s, turn.toRotationMatrix(),
               turn * Eigen::Vector3d(0, 0, 0.08) - Eigen::Vector3d(0, 0, 0.08));
  }
  const std::vector<ViewPlan> plans = eye.Views(motion);
  std::vector<LensView> views;
  for (const ViewPlan& plan : plans) {
    const RenderedView seen =
        renderer.Render(X_WM * motion.PoseAt(plan.t_s), plan.camera, {.depth = plan.needs_depth});
    views.push_back({seen.bgr, seen.depth});
  }
  return eye.Develop(plans, views, motion, 7);
}

class Studio {
 public:
  explicit Studio(const Place& place)
      : place_(place), world_(std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes" / place.scene) {
    // Painting all would take longer than everything else.
    PaintTextures(world_.mutable_model(), 1, [](int texture) { return texture % 6 == 1; });
    shapes_ = std::make_shared<SceneShapes>(world_.model());
    profile_ = CameraProfile::Named("webcam_vga");
    eye_ = std::make_unique<EyeCamera>(profile_.lens.Model(96, 72, 1.0), profile_, 1, "left");
    const cv::Size largest = eye_->largest_view();
    for (const bool supersample : {false, true}) {
      renderers_.push_back(
          std::make_unique<Renderer>(world_, RendererOptions{.width = std::max(96, largest.width),
                                                             .height = std::max(72, largest.height),
                                                             .supersample = supersample}));
    }
  }

  void Photograph(int gaze, Lines& lines) {
    PoseHead(world_, Gaze(gaze));
    const std::string name = std::string(place_.scene) + " gaze " + std::to_string(gaze) + " ";
    const Pose X_WCl = world_.X_WCamera(place_.left), X_WCr = world_.X_WCamera(place_.right);
    const auto pinhole = hardware::CameraModel::FromHorizontalFov(96, 72, 1.0);
    for (const auto& renderer : renderers_) {
      const RenderedView seen =
          renderer->Render(X_WCl, pinhole, {.rgb = true, .depth = true, .ids = true});
      const std::string kind = name + (renderer->options().supersample ? "super " : "plain ");
      lines[kind + "rgb"] = Hash(seen.bgr);
      lines[kind + "depth"] = Hash(seen.depth);
      lines[kind + "ids"] = Hash(seen.ids);
    }
    lines[name + "developed"] = Hash(Developed(*renderers_[0], X_WCl, *eye_));

    const SceneSnapshot now(shapes_, world_.data());
    const EyeView right{X_WCr, eye_->model()};
    const EyeTruth left = CaptureEyeTruth(now, {X_WCl, eye_->model()});
    lines[name + "true depth"] = Hash(left.depth);
    lines[name + "true ids"] = Hash(left.ids);
    lines[name + "true normals"] = Hash(left.normals);
    AddField(name + "disparity", TrueDisparity(now, left, right), lines);
    PoseHead(world_, Gaze(gaze + 1));
    const SceneSnapshot later(shapes_, world_.data());
    AddField(name + "flow",
             TrueFlow(now, left, later, {world_.X_WCamera(place_.left), eye_->model()}), lines);
  }

 private:
  Place place_;
  World world_;
  std::shared_ptr<const SceneShapes> shapes_;
  CameraProfile profile_;
  std::unique_ptr<EyeCamera> eye_;
  std::vector<std::unique_ptr<Renderer>> renderers_;
};

void Print(bool reversed) {
  Lines lines;
  std::vector<Place> places(std::begin(kPlaces), std::end(kPlaces));
  std::vector<int> gazes{0, 1};
  if (reversed) {
    std::reverse(places.begin(), places.end());
    std::reverse(gazes.begin(), gazes.end());
  }
  for (const Place& place : places) {
    Studio studio(place);
    for (const int gaze : gazes) studio.Photograph(gaze, lines);
  }
  for (const auto& [name, hash] : lines) std::printf("%s %016lx\n", name.c_str(), hash);
}

}  // namespace
}  // namespace horopter::sim

int main(int argc, char** argv) {
  bool reversed = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    reversed = reversed || argument == "reverse";
    if (argument.rfind("threads=", 0) == 0) cv::setNumThreads(std::atoi(argument.c_str() + 8));
  }
  try {
    horopter::sim::Print(reversed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
