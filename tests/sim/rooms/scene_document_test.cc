// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/scene_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

namespace fs = std::filesystem;

const fs::path kRoom = fs::path(HOROPTER_SOURCE_DIR) / "scenes/koala/room.xml";

TEST(SceneDocument, TextIsTheSameSceneWithoutTheFiles) {
  const World from_files(kRoom);
  const auto from_text = World::FromXml(SceneDocument(kRoom).Text());
  const mjModel &a = from_files.model(), &b = from_text->model();
  ASSERT_EQ(a.ngeom, b.ngeom);
  ASSERT_EQ(a.nbody, b.nbody);
  ASSERT_EQ(a.ntex, b.ntex);
  for (int i = 0; i < a.ngeom; ++i) {
    EXPECT_EQ(from_files.Name(mjOBJ_GEOM, i), from_text->Name(mjOBJ_GEOM, i));
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(a.geom_size[3 * i + k], b.geom_size[3 * i + k]);
      EXPECT_EQ(from_files.data().geom_xpos[3 * i + k], from_text->data().geom_xpos[3 * i + k]);
    }
    EXPECT_EQ(a.geom_contype[i], b.geom_contype[i]);
  }
}

TEST(SceneDocument, FindsElementsOfIncludedFiles) {
  SceneDocument scene(kRoom);
  EXPECT_TRUE(scene.Find("body", "cupboard"));
  EXPECT_TRUE(scene.Find("light", "lamp"));
  EXPECT_FALSE(scene.Find("body", "lamp"));
  EXPECT_TRUE(scene.Elements("include").empty());
}

TEST(SceneDocument, NamesTheFileThatIsMissingOrNoScene) {
  const auto error_of = [](const fs::path& file) -> std::string {
    try {
      SceneDocument scene(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("/nowhere/attic.xml"), testing::HasSubstr("/nowhere/attic.xml"));
  const fs::path other = fs::path(testing::TempDir()) / "horopter_no_scene.xml";
  std::ofstream(other) << "<robot/>";
  EXPECT_THAT(error_of(other), testing::HasSubstr("no MJCF"));
  const fs::path circular = fs::path(testing::TempDir()) / "horopter_circular.xml";
  std::ofstream(circular) << "<mujoco><include file=\"horopter_circular.xml\"/></mujoco>";
  EXPECT_THAT(error_of(circular), testing::HasSubstr("includes itself"));
}

}  // namespace
}  // namespace horopter::sim
