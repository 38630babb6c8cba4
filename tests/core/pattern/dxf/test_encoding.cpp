// Letters beyond ASCII in names, as files of many countries write them.

#include "core/pattern/dxf/encoding.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

/// What a piece is called whose name stands so in a file that declares this code page.
std::string name_in(const std::string& code_page, const std::string& name) {
  const std::string declared =
      code_page.empty() ? "" : section("HEADER", groups({{9, "$DWGCODEPAGE"}, {3, code_page}}));
  const dxf::DxfDrawing d =
      read_trial(declared + entities(rectangle({0, 0}, 300, 400) + text({50, 50}, name)), in_mm());
  return d.pieces.empty() ? "" : d.pieces[0].name;
}

TEST(DxfEncoding, WithoutACodePageBytesAreWindows1252) {
  for (const char* page : {"", "ANSI_1252", "ansi_1252"}) {
    EXPECT_EQ(name_in(page, "\xC4rmel"), "Ärmel");
    EXPECT_EQ(name_in(page,
                      "Gr\xF6\xDF"
                      "e 38"),
              "Größe 38")
        << "two such letters side by side";
    EXPECT_EQ(name_in(page,
                      "Jupe cr\xE9\xE9"
                      "e"),
              "Jupe créée");
    EXPECT_EQ(name_in(page, "Manche \x96 c\x9Cur \x80"), "Manche – cœur €") << "signs that Latin 1 has not";
    EXPECT_EQ(name_in(page, "Ä\xC3\xB6"), "Äö") << "UTF-8 is UTF-8";
  }
}

TEST(DxfEncoding, ADeclaredCodePageIsBelieved) {
  EXPECT_EQ(name_in("ANSI_1250", "R\xEAkaw"), "Rękaw");
  EXPECT_EQ(name_in("ANSI_1251", "\xD1\xEF\xE8\xED\xEA\xE0"), "Спинка");
  EXPECT_EQ(name_in("ANSI_1253", "\xCC\xE1\xED\xDF\xEA\xE9"), "Μανίκι");
  EXPECT_EQ(name_in("ANSI_1254",
                    "\xD6n par\xE7"
                    "a \xFE"),
            "Ön parça ş");
  EXPECT_EQ(name_in("ANSI_1257",
                    "Priek\xF0"
                    "a"),
            "Priekša");
  EXPECT_EQ(name_in("ANSI_932", "\x91\x4F\x90\x67\x8D\xB7"), "前身差");
  EXPECT_EQ(name_in("dos850",
                    "\x8E"
                    "rmel"),
            "Ärmel");
  EXPECT_EQ(name_in("iso8859-1", "\xC4rmel"), "Ärmel");
  EXPECT_EQ(name_in("ANSI_1251", "Спинка"), "Спинка") << "UTF-8 all the same";
}

TEST(DxfEncoding, PairsOfHighBytesAreChineseAsEver) {
  EXPECT_EQ(name_in("", "\xC7\xB0\xC6\xAC"), "前片");
  EXPECT_EQ(name_in("ANSI_1252", "A\xC7\xB0\xC6\xAC-1"), "A前片-1");
  EXPECT_EQ(name_in("ANSI_936", "\xD0\xE4"), "袖");
}

TEST(DxfEncoding, BytesThatThePageHasNoLetterForAreLeftOut) {
  EXPECT_EQ(dxf::utf8_of("a\x81"
                         "b",
                         {}),
            "ab");
  EXPECT_EQ(dxf::utf8_of("", {}), "");
}

}  // namespace
}  // namespace toile
