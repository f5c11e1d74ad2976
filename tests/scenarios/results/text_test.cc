// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "scenarios/results/axis.h"

namespace horopter::scenarios {
namespace {

TEST(CleanText, KeepsWhatXmlCanHoldAndReplacesTheRest) {
  EXPECT_EQ(CleanText("plain \t\n \u00e9 \u20ac \U0001F600"),
            "plain \t\n \u00e9 \u20ac \U0001F600");
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(CleanText(std::string("a\0b\x1b", 4)), "a" + bad + "b" + bad);
  EXPECT_EQ(CleanText("\xff"
                      "a"),
            bad + "a");
  EXPECT_EQ(CleanText("\xe2\x82"), bad + bad);            // truncated
  EXPECT_EQ(CleanText("\xc0\xaf"), bad + bad);            // overlong
  EXPECT_EQ(CleanText("\xed\xa0\x80"), bad + bad + bad);  // surrogate
  EXPECT_EQ(CleanText("\xef\xbf\xbf"), bad);              // not a character
}

TEST(EscapeHtml, LeavesNothingThatEndsTextOrAttribute) {
  EXPECT_EQ(EscapeHtml("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(UrlPath, EncodesWhatAnHrefWouldMisread) {
  EXPECT_EQ(UrlPath("a/b c#1?.d%"), "a/b%20c%231%3F.d%25");
}

TEST(CsvField, StaysOneFieldOnOneLine) {
  EXPECT_EQ(CsvField("plain"), "plain");
  EXPECT_EQ(CsvField("a,\"b\"\nc"), "\"a,\"\"b\"\" c\"");
}

TEST(ExactNumber, ReadsBackAsTheSameDouble) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, exponent(random));
    EXPECT_EQ(std::stod(ExactNumber(value)), value);
  }
  EXPECT_EQ(ExactNumber(0.1), "0.1");
  EXPECT_EQ(ExactNumber(std::nullopt), "");
  EXPECT_EQ(ExactNumber(std::nan("")), "");
}

TEST(ShortNumber, KeepsFourDigitsAndNoNoise) {
  EXPECT_EQ(ShortNumber(0.0), "0");
  EXPECT_EQ(ShortNumber(0.1), "0.1");
  EXPECT_EQ(ShortNumber(3.14159), "3.142");
  EXPECT_EQ(ShortNumber(-0.05), "-0.05");
  EXPECT_EQ(ShortNumber(1234.56), "1235");
  EXPECT_EQ(ShortNumber(100.0), "100");
  EXPECT_EQ(ShortNumber(1e-7), "1e-07");
  EXPECT_EQ(ShortNumber(std::nullopt), "\u2013");
}

TEST(Base64, AgreesWithRfc4648) {
  const auto encode = [](const std::string& text) {
    return Base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
}

TEST(Axis, StepsAreRoundAndFewEnough) {
  for (const double span : {1e-6, 0.03, 0.7, 1.0, 4.2, 99.0, 12345.0}) {
    const double step = NiceStep(span, 8);
    EXPECT_LE(span / step, 8 * (1 + 1e-9)) << span;
    EXPECT_GT(span / step, 8 / 2.6) << span;
  }
  EXPECT_EQ(Ticks(-0.5, 1.2, 0.5).size(), 4u);
  EXPECT_EQ(TickText(-1e-12, 0.5), "0.0");
  EXPECT_EQ(TickText(20, 10), "20");
}

}  // namespace
}  // namespace horopter::scenarios
