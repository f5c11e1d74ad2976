// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/suggest.h"

#include <gtest/gtest.h>

#include <vector>

namespace horopter::scenarios {
namespace {

TEST(EditDistance, CountsEachKindOfEditOnce) {
  EXPECT_EQ(EditDistance("width", "width"), 0u);
  EXPECT_EQ(EditDistance("width", "widht"), 1u);   // swap
  EXPECT_EQ(EditDistance("width", "wdth"), 1u);    // deletion
  EXPECT_EQ(EditDistance("width", "widdth"), 1u);  // insertion
  EXPECT_EQ(EditDistance("width", "wisth"), 1u);   // substitution
  EXPECT_EQ(EditDistance("", "abc"), 3u);
  EXPECT_EQ(EditDistance("abc", ""), 3u);
  EXPECT_EQ(EditDistance("ca", "abc"), 3u);  // restricted: no edit inside a swap
}

TEST(EditDistance, IsSymmetric) {
  const std::vector<std::string> words = {"", "goto", "gtoo", "fixate", "look_at", "saccade"};
  for (const auto& a : words) {
    for (const auto& b : words) EXPECT_EQ(EditDistance(a, b), EditDistance(b, a)) << a << " " << b;
  }
}

TEST(NearestName, FindsTyposAndIgnoresCase) {
  const std::vector<std::string> names = {"goto", "fixate", "look_at"};
  EXPECT_EQ(NearestName("gotto", names), "goto");
  EXPECT_EQ(NearestName("Fixate", names), "fixate");
  EXPECT_EQ(NearestName("lookat", names), "look_at");
  EXPECT_EQ(NearestName("fix", names), "fixate");
}

TEST(NearestName, OffersNothingFarFetched) {
  const std::vector<std::string> names = {"goto", "fixate"};
  EXPECT_EQ(NearestName("recognise", names), std::nullopt);
  EXPECT_EQ(NearestName("", names), std::nullopt);
  EXPECT_EQ(NearestName(std::string(100000, 'x'), names), std::nullopt);
}

TEST(DidYouMean, ListsNamesWhenNoneIsNear) {
  const std::vector<std::string> names = {"goto", "fixate"};
  EXPECT_EQ(DidYouMean("gotto", names), "; did you mean 'goto'?");
  EXPECT_EQ(DidYouMean("zzzzzzzz", names), "; known: goto, fixate");
  EXPECT_EQ(DidYouMean("x", std::vector<std::string>{}), "");
}

}  // namespace
}  // namespace horopter::scenarios
