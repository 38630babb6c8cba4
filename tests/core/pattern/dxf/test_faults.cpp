// What read_dxf answers to files that are broken, hostile or no DXF at all.

#include <gtest/gtest.h>

#include <set>

#include "core/pattern/dxf/read.h"
#include "tests/core/pattern/dxf/allocations.h"
#include "tests/core/pattern/dxf/dxf_text.h"

namespace toile {
namespace {

using namespace dxf_text;

Error error_of(const std::string& text, const dxf::DxfSettings& settings = in_mm()) {
  const Result<dxf::DxfDrawing> d = dxf::read_dxf(text, settings);
  return d ? Error{"accepted", "", ""} : d.error();
}

/// Allocations until it is refused.
std::size_t work_to_refuse(const std::string& text, const std::string& code) {
  const std::size_t before = test::allocations();
  const Error error = error_of(text);
  const std::size_t work = test::allocations() - before;
  EXPECT_EQ(error.code, code);
  return work;
}

TEST(DxfFaults, FilesThatAreNoDxfAreToldApart) {
  EXPECT_EQ(error_of("").code, "dxf.empty");
  EXPECT_EQ(error_of(" \n\r\n ").code, "dxf.empty");
  EXPECT_EQ(error_of(std::string("AutoCAD Binary DXF\r\n\x1a\0abc", 25)).code, "dxf.not_dxf");
  EXPECT_EQ(error_of(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)).code, "dxf.not_dxf");
  EXPECT_EQ(error_of("Dear Sir,\nplease find enclosed\n").code, "dxf.not_dxf");
  EXPECT_EQ(error_of("1\n2\n3\n4\n").code, "dxf.not_dxf");
  EXPECT_EQ(error_of("AC1027......").code, "dxf.not_dxf");
  EXPECT_EQ(error_of("<svg xmlns='x'/>").where, "line 1");
  EXPECT_NE(error_of("<?xml version='1.0'?>\n<svg xmlns='x'/>").message.find("an SVG"), std::string::npos);
  EXPECT_NE(error_of("%PDF-1.7\n").message.find("a PDF"), std::string::npos);
  EXPECT_EQ(error_of(groups({{0, "EOF"}})).code, "dxf.no_outline");
}

bool says(const dxf::DxfDrawing& drawing, const std::string& words) {
  for (const std::string& note : drawing.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

TEST(DxfFaults, AFileWithoutItsLastWordsIsReadAndTold) {
  const std::string whole = entities(rectangle({0, 0}, 10, 10));
  const std::string eof = groups({{0, "EOF"}}), ends = groups({{0, "ENDSEC"}}) + eof;
  const auto no_eof = dxf::read_dxf(whole.substr(0, whole.size() - eof.size()), in_mm());
  ASSERT_TRUE(no_eof) << "behind a whole section ENTITIES only the word EOF is missing";
  EXPECT_TRUE(says(*no_eof, "without EOF"));
  const std::string cut = whole.substr(0, whole.size() - ends.size());
  for (const std::string& text : {cut, cut.substr(0, cut.size() - 1)}) {
    const auto drawing = dxf::read_dxf(text, in_mm());
    ASSERT_TRUE(drawing) << to_string(drawing.error());
    EXPECT_EQ(drawing->pieces.size(), 1u);
    EXPECT_TRUE(
        says(*drawing, "line 46: the file ends without EOF, within section ENTITIES that began in line 2"));
  }
  const auto no_endsec = dxf::read_dxf(
      section("HEADER", "") + groups({{0, "SECTION"}, {2, "ENTITIES"}}) + rectangle({0, 0}, 9, 9) + eof,
      in_mm());
  ASSERT_TRUE(no_endsec) << to_string(no_endsec.error());
  EXPECT_EQ(no_endsec->pieces.size(), 1u);
  EXPECT_TRUE(says(*no_endsec, "ENDSEC is missing before EOF"));
}

TEST(DxfFaults, AnEntityThatTheEndCutsOffIsLeftOutAlone) {
  const std::string first = groups({{0, "SECTION"}, {2, "ENTITIES"}}) + rectangle({0, 0}, 100, 100);
  const std::string light = groups({{0, "LWPOLYLINE"},
                                    {8, "0"},
                                    {90, "4"},
                                    {70, "1"},
                                    {10, "500"},
                                    {20, "0"},
                                    {10, "600"},
                                    {20, "0"},
                                    {10, "600"},
                                    {20, "90"},
                                    {10, "500"},
                                    {20, "90"}});
  const std::string heavy = rectangle({500, 0}, 100, 90);
  for (const std::string& second : {light, heavy}) {
    for (std::size_t n = 0; n < second.size() - 1; ++n) {
      const auto drawing = dxf::read_dxf(first + second.substr(0, n), in_mm());
      ASSERT_TRUE(drawing) << n << " " << to_string(drawing.error());
      ASSERT_EQ(drawing->pieces.size(), 1u) << n << second.substr(0, n);
      ASSERT_TRUE(says(*drawing, "what stands before is read")) << n;
      const dxf::DxfReport& r = drawing->report;
      ASSERT_EQ(r.records, r.structure + r.elsewhere + r.vertices + r.entities) << n;
    }
    const auto drawing = dxf::read_dxf(first + second, in_mm());
    ASSERT_TRUE(drawing);
    EXPECT_EQ(drawing->pieces.size(), 2u) << "nothing is missing of it";
  }
  const Error alone = error_of(groups({{0, "SECTION"}, {2, "ENTITIES"}}) + heavy.substr(0, heavy.size() / 2));
  EXPECT_EQ(alone.code, "dxf.truncated");
  EXPECT_EQ(alone.where.substr(0, 10), "last good ");
}

TEST(DxfFaults, EveryPrefixOfAFileIsAnErrorOrReads) {
  const std::string spline = groups({{0, "SPLINE"},
                                     {8, "0"},
                                     {71, "1"},
                                     {40, "0"},
                                     {40, "0"},
                                     {40, "1"},
                                     {40, "1"},
                                     {10, "0"},
                                     {20, "90"},
                                     {10, "0"},
                                     {20, "0"}});
  const std::string whole =
      "999\ncomment\n" + header(4) +
      section("BLOCKS", block("a", rectangle({0, 0}, 50, 50, "1") + text({1, 1}, "Piece Name: a"))) +
      entities(insert("a", {500, 0}) + polyline({{200, 0}, {300, 0}, {300, 50}}) + line({0, 0}, {90, 0}) +
               spline +
               groups({{0, "ARC"}, {8, "0"}, {10, "0"}, {20, "0"}, {40, "90"}, {50, "0"}, {51, "90"}}) +
               groups({{0, "LWPOLYLINE"},
                       {8, "9"},
                       {70, "1"},
                       {10, "-50"},
                       {20, "0"},
                       {42, "1"},
                       {10, "-90"},
                       {20, "0"},
                       {42, "1"}}));
  ASSERT_TRUE(dxf::read_dxf(whole).ok()) << error_of(whole).message;
  std::set<std::string> codes;
  for (std::size_t n = 0; n < whole.size(); ++n) codes.insert(error_of(whole.substr(0, n)).code);
  EXPECT_TRUE(codes.contains("dxf.truncated"));
  EXPECT_LE(codes.size(), 6u);
  for (std::size_t n = 0, end = whole.find("SEQEND"); n < end; ++n)
    ASSERT_NE(error_of(whole.substr(0, n)).code, "accepted") << n << whole.substr(0, n);
}

TEST(DxfFaults, EveryByteChangedIsAnErrorOrReads) {
  const std::string whole = header(4) + entities(rectangle({0, 0}, 50, 50) + line({100, 0}, {190, 0}));
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (char c : {'\0', '\n', '9', '-', 'e', '\xFF'}) {
      std::string changed = whole;
      changed[i] = c;
      const Error e = error_of(changed);
      EXPECT_FALSE(e.code.empty());
    }
}

TEST(DxfFaults, AnOpenOutlineNamesItsGap) {
  const Error e =
      error_of(entities(line({0, 0}, {100, 0}) + line({100, 0}, {100, 100}) + line({100, 100}, {0, 3})));
  EXPECT_EQ(e.code, "dxf.open_outline");
  EXPECT_NE(e.message.find("(0, 0)"), std::string::npos);
  EXPECT_NE(e.message.find("(0, 3)"), std::string::npos);
  EXPECT_NE(e.message.find("3 mm"), std::string::npos);
  EXPECT_EQ(e.where, "line 6");
  const auto beside = dxf::read_dxf(
      entities(rectangle({500, 500}, 50, 50) + polyline({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, "0", 0)), in_mm());
  ASSERT_TRUE(beside) << "another piece closes";
  EXPECT_EQ(beside->pieces.size(), 1u);
  ASSERT_EQ(beside->report.warnings.size(), 1u);
  EXPECT_EQ(beside->report.warnings[0].at, (Vec2{0, 9}));
  EXPECT_NE(beside->notes[0].find("a gap of 9 mm"), std::string::npos);
  dxf::DxfSettings wide = in_mm();
  wide.chain_tolerance_mm = 5;
  EXPECT_EQ(
      error_of(entities(line({0, 0}, {100, 0}) + line({100, 0}, {100, 100}) + line({100, 100}, {0, 3})), wide)
          .code,
      "accepted");
}

TEST(DxfFaults, PiecesWithoutAreaOrThatCrossThemselvesAreRefusedWithTheirPlace) {
  EXPECT_EQ(error_of(entities(polyline({{0, 0}, {9, 9}, {5, 5}}))).code, "dxf.zero_area");
  EXPECT_EQ(error_of(entities(line({0, 0}, {9, 0}) + line({0, 0}, {9, 0}))).code, "dxf.zero_area");
  const Error e = error_of(entities(polyline({{0, 0}, {10, 10}, {10, 0}, {0, 10}}) + text({9, 5}, "bow")));
  EXPECT_EQ(e.code, "dxf.self_crossing");
  EXPECT_EQ(e.where, "line 6, piece bow, at (5, 5) mm");
}

TEST(DxfFaults, NumbersThatAreNoneAreNamedWithTheirLine) {
  for (const std::string bad : {"abc", "nan", "inf", "-Infinity", "1,5,5", "1.5,5", "", "0x10", "1e999"}) {
    const std::string text =
        entities(groups({{0, "LINE"}, {8, "0"}, {10, bad}, {20, "0"}, {11, "1"}, {21, "1"}}));
    EXPECT_EQ(error_of(text).code, "dxf.bad_number") << bad;
    EXPECT_EQ(error_of(text).where, "line 10");
  }
  EXPECT_EQ(error_of(entities(polyline({{0, 0}, {1e300, 0}, {9, 9}}))).code, "dxf.coordinate_range");
  dxf::DxfSettings metres;
  metres.mm_per_unit = 1000;
  EXPECT_EQ(error_of(entities(rectangle({0, 0}, 5000, 1)), metres).code, "dxf.coordinate_range") << "5 km";
  EXPECT_EQ(error_of(entities(groups({{0, "LINE"}, {8, "0"}, {10, "0"}, {20, "0"}, {11, "1"}}))).code,
            "dxf.missing_coordinate");
  EXPECT_EQ(error_of(section("ENTITIES", "zero\nLINE\n")).code, "dxf.bad_group_code");
}

TEST(DxfFaults, LimitsHold) {
  dxf::DxfSettings settings;
  settings.max_bytes = 100;
  EXPECT_EQ(error_of(entities(rectangle({0, 0}, 9, 9)), settings).code, "dxf.too_large");
  settings = {};
  settings.max_entities = 3;
  std::string lines;
  for (int i = 0; i < 4; ++i) lines += line({double(i), 0}, {9, 9});
  EXPECT_EQ(error_of(entities(lines), settings).code, "dxf.too_large");
  settings = {};
  settings.max_vertices = 3;
  EXPECT_EQ(error_of(entities(rectangle({0, 0}, 9, 9)), settings).code, "dxf.too_large");
  settings = in_mm();
  settings.max_drawn_points = 100;
  EXPECT_EQ(error_of(entities(groups({{0, "CIRCLE"}, {10, "0"}, {20, "0"}, {40, "100000"}})), settings).code,
            "dxf.too_large");
  settings = {};
  settings.max_loops = 1;
  EXPECT_EQ(error_of(entities(rectangle({0, 0}, 9, 9) + rectangle({20, 0}, 9, 9)), settings).code,
            "dxf.too_large");
}

TEST(DxfFaults, AHundredThousandInsertsOfABigBlockStopAtTheLimit) {
  std::string inserts, big;
  for (int i = 0; i < 50; ++i) big += rectangle({i * 20.0, 0}, 9, 9);
  for (int i = 0; i < 100'000; ++i) inserts += "0\nINSERT\n2\na\n10\n0\n20\n0\n";
  EXPECT_LT(work_to_refuse(section("BLOCKS", block("a", big)) + entities(inserts), "dxf.too_large"),
            3'000'000u)
      << "the five million rectangles are not drawn";
}

TEST(DxfFaults, ManyLinesFromOnePointAreBoundedWork) {
  std::string star;
  for (int i = 1; i <= 20'000; ++i) star += line({0, 0}, {double(i), 500});
  EXPECT_LT(work_to_refuse(entities(star), "dxf.open_outline"), 100u * 20'000u) << "not each against each";
}

/// Allocations while so many loops are read, one within the other.
std::size_t work_of_nested_loops(int count) {
  std::string nested;
  for (int i = 1; i <= count; ++i) nested += rectangle({-1.0 * i, -1.0 * i}, 2 * i, 2 * i);
  const std::string text = entities(nested);
  const std::size_t before = test::allocations();
  const auto drawing = dxf::read_dxf(text);
  const std::size_t after = test::allocations();
  EXPECT_EQ(drawing ? drawing->pieces.size() : 0, static_cast<std::size_t>(count) / 2);
  return after - before;
}

TEST(DxfFaults, ThousandsOfNestedLoopsAreBoundedWork) {
  const std::size_t work = work_of_nested_loops(950);
  EXPECT_GT(work, 950u);
  EXPECT_LT(work_of_nested_loops(1900), 3 * work) << "not each against each";
}

TEST(DxfFaults, AsManyOutlinesAsAreAllowedOnTwoLayersAreAPieceEach) {
  const std::size_t most = dxf::DxfSettings{}.max_loops;
  std::string beside;
  for (std::size_t i = 0; i < most; ++i)
    beside += rectangle({20.0 * double(i), 0}, 9, 9 + 0.001 * double(i), i % 2 == 0 ? "front" : "back");
  const auto drawing = dxf::read_dxf(entities(beside), in_mm());
  EXPECT_EQ(drawing ? drawing->pieces.size() : 0, most);
  EXPECT_EQ(error_of(entities(beside + rectangle({0, 50}, 9, 9))).code, "dxf.too_large");
}

TEST(DxfFaults, FiftyMegabytesOfNothingAreRefusedAtOnce) {
  constexpr std::size_t kLittle = 1000;
  EXPECT_LT(work_to_refuse(std::string(50'000'000, 'A'), "dxf.not_dxf"), kLittle);
  std::string zeros(50'000'000, '0');
  for (std::size_t i = 1; i < zeros.size(); i += 2) zeros[i] = '\n';
  EXPECT_LT(work_to_refuse(zeros, "dxf.not_dxf"), kLittle);
  EXPECT_LT(work_to_refuse(groups({{0, "SECTION"}, {2, "ENTITIES"}}) + zeros, "dxf.too_large"),
            dxf::DxfSettings{}.max_entities + kLittle)
      << "and behind a good beginning at the limit";
  EXPECT_LT(work_to_refuse(std::string(50'000'000, '\n'), "dxf.empty"), kLittle);
  EXPECT_LT(work_to_refuse(groups({{0, "SECTION"}, {2, "ENTITIES"}}) + std::string(50'000'000, 'A'),
                           "dxf.bad_group_code"),
            kLittle);
}

}  // namespace
}  // namespace toile
