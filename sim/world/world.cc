// SPDX-License-Identifier: Apache-2.0
#include "sim/world/world.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "sim/world/nearest_name.h"

namespace horopter::sim {
namespace {

using hardware::Pose;

/// MuJoCo is C, but compiled with unwind tables: the exception passes through it.
[[noreturn]] void ThrowMujocoError(const char* message) {
  throw PhysicsError(fmt::format("MuJoCo: {}", message));
}

void LogMujocoWarning(const char* message) { spdlog::warn("MuJoCo: {}", message); }

/// MuJoCo has one pair of handlers per process.
void InstallMujocoHandlers() {
  [[maybe_unused]] static const bool installed = [] {
    mju_user_error = ThrowMujocoError;
    mju_user_warning = LogMujocoWarning;
    return true;
  }();
}

/// MuJoCo's reasons come in several lines; ours are one.
std::string OneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c != '\n') {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += "; ";
    }
  }
  line.erase(line.find_last_not_of("; ") + 1);
  return line;
}

std::string DescribePath(const std::filesystem::path& path) {
  return path.empty() ? "scene from text" : fmt::format("scene '{}'", path.string());
}

const char* TypeName(mjtObj type) {
  const char* name = mju_type2Str(type);
  return name == nullptr ? "object" : name;
}

int CountOf(const mjModel& m, mjtObj type) {
  switch (type) {
    case mjOBJ_BODY:
      return m.nbody;
    case mjOBJ_JOINT:
      return m.njnt;
    case mjOBJ_GEOM:
      return m.ngeom;
    case mjOBJ_SITE:
      return m.nsite;
    case mjOBJ_CAMERA:
      return m.ncam;
    case mjOBJ_LIGHT:
      return m.nlight;
    case mjOBJ_MESH:
      return m.nmesh;
    case mjOBJ_HFIELD:
      return m.nhfield;
    case mjOBJ_TEXTURE:
      return m.ntex;
    case mjOBJ_MATERIAL:
      return m.nmat;
    case mjOBJ_EQUALITY:
      return m.neq;
    case mjOBJ_TENDON:
      return m.ntendon;
    case mjOBJ_ACTUATOR:
      return m.nu;
    case mjOBJ_SENSOR:
      return m.nsensor;
    case mjOBJ_KEY:
      return m.nkey;
    default:
      return 0;
  }
}

Pose PoseOf(const mjtNum* pos, const mjtNum* mat) {
  Pose X = Pose::Identity();
  X.translation() = Eigen::Map<const Eigen::Vector3d>(pos);
  X.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(mat);
  return X;
}

/// MuJoCo's cameras have x right, y up and look along -z; ours x right, y down, z forward. The
/// only place where the two meet.
Pose OpticalFromMujocoCamera(const Pose& X_WM) {
  Pose X_WC = X_WM;
  X_WC.linear().col(1) *= -1;
  X_WC.linear().col(2) *= -1;
  return X_WC;
}

/// Writes a pose as MuJoCo keeps it: position and quaternion in the order w x y z.
void StorePose(const Pose& X, mjtNum* pos, mjtNum* quat) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(X.linear()).normalized();
  Eigen::Map<Eigen::Vector3d>{pos} = X.translation();
  Eigen::Map<Eigen::Vector4d>{quat} << q.w(), q.x(), q.y(), q.z();
}

}  // namespace

void World::ModelDeleter::operator()(mjModel* m) const { mj_deleteModel(m); }
void World::DataDeleter::operator()(mjData* d) const { mj_deleteData(d); }

World::World(const std::filesystem::path& mjcf) : World(Load(mjcf), mjcf) {}

World::World(ModelPtr model, std::filesystem::path path)
    : path_(std::move(path)),
      model_(std::move(model)),
      step_(hardware::FromSeconds(model_->opt.timestep)) {
  if (step_.count() < 1) {
    throw SceneError(fmt::format("{}: timestep {} s is below one nanosecond", DescribePath(path_),
                                 model_->opt.timestep));
  }
  model_->opt.timestep = hardware::ToSeconds(step_);
  try {
    data_.reset(mj_makeData(model_.get()));
    Reset();
  } catch (const PhysicsError& e) {
    throw SceneError(fmt::format("{}: {}", DescribePath(path_), OneLine(e.what())));
  }
}

World::ModelPtr World::Load(const std::filesystem::path& mjcf) {
  InstallMujocoHandlers();
  if (!std::filesystem::is_regular_file(mjcf)) {
    throw SceneError(fmt::format("{} does not exist or is not a file", DescribePath(mjcf)));
  }
  std::array<char, 1024> reason{};
  ModelPtr model;
  try {
    model.reset(mj_loadXML(mjcf.c_str(), nullptr, reason.data(), reason.size()));
  } catch (const PhysicsError& e) {
    throw SceneError(fmt::format("{}: {}", DescribePath(mjcf), OneLine(e.what())));
  }
  const std::string text = OneLine(reason.data());
  if (model == nullptr) throw SceneError(fmt::format("{}: {}", DescribePath(mjcf), text));
  if (!text.empty()) spdlog::warn("{}: {}", DescribePath(mjcf), text);
  return model;
}

std::unique_ptr<World> World::FromXml(std::string_view mjcf_text) {
  InstallMujocoHandlers();
  constexpr const char* kName = "text.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const struct Cleanup {
    mjVFS* files;
    ~Cleanup() { mj_deleteVFS(files); }
  } cleanup{files.get()};
  if (mjcf_text.empty()) throw SceneError("scene from text: the text is empty");
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(mjcf_text.size())) != 0) {
    throw SceneError("scene from text: too large");
  }
  std::memcpy(files->filedata[0], mjcf_text.data(), mjcf_text.size());

  std::array<char, 1024> reason{};
  ModelPtr model;
  try {
    model.reset(mj_loadXML(kName, files.get(), reason.data(), reason.size()));
  } catch (const PhysicsError& e) {
    throw SceneError(fmt::format("scene from text: {}", OneLine(e.what())));
  }
  if (model == nullptr) {
    throw SceneError(fmt::format("scene from text: {}", OneLine(reason.data())));
  }
  return std::unique_ptr<World>(new World(std::move(model), {}));
}

World::~World() = default;

void World::Step() {
  ThrowIfBroken();
  // The position and velocity stages of this state ran at the end of the last call, so a step is
  // MuJoCo's second half first. RK4 has no halves.
  if (model_->opt.integrator == mjINT_RK4) {
    mj_step(model_.get(), data_.get());
  } else {
    mj_step2(model_.get(), data_.get());
  }
  ++step_count_;
  Forward();
}

void World::Forward() {
  mj_step1(model_.get(), data_.get());
  ThrowIfBroken();
}

void World::Reset() {
  mj_resetData(model_.get(), data_.get());
  step_count_ = 0;
  mj_forward(model_.get(), data_.get());
  ThrowIfBroken();
}

void World::ThrowIfBroken() const {
  constexpr std::array kFatal{mjWARN_INERTIA, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL,
                              mjWARN_BADQPOS, mjWARN_BADQVEL,     mjWARN_BADQACC};
  for (const mjtWarning warning : kFatal) {
    const mjWarningStat& stat = data_->warning[warning];
    if (stat.number == 0) continue;
    throw PhysicsError(fmt::format("{}: physics failed by {:.9g} s: {}", DescribePath(path_),
                                   hardware::ToSeconds(now()),
                                   OneLine(mju_warningText(warning, stat.lastinfo))));
  }
}

Pose World::X_WBody(std::string_view body) const {
  const int id = Id(mjOBJ_BODY, body);
  return PoseOf(data_->xpos + 3 * id, data_->xmat + 9 * id);
}

Pose World::X_WCamera(std::string_view camera) const {
  const int id = Id(mjOBJ_CAMERA, camera);
  return OpticalFromMujocoCamera(PoseOf(data_->cam_xpos + 3 * id, data_->cam_xmat + 9 * id));
}

int World::Id(mjtObj type, std::string_view name) const {
  const int id = mj_name2id(model_.get(), type, std::string(name).c_str());
  if (id >= 0) return id;
  std::vector<std::string> names;
  for (int i = 0; i < CountOf(*model_, type); ++i) {
    const char* known = mj_id2name(model_.get(), type, i);
    if (known != nullptr) names.emplace_back(known);
  }
  std::string hint = names.empty() ? fmt::format("; it has no named {}", TypeName(type)) : "";
  if (const auto nearest = NearestName(name, names)) {
    hint = fmt::format("; did you mean '{}'?", *nearest);
  }
  throw SceneError(
      fmt::format("{} has no {} named '{}'{}", DescribePath(path_), TypeName(type), name, hint));
}

std::string World::Name(mjtObj type, int id) const {
  const char* name = mj_id2name(model_.get(), type, id);
  if (name != nullptr && *name != '\0') return name;
  return fmt::format("{} {}", TypeName(type), id);
}

void World::PlaceBody(std::string_view body, const Pose& X_WBody) {
  const int id = Id(mjOBJ_BODY, body);
  const bool is_mocap = model_->body_mocapid[id] >= 0;
  if (id == 0 || (!is_mocap && model_->body_weldid[id] != 0)) {
    throw SceneError(fmt::format("{}: body '{}' cannot be placed: only static and mocap bodies can",
                                 DescribePath(path_), body));
  }
  const int parent = model_->body_parentid[id];
  const Pose X_WP = PoseOf(data_->xpos + 3 * parent, data_->xmat + 9 * parent);
  StorePose(X_WP.inverse() * X_WBody, model_->body_pos + 3 * id, model_->body_quat + 4 * id);
  if (is_mocap) {
    const int mocap = model_->body_mocapid[id];
    StorePose(X_WBody, data_->mocap_pos + 3 * mocap, data_->mocap_quat + 4 * mocap);
  }
  Forward();
}

std::vector<Contact> World::Contacts() const {
  std::vector<Contact> contacts;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& c = data_->contact[i];
    if (c.dist > 0) continue;  // within the geoms' margin, not touching
    contacts.push_back({Name(mjOBJ_GEOM, c.geom1), Name(mjOBJ_GEOM, c.geom2),
                        Name(mjOBJ_BODY, model_->geom_bodyid[c.geom1]),
                        Name(mjOBJ_BODY, model_->geom_bodyid[c.geom2]), c.dist,
                        Eigen::Map<const Eigen::Vector3d>(c.pos),
                        Eigen::Map<const Eigen::Vector3d>(c.frame)});
  }
  return contacts;
}

}  // namespace horopter::sim
