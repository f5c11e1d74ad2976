// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::sim {

/// A scene that cannot be loaded or that lacks what is asked of it; `what()` names the file and
/// MuJoCo's own reason.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// MuJoCo stopped: a NaN state, a full buffer. The run cannot go on.
class PhysicsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Two geoms that touch in the current state.
struct Contact {
  std::string geom1;
  std::string geom2;
  std::string body1;
  std::string body2;
  double distance_m = 0;  ///< negative: penetration
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();       ///< midway between the surfaces
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< from geom1 to geom2, unit length
};

/// One MuJoCo model and its state: the physics of a scene.
///
/// Owns mjModel and mjData. Frames: W is MuJoCo's world frame, body axes x forward, y left, z up.
/// MuJoCo's errors and warnings arrive as exceptions and log lines, never as a prompt or a file.
/// The model's time step is rounded to whole nanoseconds, which physics then uses too.
class World {
 public:
  /// @throws SceneError when the file is missing or does not compile.
  explicit World(const std::filesystem::path& mjcf);
  /// A world from MJCF text that needs no other file. @throws SceneError
  static std::unique_ptr<World> FromXml(std::string_view mjcf_text);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const mjModel& model() const { return *model_; }
  const mjData& data() const { return *data_; }
  /// For set-up (placing bodies, painting textures) and for actuators. Controls and applied forces
  /// count in the next Step(); changed positions and velocities only after Forward().
  mjModel& mutable_model() { return *model_; }
  mjData& mutable_data() { return *data_; }

  const std::filesystem::path& path() const { return path_; }

  /// Integer multiple of the time step, so that it never drifts.
  hardware::Time now() const { return hardware::Time(step_count_ * step_); }
  hardware::Duration step() const { return step_; }

  /// One physics step, then all that derives from the new positions and velocities, so that body,
  /// camera and geom poses, velocities and contacts belong to now(). Accelerations and forces (and
  /// the sensors that read them) are those that led here.
  /// @throws PhysicsError when the state became NaN or huge, or a buffer is full. The state is then
  ///         meaningless, and every further step throws too until Reset().
  void Step();

  /// Recomputes all that derives from positions and velocities, without advancing time. Changes
  /// nothing else but that MuJoCo normalises the quaternions again, which may move their last bit.
  /// @throws PhysicsError
  void Forward();

  /// Back to the model's initial state at time zero. Bodies stay where PlaceBody() put them.
  /// @throws PhysicsError
  void Reset();

  /// Pose of a named body / camera frame. The camera's axes are optical (x right, y down,
  /// z forward), not MuJoCo's. @throws SceneError naming the nearest name that exists.
  hardware::Pose X_WBody(std::string_view body) const;
  hardware::Pose X_WCamera(std::string_view camera) const;

  /// Id of a named object, type as MuJoCo's mjtObj. @throws SceneError
  int Id(mjtObj type, std::string_view name) const;
  /// Name of an object, or its type and id ("geom 12") when it has none.
  std::string Name(mjtObj type, int id) const;

  /// Places a body that no joint moves (static or mocap) and runs Forward().
  /// @throws SceneError when it, or a body it rides on, has joints.
  void PlaceBody(std::string_view body, const hardware::Pose& X_WBody);

  /// Pairs that touch or penetrate, one entry per contact point, in MuJoCo's order.
  std::vector<Contact> Contacts() const;

 private:
  struct ModelDeleter {
    void operator()(mjModel* m) const;
  };
  struct DataDeleter {
    void operator()(mjData* d) const;
  };
  using ModelPtr = std::unique_ptr<mjModel, ModelDeleter>;
  using DataPtr = std::unique_ptr<mjData, DataDeleter>;

  World(ModelPtr model, std::filesystem::path path);
  static ModelPtr Load(const std::filesystem::path& mjcf);
  /// Throws when MuJoCo has recorded a warning after which the state cannot be trusted.
  void ThrowIfBroken() const;

  std::filesystem::path path_;  ///< empty when the world was made from text
  ModelPtr model_;
  DataPtr data_;
  hardware::Duration step_{};
  std::int64_t step_count_ = 0;
};

}  // namespace horopter::sim
