// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/config_error.h"
#include "hardware/types/pose.h"
#include "hardware/types/stage_times.h"
#include "sim/render/gl_context.h"
#include "sim/world/world.h"

namespace horopter::sim {

class SceneRenderer;  // MuJoCo's and OpenGL's objects

/// Who colours the pixels. Depth and ids are the same bits either way.
enum class Shading {
  kOnePass,  ///< ours, where it can draw the scene (all but reflections and fog), else MuJoCo's
  kMujoco,   ///< mjr_render as it is, for comparison
};

struct RendererOptions {
  std::string gl_backend = "osmesa";  ///< one of GlBackends()
  int width = 640;                    ///< widest image that will be asked for [px]
  int height = 480;                   ///< highest image that will be asked for [px]
  /// Nothing nearer is seen. A depth of 24 bits has steps of about 6e-8 z/near relative to z.
  double near_m = 0.03;
  double far_m = 200;  ///< nothing farther is seen
  bool shadows = true;
  /// Each colour is the mean of 2 x 2 samples, so that edges are smooth. Depth and ids stay those of
  /// the pixel's centre. Costs two to three times as much.
  bool supersample = false;
  Shading shading = Shading::kOnePass;

  std::vector<hardware::FieldError> Validate() const;
};

/// Which images to make; each costs time.
struct Products {
  bool rgb = true;
  bool depth = false;
  bool ids = false;
};

/// What one ideal pinhole camera sees. Maps that were not asked for are empty. Row 0 is the top.
struct RenderedView {
  cv::Mat3b bgr;    ///< 8 bit, blue green red
  cv::Mat1f depth;  ///< along the optical z axis at the pixel's centre [m]; +inf = nothing there
  cv::Mat1i ids;    ///< MuJoCo geom id at the pixel's centre; -1 = nothing there
};

/// A camera and the pose of its optical frame (x right, y down, z forward).
struct PosedCamera {
  hardware::Pose X_WC;
  hardware::CameraModel camera;
};

/// Renders one World off-screen. Any number of renderers may live in a process, each with a GL
/// context of its own; one renderer is used by one thread at a time.
///
/// Cameras see geoms of groups 0 to 2 and nothing else: geoms of higher groups are for collision
/// only, and sites, joints, contacts and skins are decoration. Transparent geoms are solid to depth
/// and ids. Same world state, same bits, whatever was rendered before.
class Renderer {
 public:
  /// Uploads the model's meshes and textures as they are now.
  /// @param world must outlive the renderer
  /// @throws hardware::ConfigError when the options do not hold, or ask for more than this GL has
  /// @throws RenderError when there is no context or GL lacks something
  explicit Renderer(World& world, const RendererOptions& options = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// @param X_WC pose of the optical frame
  /// @param camera square pixels, no distortion, any principal point, no larger than the options'
  ///        size; what a real lens does is resampled from such a view by the sensor model
  /// @param times books "shadow_maps", "render" and "read_back" when given; the drawing is then
  ///        waited for between them
  /// @throws hardware::ConfigError when the camera or pose is none that can be rendered
  RenderedView Render(const hardware::Pose& X_WC, const hardware::CameraModel& camera,
                      const Products& products = {}, hardware::StageTimes* times = nullptr);

  /// What several cameras see at one instant, as Render() of each would give it, in their order.
  /// @throws hardware::ConfigError naming the first camera that cannot be rendered
  std::vector<RenderedView> RenderAll(std::span<const PosedCamera> cameras,
                                      const Products& products = {},
                                      hardware::StageTimes* times = nullptr);

  /// Sends every texture of the model to GL again, after they were repainted.
  void UploadTextures();

  /// What the driver calls itself, for reports.
  std::string gl_renderer() const;
  const RendererOptions& options() const { return options_; }

 private:
  RendererOptions options_;
  std::unique_ptr<SceneRenderer> scene_;
};

}  // namespace horopter::sim
