// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_request.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scenarios/dataset/format_error.h"
#include "scenarios/format/diagnostics.h"

namespace horopter::scenarios {
namespace {

RenderRequest Full() {
  RenderRequest r;
  r.scene = "yorick/tabletop.xml";
  r.robot = "yorick";
  r.seed = 9007199254740993;  // more digits than a double has
  r.room.emplace().goal_m = {0.1, -1.0 / 3};
  r.room->spec.path = "blocked";
  r.table.emplace().clutter = 4;
  r.table->occluded = 0.3;
  r.table->background = "brick";
  r.pairs = {"foveal"};
  r.camera.width = 320;
  r.camera.height = 200;
  r.camera.horizontal_fov_deg = 14.1;
  r.camera.profile = sim::CameraProfile::Named("sony_xc999");
  r.camera.profile.noise.shot_gain_dn = 0.1 + 0.2;
  r.supersample = r.truth = r.png16 = true;
  r.gl = "egl";
  r.between = {"left:right"};
  r.views = {"overview"};
  r.poses = {"", {"left_pan_deg", "sugar.x_m"}, {{-1.0 / 3, 1e-7}, {0, 2}}};
  SaccadeCommand saccade;
  saccade.gaze_deg[1] = -1.0 / 7;
  r.motion = {0.7,
              {{0.1, saccade},
               {0.2, WalkToCommand{0.3, 0, 1e-3}},
               {0.3, WalkCommand{0.05, 0, 2}},
               {0.4, DriveCommand{0.1 + 0.2, -3}}}};
  return r;
}

void ExpectEqual(const RenderRequest& a, const RenderRequest& b) {
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.robot, b.robot);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.room, b.room);
  EXPECT_EQ(a.table, b.table);
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.supersample, b.supersample);
  EXPECT_EQ(a.gl, b.gl);
  EXPECT_EQ(a.truth, b.truth);
  EXPECT_EQ(a.png16, b.png16);
  EXPECT_EQ(a.between, b.between);
  EXPECT_EQ(a.views, b.views);
  EXPECT_EQ(a.motion, b.motion);
  EXPECT_EQ(a.poses.columns, b.poses.columns);
  EXPECT_EQ(a.poses.rows, b.poses.rows);
}

TEST(RenderRequest, ReadsBackToTheLastBit) {
  ExpectEqual(DecodeRequest(EncodeRequest(Full()), "m"), Full());
  RenderRequest plain;
  plain.scene = "koala/room.xml";
  plain.robot = "koala";
  plain.poses = {"", {"pan_deg"}, {{0}}};
  ExpectEqual(DecodeRequest(EncodeRequest(plain), "m"), plain);
  EXPECT_TRUE(nlohmann::json::parse(EncodeRequest(plain)).at("seed").is_null());
}

TEST(RenderRequest, ManipulatedOnesAreRefused) {
  const auto changed = [](const char* pointer, const nlohmann::json& value) {
    auto json = nlohmann::json::parse(EncodeRequest(Full()));
    json[nlohmann::json::json_pointer(pointer)] = value;
    return json.dump();
  };
  EXPECT_NO_THROW(DecodeRequest(changed("/camera/width", 64), "m"));
  EXPECT_THROW(DecodeRequest(changed("/camera/widht", 64), "m"), ScenarioError);
  EXPECT_THROW(DecodeRequest(changed("/camera/width", 3), "m"), ScenarioError);
  EXPECT_THROW(DecodeRequest(changed("/seed", "three"), "m"), FormatError);
  EXPECT_THROW(DecodeRequest(changed("/poses/rows/0", {1, 2, 3}), "m"), FormatError);
  EXPECT_THROW(DecodeRequest("{", "m"), FormatError);
}

}  // namespace
}  // namespace horopter::scenarios
