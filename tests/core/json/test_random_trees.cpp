// Any tree comes back from its text, and a damaged text is a tree or an error with a place.

#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <string>

#include "core/json/tree.h"
#include "tests/damage.h"

namespace toile::json {

/// For whoever reads the smallest tree that fails.
void showValue(const JsonValue& value, std::ostream& out) { out << write_json_line(value); }

namespace {

std::string utf8(char32_t c) {
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3f)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xc0 | c >> 6), tail(0)};
  if (c < 0x10000) return {static_cast<char>(0xe0 | c >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xf0 | c >> 18), tail(12), tail(6), tail(0)};
}

rc::Gen<std::string> texts() {
  // Everything but the surrogates, which are no characters.
  const auto wide = [](char32_t least, char32_t end) {
    return rc::gen::resize(100, rc::gen::inRange(least, end));
  };
  const auto character = rc::gen::oneOf(wide(U'\0', 0x80), wide(0x80, 0xd800), wide(0xe000, 0x110000));
  return rc::gen::map(rc::gen::container<std::u32string>(character), [](const std::u32string& characters) {
    std::string text;
    for (const char32_t c : characters) text += utf8(c);
    return text;
  });
}

rc::Gen<double> numbers() {
  const auto any_bits = rc::gen::map(rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()),
                                     [](std::uint64_t bits) { return std::bit_cast<double>(bits); });
  return rc::gen::suchThat(rc::gen::oneOf(rc::gen::arbitrary<double>(), any_bits),
                           [](double number) { return std::isfinite(number); });
}

rc::Gen<JsonValue> trees(int depth) {
  const auto value = [](auto data) { return JsonValue(std::move(data)); };
  const auto leaf =
      rc::gen::oneOf(rc::gen::just(JsonValue()), rc::gen::map(rc::gen::arbitrary<bool>(), value),
                     rc::gen::map(numbers(), value), rc::gen::map(texts(), value));
  if (depth == 0) return leaf;
  const auto below = trees(depth - 1);
  const auto member = rc::gen::map(rc::gen::pair(texts(), below), [](std::pair<std::string, JsonValue> pair) {
    return JsonMember{std::move(pair.first), std::move(pair.second)};
  });
  const auto members =
      rc::gen::uniqueBy<std::vector<JsonMember>>(member, [](const JsonMember& m) { return m.key; });
  return rc::gen::oneOf(
      leaf, rc::gen::map(rc::gen::scale(0.2, rc::gen::container<std::vector<JsonValue>>(below)), value),
      rc::gen::map(rc::gen::scale(0.2, members), value));
}

bool same(const JsonValue& a, const JsonValue& b) {
  if (a.data.index() != b.data.index()) return false;
  if (a.number()) return *a.number() == *b.number();  // zero is written without a sign
  if (const auto* list = a.array()) {
    return std::equal(list->begin(), list->end(), b.array()->begin(), b.array()->end(), same);
  }
  if (const auto* members = a.object()) {
    return std::equal(
        members->begin(), members->end(), b.object()->begin(), b.object()->end(),
        [](const JsonMember& x, const JsonMember& y) { return x.key == y.key && same(x.value, y.value); });
  }
  return a.text() ? *a.text() == *b.text() : !a.boolean() || *a.boolean() == *b.boolean();
}

RC_GTEST_PROP(RandomJson, AnyTreeComesBackFromEitherWayOfWriting, ()) {
  const JsonValue tree = *trees(3);
  for (const std::string& text : {write_json(tree), write_json_line(tree)}) {
    const Result<JsonValue> back = parse_json(text);
    if (!back) RC_FAIL(to_string(back.error()) + " in " + text);
    RC_ASSERT(same(*back, tree));
  }
}

RC_GTEST_PROP(RandomJson, ADamagedTextIsATreeOrAnErrorWithAPlace, ()) {
  const std::string signs = "{}[],:\"\\-0123456789.eE+ \n\tutrfalsn\xc3\xa9\x01";
  const auto bytes =
      rc::gen::map(rc::gen::elementOf(signs), [](char c) { return static_cast<std::uint8_t>(c); });
  const std::string text = test::struck(write_json(*trees(2)), *test::damage(bytes));
  const Result<JsonValue> tree = parse_json(text);
  RC_CLASSIFY(static_cast<bool>(tree), "a tree");
  if (!tree) {
    RC_ASSERT(tree.error().code.starts_with("json."));
    RC_ASSERT(!tree.error().where.empty() || tree.error().code == "json.duplicate_key");  // of the whole
    return;
  }
  const Result<JsonValue> back = parse_json(write_json_line(*tree));
  RC_ASSERT(static_cast<bool>(back));
  RC_ASSERT(same(*back, *tree));
}

}  // namespace
}  // namespace toile::json
