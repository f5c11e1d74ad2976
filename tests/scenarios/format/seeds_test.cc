// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/seeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace horopter::scenarios {
namespace {

using testing::ElementsAre;

TEST(Seeds, SinglesRangesAndLists) {
  EXPECT_THAT(ParseSeeds("7"), ElementsAre(7));
  EXPECT_THAT(ParseSeeds("0"), ElementsAre(0));
  EXPECT_THAT(ParseSeeds("1-4"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(ParseSeeds("9,3,5-7"), ElementsAre(9, 3, 5, 6, 7));
  EXPECT_THAT(ParseSeeds("9007199254740991"), ElementsAre(9007199254740991));
  EXPECT_THAT(ParseSeeds("9007199254740990-9007199254740991"),
              ElementsAre(9007199254740990, 9007199254740991));
}

TEST(Seeds, RefusesWithTheOffendingPart) {
  for (const char* text : {"",
                           ",",
                           "1,",
                           ",1",
                           "a",
                           "1-",
                           "-1",
                           "1--2",
                           "1-2-3",
                           " 1",
                           "1 ",
                           "1.5",
                           "0x1",
                           "5-1",
                           "1,1",
                           "1-3,2",
                           "9007199254740992",
                           "99999999999999999999999",
                           "1-1000000",
                           "0-9007199254740991"}) {
    EXPECT_THROW(ParseSeeds(text), SeedsError) << "'" << text << "'";
  }
  try {
    ParseSeeds("1,x7");
    FAIL();
  } catch (const SeedsError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'x7' is no seed"));
  }
}

TEST(Seeds, LimitHoldsOverTheWholeList) {
  EXPECT_EQ(ParseSeeds("1-10000").size(), 10000u);
  EXPECT_THROW(ParseSeeds("1-9999,20000-20001"), SeedsError);
}

}  // namespace
}  // namespace horopter::scenarios
