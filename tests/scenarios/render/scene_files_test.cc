// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/scene_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "scenarios/dataset/format_error.h"
#include "scenarios/render/manifest.h"
#include "sim/world/world.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A folder of scenes of its own.
class SceneFiles : public testing::Test {
 protected:
  SceneFiles() {
    setenv("HOROPTER_SCENES_DIR", folder_.path().c_str(), 1);
    folder_.Write("bot/room.xml",
                  "<mujoco><!-- a room --><include file='part.xml'/><worldbody>"
                  "<geom name='floor' type='plane' size='1 1 1'/></worldbody></mujoco>");
    folder_.Write("bot/part.xml",
                  "<mujoco><asset><texture name='t' type='2d' builtin='checker' width='8' "
                  "height='8' rgb1='1 0 0' rgb2='0 1 0'/></asset></mujoco>");
    folder_.Write("bot/robot.yaml", "name: bot\n");
    request_.scene = "bot/room.xml";
    request_.robot = "bot";
  }
  ~SceneFiles() override { unsetenv("HOROPTER_SCENES_DIR"); }

  std::string Resolved() const { return ResolveScene(folder_.path() / "bot" / "room.xml"); }

  TemporaryFolder folder_;
  RenderRequest request_;
};

TEST_F(SceneFiles, TheTextHoldsWhatIsIncludedAndCompilesAlone) {
  const std::string text = Resolved();
  EXPECT_THAT(text, HasSubstr("checker"));
  EXPECT_THAT(text, Not(HasSubstr("include")));
  EXPECT_THAT(text, Not(HasSubstr("a room")));
  EXPECT_EQ(sim::World::FromXml(text)->model().ntex, 1);
  folder_.Write("bot/part.xml", "<mujoco><include file='part.xml'/></mujoco>");
  EXPECT_THROW(Resolved(), FormatError);
}

TEST_F(SceneFiles, EveryFileCountsAndChangesAreNamed) {
  const auto before = HashSceneFiles(request_);
  ASSERT_EQ(before.size(), 3u);
  EXPECT_THAT(ChangedFiles(before, HashSceneFiles(request_)), ElementsAre());
  folder_.Write("bot/part.xml", "<mujoco/>");
  EXPECT_THAT(ChangedFiles(before, HashSceneFiles(request_)), ElementsAre("bot/part.xml"));
  folder_.Write("bot/room.xml", "<mujoco><include file='new.xml'/></mujoco>");
  folder_.Write("bot/new.xml", "<mujoco/>");
  EXPECT_THAT(ChangedFiles(before, HashSceneFiles(request_)),
              ElementsAre("bot/part.xml (gone)", "bot/room.xml", "bot/new.xml (new)"));
}

TEST_F(SceneFiles, PicturesAndMeshesCount) {
  folder_.Write("bot/textures/wood.png", "not looked at");
  folder_.Write("bot/part.xml",
                "<mujoco><compiler texturedir='textures'/><asset><texture name='t' type='2d' "
                "file='wood.png'/></asset></mujoco>");
  EXPECT_EQ(HashSceneFiles(request_).count("bot/textures/wood.png"), 1u);
}

TEST_F(SceneFiles, TexturesAreHashedAsTheyAreDrawn) {
  const auto world = sim::World::FromXml(Resolved());
  const SceneHashes as_written = HashScene(request_, Resolved(), world->model());
  world->mutable_model().tex_rgb[5] ^= 1;
  const SceneHashes painted = HashScene(request_, Resolved(), world->model());
  EXPECT_EQ(as_written.mjcf, painted.mjcf);
  EXPECT_NE(as_written.textures, painted.textures);
}

TEST_F(SceneFiles, AManifestKnowsWhatChangedSinceItWasMade) {
  DatasetManifest manifest;
  manifest.name = "set/manifest.json";
  manifest.request = request_;
  EXPECT_EQ(WhatChangedSince(manifest), "") << "it does not say";
  manifest.scene_sha256.files = HashSceneFiles(request_);
  EXPECT_EQ(WhatChangedSince(manifest), "");
  folder_.Write("bot/robot.yaml", "name: other\n");
  EXPECT_EQ(WhatChangedSince(manifest),
            "the scene has changed since set/manifest.json was made: bot/robot.yaml");
}

}  // namespace
}  // namespace horopter::scenarios
