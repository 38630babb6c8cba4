#include "core/json/tree.h"

#include <gtest/gtest.h>

#include <string>

namespace toile {
namespace {

std::string repeated(const std::string& text, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text;
  return out;
}

TEST(JsonCodec, ReadsEveryKindOfValue) {
  const auto tree = json::parse_json(R"({"a": [1, -2.5, 1e3], "b": {"c": "ü\n"}, "d": true, "e": null})");
  ASSERT_TRUE(tree) << to_string(tree.error());
  const auto& a = *tree->find("a")->array();
  EXPECT_EQ(*a[0].number(), 1);
  EXPECT_EQ(*a[1].number(), -2.5);
  EXPECT_EQ(*a[2].number(), 1000);
  EXPECT_EQ(*tree->find("b")->find("c")->text(), "ü\n");
  EXPECT_TRUE(*tree->find("d")->boolean());
  EXPECT_TRUE(std::holds_alternative<std::nullptr_t>(tree->find("e")->data));
  EXPECT_EQ(tree->find("f"), nullptr);
}

TEST(JsonCodec, ReadsAsDeepAsAllowedAndNoDeeper) {
  EXPECT_TRUE(json::parse_json(repeated("[", 32) + repeated("]", 32)));
  const auto deeper = json::parse_json(repeated("[", 33) + repeated("]", 33));
  ASSERT_FALSE(deeper);
  EXPECT_EQ(deeper.error().code, "json.too_deep");
}

TEST(JsonCodec, ReadsNoFurtherThanTheLevelThatIsTooDeep) {
  for (const char* level : {"[", "{\"a\":"}) {
    // Whoever read on would meet the question mark, which is another error.
    const auto tree = json::parse_json(repeated(level, 10000) + "?");
    ASSERT_FALSE(tree);
    EXPECT_EQ(tree.error().code, "json.too_deep");
  }
}

TEST(JsonCodec, NamesThePlaceThatIsTooDeep) {
  const auto tree = json::parse_json(R"({"a": [0, {"b": [[]]}]})", {.bytes = 1000, .depth = 4});
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().where, "/a/1/b");
}

TEST(JsonCodec, RefusesATextOverItsSizeBeforeReadingIt) {
  const auto tree = json::parse_json(std::string((std::size_t{4} << 20) + 1, ' '));
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, "json.too_large");
}

TEST(JsonCodec, SaysLineAndColumnOfASyntaxError) {
  const auto tree = json::parse_json("{\n  \"a\": 1,\n  \"b\": ?\n}");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, "json.syntax");
  EXPECT_EQ(tree.error().where, "line 3, column 8");
}

TEST(JsonCodec, RefusesWhatIsNotJson) {
  for (const char* text : {"", " ", "{", "[1,]", "{\"a\":1,}", "nul", "NaN", "[1e999]", "'a'", "[1] 2",
                           "\"\xff\"", "// note\n1", "{\"a\" 1}", "\"a\nb\""}) {
    const auto tree = json::parse_json(text);
    ASSERT_FALSE(tree) << text;
    EXPECT_EQ(tree.error().code, "json.syntax") << text;
  }
}

TEST(JsonCodec, RefusesTheSameKeyTwice) {
  const auto tree = json::parse_json(R"({"a": [{"b": 1, "c": 2, "b": 3}]})");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, "json.duplicate_key");
  EXPECT_EQ(tree.error().where, "/a/0");
}

TEST(JsonCodec, AnErrorNeverCarriesAFloodOfInput) {
  const auto syntax = json::parse_json("\"" + std::string(100000, 'x') + "\" \x01");
  ASSERT_FALSE(syntax);
  EXPECT_LT(to_string(syntax.error()).size(), 300u);
  const auto deep = json::parse_json("{\"" + std::string(100000, 'x') + "\":" + repeated("[", 40));
  ASSERT_FALSE(deep);
  EXPECT_LT(to_string(deep.error()).size(), 300u);
}

TEST(JsonCodec, WritesWhatItReadsBack) {
  const std::string text =
      "{\"third\": 0.3333333333333333, \"tiny\": 5e-324, \"quote\": \"\\\"\\\\\\u0001\", \"list\": [1, [], "
      "{}]}";
  const auto tree = json::parse_json(text);
  ASSERT_TRUE(tree) << to_string(tree.error());
  EXPECT_EQ(json::write_json_line(*tree), text);
}

TEST(JsonCodec, BreaksLinesWhereTheyWouldBeLong) {
  std::vector<json::JsonValue> points;
  for (int i = 0; i < 30; ++i) points.push_back(std::vector<json::JsonValue>{i * 1.0, i * 2.0});
  const std::string text = json::write_json(std::vector<json::JsonMember>{{"points", points}});
  EXPECT_NE(text.find("\n    [29, 58]\n"), std::string::npos) << text;
  const auto again = json::parse_json(text);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->find("points")->array()->size(), 30u);
}

TEST(JsonCodec, WritesUtf8EvenFromBrokenBytes) {
  const std::string text =
      json::write_json_line(json::JsonValue(std::string("a\xff"
                                                        "b")));
  EXPECT_EQ(text,
            "\"a\xEF\xBF\xBD"
            "b\"");
}

TEST(JsonCodec, EscapesReferenceTokensOfAPointer) {
  EXPECT_EQ(json::pointer_to(json::pointer_to("/a", "b/c~d"), std::size_t{3}), "/a/b~1c~0d/3");
}

}  // namespace
}  // namespace toile
