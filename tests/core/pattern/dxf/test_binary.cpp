// Binary DXF files hold the same groups as texts.

#include "core/pattern/dxf/read.h"
#include "tests/core/pattern/dxf/binary_text.h"
#include "tests/core/pattern/dxf/dialects.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

void expect_alike(const dxf::DxfDrawing& a, const dxf::DxfDrawing& b) {
  EXPECT_EQ(a.notes, b.notes) << "with the lines of the text form";
  EXPECT_EQ(a.unit.name, b.unit.name);
  EXPECT_EQ(a.report.records, b.report.records);
  EXPECT_EQ(a.report.kept, b.report.kept);
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].name, b.pieces[i].name);
    EXPECT_EQ(a.pieces[i].outline, b.pieces[i].outline);
    EXPECT_EQ(a.pieces[i].line, b.pieces[i].line);
    EXPECT_EQ(a.pieces[i].internals, b.pieces[i].internals);
    EXPECT_EQ(a.pieces[i].quantity, b.pieces[i].quantity);
  }
}

TEST(DxfBinary, FilesOfBothKindsReadAsTheirTextsDo) {
  const std::string extras = groups({{0, "LWPOLYLINE"}, {5, "2F"},     {330, "1F"},    {100, "AcDbPolyline"},
                                     {8, "1"},          {370, "-1"},   {290, "1"},     {310, "0A0B0C"},
                                     {90, "3"},         {70, "1"},     {10, "500.25"}, {20, "-3.5e-2"},
                                     {10, "900"},       {20, "0"},     {10, "700"},    {20, "400"},
                                     {1001, "APP"},     {1040, "2.5"}, {1070, "-7"},   {1071, "-70000"},
                                     {1004, "FFFE"}});
  const std::string more =
      "999\na comment\n" + header(4) + entities(rectangle({0, 0}, 300, 400, "1") + extras);
  for (const std::string& text : {graded_blocks(), free_lines(), nested_blocks(), more}) {
    const dxf::DxfDrawing as_text = read_trial(text);
    for (const bool two_bytes : {false, true}) expect_alike(read_trial(as_binary(text, two_bytes)), as_text);
  }
}

TEST(DxfBinary, OneThatIsCutOffIsReadUpToThereOrRefused) {
  const std::string whole =
      as_binary(entities(rectangle({0, 0}, 300, 400, "1") + rectangle({500, 0}, 100, 90, "1")), true);
  std::size_t read = 0;
  for (std::size_t n = 0; n < whole.size(); n += 3) {
    const auto drawing = dxf::read_dxf(whole.substr(0, n), in_mm());
    if (!drawing) {
      EXPECT_TRUE(drawing.error().code == "dxf.truncated" || drawing.error().code == "dxf.not_dxf" ||
                  drawing.error().code == "dxf.empty" || drawing.error().code == "dxf.no_outline")
          << n << " " << to_string(drawing.error());
      continue;
    }
    ++read;
    EXPECT_FALSE(drawing->notes.empty()) << n;
  }
  EXPECT_GT(read, 20u) << "the first piece stands whole in many of them";
}

TEST(DxfBinary, WhatIsNoGroupEndsTheReading) {
  std::string text = as_binary(entities(rectangle({0, 0}, 300, 400, "1")), true);
  const std::size_t vertex = text.find("VERTEX");
  ASSERT_NE(vertex, std::string::npos);
  text.insert(vertex - 2, "\x99\x39");  // 14745 is no group code
  const auto drawing = dxf::read_dxf(text, in_mm());
  ASSERT_FALSE(drawing);
  EXPECT_EQ(drawing.error().code, "dxf.bad_group_code");
}

}  // namespace
}  // namespace toile
