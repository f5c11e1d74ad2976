// SPDX-License-Identifier: Apache-2.0
// Holds the NAO's scenes to the paper's dimensions.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

class Workspace : public testing::Test {
 protected:
  /// Distance along a ray to what is there besides the robot, and its geom's name.
  struct Hit {
    double distance_m;
    std::string geom;
  };
  Hit Ray(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    constexpr mjtByte kScene[mjNGROUP] = {1, 0, 0, 0, 0, 0};
    int geom = -1;
    const double d = mj_ray(&world_.model(), &world_.data(), from.data(), direction.data(), kScene,
                            1, -1, &geom);
    return {d, geom < 0 ? "" : world_.Name(mjOBJ_GEOM, geom)};
  }
  hardware::Pose At(double x, double y, double z) {
    hardware::Pose X = hardware::Pose::Identity();
    X.translation() << x, y, z;
    return X;
  }
  void ClearTheFloor() {
    for (const char* body :
         {"box", "rod", "ball", "die_1", "die_2", "bottle_1", "bottle_2", "chair", "board"}) {
      world_.PlaceBody(body, At(20, 20, 0));
    }
  }

  World world_{std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/workspace.xml"};
};

TEST_F(Workspace, WallsEncloseASquareOf240Centimetres) {
  ClearTheFloor();
  for (const double z : {0.02, 0.34}) {
    const Eigen::Vector3d middle(0.9, 0.4, z);
    const Hit front = Ray(middle, {1, 0, 0}), back = Ray(middle, {-1, 0, 0});
    EXPECT_EQ(front.geom, "front_wall");
    EXPECT_EQ(back.geom, "back_wall");
    EXPECT_NEAR(front.distance_m + back.distance_m, 2.4, 1e-6);
    const Hit left = Ray(middle, {0, 1, 0}), right = Ray(middle, {0, -1, 0});
    EXPECT_EQ(left.geom, "left_wall");
    EXPECT_EQ(right.geom, "right_wall");
    EXPECT_NEAR(left.distance_m + right.distance_m, 2.4, 1e-6);
  }
}

TEST_F(Workspace, WallsAre35CentimetresHigh) {
  const Hit front = Ray({2.105, 0.2, 1}, {0, 0, -1});
  EXPECT_EQ(front.geom, "front_wall");
  EXPECT_NEAR(1 - front.distance_m, 0.35, 1e-9);
  const Hit left = Ray({0.3, 1.205, 1}, {0, 0, -1});
  EXPECT_EQ(left.geom, "left_wall");
  EXPECT_NEAR(1 - left.distance_m, 0.35, 1e-9);
  EXPECT_EQ(Ray({0.5, -0.8, 1}, {0, 0, -1}).geom, "floor");
}

TEST_F(Workspace, BoxIs45By20Centimetres) {
  ClearTheFloor();
  world_.PlaceBody("box", At(1, 0, 0));
  const Hit left = Ray({1, 1, 0.1}, {0, -1, 0}), right = Ray({1, -1, 0.1}, {0, 1, 0});
  EXPECT_EQ(left.geom, "box");
  EXPECT_NEAR(2 - left.distance_m - right.distance_m, 0.45, 1e-9);
  const Hit top = Ray({1, 0, 1}, {0, 0, -1});
  EXPECT_EQ(top.geom, "box");
  EXPECT_NEAR(1 - top.distance_m, 0.20, 1e-9);
  const auto corner = [this](const char* site) {
    return Eigen::Map<const Eigen::Vector3d>(world_.data().site_xpos +
                                             3 * world_.Id(mjOBJ_SITE, site));
  };
  EXPECT_NEAR((corner("box_p1") - corner("box_p2")).norm(), 0.45, 1e-9);
  EXPECT_NEAR((corner("box_p1") - corner("box_p5")).norm(), 0.20, 1e-9);
}

TEST_F(Workspace, TheStripSlidesAlongTheRodAndGoesWithIt) {
  const hardware::Pose X_RS = world_.X_WBody("rod").inverse() * world_.X_WBody("rod_strip");
  world_.PlaceBody("rod", At(1.5, 0.3, 0));
  EXPECT_TRUE(world_.X_WBody("rod_strip").isApprox(At(1.5, 0.3, 0) * X_RS, 1e-9));
  world_.PlaceBody("rod_strip", At(1.5, 0.3, 0.2));
  EXPECT_EQ(Ray({0.3, 0.3, 0.2}, {1, 0, 0}).geom, "rod_strip");
  EXPECT_EQ(Ray({0.3, 0.3, 0.38}, {1, 0, 0}).geom, "rod");
  const int strip = world_.Id(mjOBJ_GEOM, "rod_strip");
  const float* rgba = world_.model().mat_rgba + 4 * world_.model().geom_matid[strip];
  EXPECT_GT(rgba[2], 3 * std::max(rgba[0], rgba[1])) << "the strip is blue";
}

TEST_F(Workspace, TheBoardCanBePosedAnywhereAndItsSquaresAre30Millimetres) {
  hardware::Pose X_WB = At(0.6, 0.05, 0.45);
  X_WB.rotate(Eigen::AngleAxisd(2.9, Eigen::Vector3d(0.1, -0.2, 1).normalized()));
  world_.PlaceBody("board", X_WB);
  EXPECT_TRUE(world_.X_WBody("board").isApprox(X_WB, 1e-9));
  const int pattern = world_.Id(mjOBJ_SITE, "board_pattern");
  EXPECT_NEAR(2 * world_.model().site_size[3 * pattern + 1], 9 * 0.03, 1e-9);
  EXPECT_NEAR(2 * world_.model().site_size[3 * pattern + 2], 7 * 0.03, 1e-9);
  // The printed face is where the frame says it is, over the whole pattern.
  const Eigen::Vector3d normal = X_WB.linear().col(0);
  for (const double y : {-0.135, 0.0, 0.135}) {
    for (const double z : {-0.105, 0.105}) {
      const Eigen::Vector3d p = X_WB * Eigen::Vector3d(0, y, z);
      const Hit hit = Ray(p + 0.2 * normal, -normal);
      EXPECT_EQ(hit.geom, "board");
      EXPECT_NEAR(hit.distance_m, 0.2, 1e-9);
    }
  }
}

TEST_F(Workspace, TurnedTheSquareIs230CentimetresDeepBeforeTheRobotsEyes) {
  ClearTheFloor();
  hardware::Pose X_WS = At(1.25, 0, 0);
  X_WS.rotate(Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()));
  world_.PlaceBody("workspace", X_WS);
  const Hit corner = Ray({0.08, 0, 0.2}, {1, 0, 0});
  EXPECT_GT(corner.distance_m, 2.4);
  EXPECT_GT(Ray({0, 0, 0.2}, {-1, 0, 0}).distance_m, 0.25) << "the robot stands inside";
}

TEST_F(Workspace, EverythingThePaperReconstructsIsThereAndInView) {
  const Eigen::Vector3d eye = world_.X_WCamera("left_eye").translation();
  for (const char* geom : {"box", "rod", "ball", "die_1", "die_2", "bottle_1", "bottle_2",
                           "chair_seat", "chair_back", "board"}) {
    const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3d>(world_.data().geom_xpos +
                                                                3 * world_.Id(mjOBJ_GEOM, geom));
    EXPECT_LT(std::abs(std::atan2(p.y() - eye.y(), p.x() - eye.x())), 29.0 * M_PI / 180) << geom;
    EXPECT_GE(p.z(), 0) << geom;
    EXPECT_LT(std::abs(p.y()), 1.2) << geom;
  }
}

TEST(Outdoor, HasTheThingsUnderTheSkyAndNoWalls) {
  const World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/outdoor.xml");
  for (const char* body : {"box", "rod", "bottle_1", "chair", "board", "base"}) {
    EXPECT_NO_THROW(world.Id(mjOBJ_BODY, body));
  }
  EXPECT_THROW(world.Id(mjOBJ_BODY, "workspace"), SceneError);
  EXPECT_EQ(world.model().tex_type[world.Id(mjOBJ_TEXTURE, "sky")], mjTEXTURE_SKYBOX);
  constexpr mjtByte kScene[mjNGROUP] = {1, 0, 0, 0, 0, 0};
  const mjtNum from[3] = {0, 0, 0.5}, up[3] = {0.3, 0.8, 0.6};
  int geom = -1;
  mj_ray(&world.model(), &world.data(), from, up, kScene, 1, -1, &geom);
  EXPECT_EQ(geom, -1) << "no ceiling";
}

TEST(NaoScenes, OneLightCastsShadowsAndNoneMovesWithTheEye) {
  for (const char* scene : {"workspace.xml", "outdoor.xml"}) {
    const World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/" + scene);
    int shadows = 0;
    for (int i = 0; i < world.model().nlight; ++i) shadows += world.model().light_castshadow[i];
    EXPECT_EQ(shadows, 1) << scene;
    EXPECT_EQ(world.model().vis.headlight.active, 0) << scene;
    EXPECT_EQ(world.model().vis.quality.offsamples, 0) << scene;
    EXPECT_LT(world.model().ngeom, 255) << "ids fit a byte";
  }
}

}  // namespace
}  // namespace horopter::sim
