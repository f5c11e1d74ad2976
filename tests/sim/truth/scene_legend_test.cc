// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/scene_legend.h"

#include <gtest/gtest.h>

#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

constexpr const char* kRoom = R"(
<mujoco>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 .1"/>
    <geom type="box" size=".1 .1 .1"/>
    <body name="table"><geom name="top" type="box" size=".1 .1 .1"/>
      <body name="leg"><geom type="box" size=".1 .1 .1"/></body></body>
    <body><body><geom name="loose" type="box" size=".1 .1 .1"/></body>
      <body name="vase"><geom name="glaze" type="sphere" size=".1"/></body></body>
    <body name="table2"><freejoint/><geom type="sphere" size=".1"/></body>
    <body><joint/><geom name="hand" type="sphere" size=".1"/></body>
  </worldbody>
</mujoco>)";

TEST(SceneLegend, AnObjectIsTheTopmostNamedOrMovingBodyOrAGeomOfTheWorld) {
  TruthScene scene(kRoom);
  const SceneLegend legend(scene.world().model());
  const auto object_of = [&](const char* geom) {
    return legend.ObjectName(legend.ObjectOf(scene.Geom(geom)));
  };
  EXPECT_EQ(object_of("floor"), "floor");
  EXPECT_EQ(object_of("top"), "table");
  EXPECT_EQ(object_of("glaze"), "vase") << "a nameless frame around it is no object";
  EXPECT_EQ(object_of("loose").substr(0, 5), "body ");
  EXPECT_EQ(object_of("hand").substr(0, 5), "body ");
  EXPECT_EQ(legend.part_count(), 8);
  EXPECT_EQ(legend.object_count(), 7) << "the leg is the table's";
}

TEST(SceneLegend, NamesPartsOrSaysWhereTheyAre) {
  TruthScene scene(kRoom);
  const SceneLegend legend(scene.world().model());
  EXPECT_EQ(legend.PartName(scene.Geom("top")), "top");
  EXPECT_EQ(legend.PartName(1), "geom 1");
  EXPECT_EQ(legend.PartName(3), "geom 3 of table");
  EXPECT_EQ(legend.ObjectOf(-1), -1);
  EXPECT_THROW(legend.PartName(99), std::out_of_range);
}

TEST(SceneLegend, MapsPartsToObjectsPixelByPixel) {
  TruthScene scene(kRoom);
  const SceneLegend legend(scene.world().model());
  const cv::Mat1i objects = legend.Objects((cv::Mat1i(2, 2) << -1, 0, 2, 3));
  EXPECT_EQ(objects(0, 0), -1);
  EXPECT_EQ(objects(0, 1), 0);
  EXPECT_EQ(objects(1, 0), 2);
  EXPECT_EQ(objects(1, 1), 2);
}

}  // namespace
}  // namespace horopter::sim
