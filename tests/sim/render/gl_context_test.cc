// SPDX-License-Identifier: Apache-2.0
#include "sim/render/gl_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "hardware/types/config_error.h"

namespace horopter::sim {
namespace {

using hardware::ConfigError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(GlContext, OsmesaNamesItselfAndItsDriver) {
  const auto context = CreateGlContext("osmesa", 16, 8);
  EXPECT_EQ(context->name(), "osmesa");
  EXPECT_FALSE(context->gl_renderer().empty());
  EXPECT_NE(context->gl_renderer(), "unknown");
  EXPECT_NE(context->Function("glReadPixels"), nullptr);
}

TEST(GlContext, OthersSurviveTheEndOfOne) {
  const auto first = CreateGlContext("osmesa", 4, 4);
  const std::string name = first->gl_renderer();
  CreateGlContext("osmesa", 8, 8).reset();
  EXPECT_EQ(first->gl_renderer(), name);
}

TEST(GlContext, UnknownBackendListsTheKnownOnes) {
  for (const char* name : {"vulkan", "", "OSMESA", "osmesa "}) {
    EXPECT_THAT([&] { CreateGlContext(name, 4, 4); },
                ThrowsMessage<ConfigError>(AllOf(HasSubstr(name), HasSubstr("osmesa, egl"))));
  }
}

TEST(GlContext, AProcessUsesOneBackendOnly) {
  const auto context = CreateGlContext("osmesa", 4, 4);
  EXPECT_EQ(GlBackendInUse(), "osmesa");
  EXPECT_THAT([] { CreateGlContext("egl", 4, 4); },
              ThrowsMessage<RenderError>(
                  AllOf(HasSubstr("'egl'"), HasSubstr("already draws with 'osmesa'"))));
}

TEST(GlContext, AnotherThreadMayHaveItOnceReleased) {
  const auto context = CreateGlContext("osmesa", 4, 4);
  const std::string name = context->gl_renderer();
  context->Release();
  std::string elsewhere;
  std::thread([&] {
    elsewhere = context->gl_renderer();
    context->Release();
  }).join();
  EXPECT_EQ(elsewhere, name);
  EXPECT_EQ(context->gl_renderer(), name);
}

TEST(GlContext, RefusesEmptyFramebuffers) {
  EXPECT_THROW(CreateGlContext("osmesa", 0, 4), ConfigError);
  EXPECT_THROW(CreateGlContext("osmesa", 4, -1), ConfigError);
}

}  // namespace
}  // namespace horopter::sim
