// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/texture_recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware/types/config_error.h"

namespace horopter::sim {
namespace {

using testing::HasSubstr;

std::string MessageFor(const char* text) {
  try {
    ParseTextureRecipe("crate", text);
  } catch (const hardware::ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TextureRecipe, ReadsSizesAndNumbers) {
  const TextureRecipe recipe = ParseTextureRecipe("wall", "brick,size_m=5.2x2.6,course_m=0.08");
  EXPECT_EQ(recipe.kind, "brick");
  EXPECT_EQ(recipe.size_m, (std::vector<double>{5.2, 2.6}));
  EXPECT_EQ(recipe.Number("course_m", 1), 0.08);
  EXPECT_EQ(recipe.Number("other", 7), 7);
}

TEST(TextureRecipe, BadTextNamesTextureFieldAndRemedy) {
  EXPECT_THAT(MessageFor("granite,size_m=1x1"), HasSubstr("texture:crate"));
  EXPECT_THAT(MessageFor("granite,size_m=1x1"), HasSubstr("marble"));
  EXPECT_THAT(MessageFor(""), HasSubstr("must be one of"));
  EXPECT_THAT(MessageFor("wood"), HasSubstr("size_m"));
  EXPECT_THAT(MessageFor("wood,size_m=1"), HasSubstr("WxH"));
  EXPECT_THAT(MessageFor("wood,size_m=1x-1"), HasSubstr("WxH"));
  EXPECT_THAT(MessageFor("wood,size_m=1x1,darknes=0.2"), HasSubstr("darkness"));
  EXPECT_THAT(MessageFor("wood,size_m=1x1,darkness=deep"), HasSubstr("must be a number"));
}

TEST(TextureRecipe, ReportsEveryBadPartAtOnce) {
  try {
    ParseTextureRecipe("crate", "wood,size_m=big,darkness=deep,shine=1");
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 3U);
  }
}

}  // namespace
}  // namespace horopter::sim
