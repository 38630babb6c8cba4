// Files with a fault of one character where a group code stands.

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

/// Two pieces, one in a block, with names and a grain line.
std::string sound_text() {
  return header(4) +
         section("BLOCKS",
                 block("FRONT", rectangle({0, 0}, 300, 500, "1") + rectangle({10, 10}, 280, 480, "14") +
                                    line({90, 90}, {90, 300}, "7"))) +
         entities(insert("FRONT", {0, 0}) + rectangle({800, 0}, 200, 200, "1"));
}

/// Where each line begins.
std::vector<std::size_t> lines_of(const std::string& text) {
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == '\n') begins.push_back(i + 1);
  return begins;
}

TEST(DxfDamage, NoGroupCodeThatCannotBeReadCostsAPiece) {
  const std::string text = sound_text();
  const std::vector<std::size_t> lines = lines_of(text);
  std::size_t as_it_was = 0, all = 0;
  for (std::size_t i = 0; i < lines.size(); i += 2, ++all) {
    std::string damaged = text;
    damaged[lines[i]] = 'q';
    const Result<dxf::DxfDrawing> d = dxf::read_dxf(damaged);
    ASSERT_TRUE(d) << "line " << i + 1 << " " << to_string(d.error());
    EXPECT_TRUE(told(*d, "line " + std::to_string(i + 1) + ": a group code is expected here"));
    ASSERT_EQ(d->pieces.size(), 2u) << "line " << i + 1;
    as_it_was += area_of(d->pieces[0]) == 280 * 480.0 && area_of(d->pieces[1]) == 200 * 200.0 ? 1 : 0;
  }
  EXPECT_GE(10 * as_it_was, 9 * all) << "and most are told by what stands around them";
}

/// Whether the one drawing has a note that the other one has not.
bool tells_more(const dxf::DxfDrawing& d, const dxf::DxfDrawing& than) {
  return std::any_of(d.notes.begin(), d.notes.end(), [&](const std::string& note) {
    return std::find(than.notes.begin(), than.notes.end(), note) == than.notes.end();
  });
}

TEST(DxfDamage, ACodeThatHasBecomeAnotherNumberIsToldByWhatStandsAroundIt) {
  const std::string text = sound_text();
  const dxf::DxfDrawing sound = read_trial(text);
  const std::vector<std::size_t> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    for (const char other : {'1', '4', '8', '9'}) {
      std::string damaged = text;
      if (damaged[lines[i]] == other) continue;
      damaged[lines[i]] = other;
      const Result<dxf::DxfDrawing> d = dxf::read_dxf(damaged);
      ASSERT_TRUE(d) << "line " << i + 1 << " " << other << " " << to_string(d.error());
      const bool as_it_was = d->pieces.size() == 2 && area_of(d->pieces[0]) == 280 * 480.0 &&
                             area_of(d->pieces[1]) == 200 * 200.0;
      EXPECT_TRUE(as_it_was || tells_more(*d, sound)) << "a change is told: line " << i + 1 << " " << other;
    }
  }
}

TEST(DxfDamage, AVertexWhoseCodesChangeStaysWhereItIs) {
  const std::string
      before = groups({{0, "SECTION"}, {2, "ENTITIES"}, {0, "POLYLINE"}, {8, "1"}, {70, "1"}}),
      first = groups({{0, "VERTEX"}, {8, "1"}, {10, "0"}, {20, "0"}}),
      after = groups(
          {{0, "VERTEX"}, {8, "1"}, {10, "300"}, {20, "500"}, {0, "SEQEND"}, {0, "ENDSEC"}, {0, "EOF"}});
  for (const auto& [x, y] : std::vector<std::pair<std::string, std::string>>{
           {"10", "28"}, {"10", "0"}, {"10", "2p"}, {"90", "20"}, {"11", "20"}, {"1p", "20"}, {"30", "20"}}) {
    const std::string middle = "0\nVERTEX\n8\n1\n" + x + "\n300.5\n" + y + "\n20.25\n30\n0\n";
    const dxf::DxfDrawing d = read_trial(before + first + middle + after, in_mm());
    ASSERT_EQ(d.pieces.size(), 1u) << x << " " << y;
    EXPECT_EQ(d.pieces[0].outline.at(1), (Vec2{300.5, 20.25})) << x << " " << y;
    EXPECT_EQ(d.notes.size(), 1u) << x << " " << y;
  }
}

TEST(DxfDamage, LinesTooManyOrTooFewArePassedOver) {
  const std::string whole = sound_text(), grain = line({90, 90}, {90, 300}, "7");
  const std::size_t at = whole.find(grain);
  ASSERT_NE(at, std::string::npos);
  for (const char* between : {"a line of rubbish\n", "three\nlines of\nrubbish\n"}) {
    std::string damaged = whole;
    damaged.insert(at, between);
    const dxf::DxfDrawing d = read_trial(damaged);
    ASSERT_EQ(d.pieces.size(), 2u);
    EXPECT_TRUE(told(d, "reading goes on in line"));
    EXPECT_EQ(d.pieces[0].grain, (Vec2{0, 1}));
  }
}

TEST(DxfDamage, ATextWithMoreFaultsThanGroupsIsRefused) {
  std::string rubbish = groups({{0, "SECTION"}, {2, "ENTITIES"}});
  for (int i = 0; i < 3000; ++i) rubbish += "word\n";
  const auto d = dxf::read_dxf(rubbish);
  ASSERT_FALSE(d);
  EXPECT_EQ(d.error().code, "dxf.bad_group_code");
  EXPECT_EQ(d.error().where, "line 5");
}

}  // namespace
}  // namespace toile
