// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/scene_legend.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace horopter::sim {
namespace {

std::string NameOr(const mjModel& model, mjtObj type, int id, const std::string& otherwise) {
  const char* name = mj_id2name(&model, type, id);
  return name != nullptr && *name != '\0' ? name : otherwise;
}

/// The body that stands for a thing: the first with a name or a joint on the way from the world to
/// `body`, or the first of all.
int ObjectBody(const mjModel& model, int body) {
  int found = model.body_rootid[body];
  for (int at = body; at != 0; at = model.body_parentid[at]) {
    const char* name = mj_id2name(&model, mjOBJ_BODY, at);
    if (model.body_jntnum[at] > 0 || (name != nullptr && *name != '\0')) found = at;
  }
  return found;
}

}  // namespace

SceneLegend::SceneLegend(const mjModel& model) {
  std::map<std::pair<int, int>, int> known;  // body, and geom where the body is the world
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int body = model.geom_bodyid[geom];
    const int root = body == 0 ? 0 : ObjectBody(model, body);
    const auto [object, is_new] =
        known.emplace(std::pair(root, body == 0 ? geom : -1), object_count());
    if (is_new) {
      object_names_.push_back(body == 0
                                  ? NameOr(model, mjOBJ_GEOM, geom, fmt::format("geom {}", geom))
                                  : NameOr(model, mjOBJ_BODY, root, fmt::format("body {}", root)));
    }
    object_of_.push_back(object->second);
    const std::string& object_name = object_names_[static_cast<std::size_t>(object->second)];
    part_names_.push_back(
        NameOr(model, mjOBJ_GEOM, geom,
               body == 0 ? object_name : fmt::format("geom {} of {}", geom, object_name)));
  }
}

cv::Mat1i SceneLegend::Objects(const cv::Mat1i& parts) const {
  cv::Mat1i objects(parts.size());
  for (int y = 0; y < parts.rows; ++y) {
    for (int x = 0; x < parts.cols; ++x) objects(y, x) = ObjectOf(parts(y, x));
  }
  return objects;
}

}  // namespace horopter::sim
