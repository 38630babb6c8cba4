#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>

#include "core/base/text.h"

namespace toile {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[400];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

TEST(Text, LosesItsBlanksAtBothEndsOnly) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed("\v\f "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, LowersLettersOfAsciiAndNoOthers) { EXPECT_EQ(lower_case("ÄRMEL Left_2"), "Ärmel left_2"); }

TEST(Text, PartsNamesAtSignsDigitsAndCapitals) {
  EXPECT_EQ(words_of_name("leftSleeve-2 CF"), (std::vector<std::string>{"left", "sleeve", "cf"}));
  EXPECT_EQ(words_of_name("__7"), std::vector<std::string>{});
  EXPECT_EQ(words_of_name("FRONTPanel"), std::vector<std::string>{"frontpanel"})
      << "a capital after a capital goes on with the word";
}

TEST(Text, WritesNumbersAsPrintfDoes) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                                    static_cast<int>(random() % 120) - 110);
    EXPECT_EQ(fixed_text(value, i % 7), printed("%.*f", i % 7, value));
    EXPECT_EQ(significant_text(value, 1 + i % 9), printed("%.*g", 1 + i % 9, value));
  }
  EXPECT_EQ(fixed_text(2.5, 0), "2") << "a tie goes to the even digit";
  EXPECT_EQ(fixed_text(-0.0, 1), "-0.0");
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::max(), 2).size(), 312u);
}

TEST(Text, WritesTheFewestDigitsThatReadBackTheSame) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  const double third = 1.0 / 3;
  EXPECT_EQ(number_in<double>(number_text(third)), third);
}

TEST(Text, IsANumberOnlyWhenAllOfItIs) {
  EXPECT_EQ(number_in<int>("42"), 42);
  EXPECT_EQ(number_in<int>("-42"), -42);
  EXPECT_EQ(number_in<unsigned>("ff", 16), 255u);
  EXPECT_FALSE(number_in<int>("42 "));
  EXPECT_FALSE(number_in<int>(""));
  EXPECT_FALSE(number_in<int>("3000000000"));
  EXPECT_FALSE(number_in<double>("1.5m"));
}

}  // namespace
}  // namespace toile
