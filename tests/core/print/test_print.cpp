#include "core/print/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/pattern/curve.h"
#include "core/print/pages.h"
#include "core/print/sheet.h"

namespace toile::print {
namespace {

pattern::Panel rectangle(const std::string& id, double width, double height) {
  const Vec2 corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  pattern::Panel panel;
  panel.id = id;
  for (std::size_t i = 0; i < 4; ++i)
    panel.outline.edges.push_back(
        {"e" + std::to_string(i), {pattern::line_segment(corners[i], corners[(i + 1) % 4])}});
  return panel;
}

pattern::Pattern shirt() {
  pattern::Pattern out;
  out.panels = {rectangle("cuff", 220, 60), rectangle("front", 520, 700), rectangle("back", 520, 710),
                rectangle("sleeve <left>", 400, 600)};
  out.panels[1].notches.push_back({{520, 350}, 0, {-1, 0}});
  out.panels[1].lines.push_back({"fold", {{100, 100}, {400, 100}}, false});
  return out;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++found;
  return found;
}

TEST(Sheet, LaysPiecesOutInTheirSizeApartAndWithinItsOwn) {
  const pattern::Pattern pattern = shirt();
  for (const double width : {100.0, 900.0, 3000.0}) {
    const Sheet sheet = lay_out(pattern, "Shirt", width);
    ASSERT_EQ(sheet.pieces.size(), 4u);
    for (std::size_t a = 0; a < 4; ++a) {
      const Aabb2& box = sheet.pieces[a];
      EXPECT_TRUE(none_above({0, 0}, box.low) && none_above(box.high, sheet.size)) << a;
      for (std::size_t b = 0; b < a; ++b) {
        const Aabb2& other = sheet.pieces[b];
        const double apart = std::max({box.low.x - other.high.x, other.low.x - box.high.x,
                                       box.low.y - other.high.y, other.low.y - box.high.y});
        EXPECT_GE(apart, 10) << a << " and " << b << " at width " << width;
      }
    }
    EXPECT_NEAR(sheet.pieces[1].size().x, 520, 1e-9);
    EXPECT_NEAR(sheet.pieces[1].size().y, 700, 1e-9);
  }
}

TEST(Sheet, KeepsTheWidthWhereNoPieceIsWider) {
  EXPECT_EQ(lay_out(shirt(), "", 900).size.x, 900);
  EXPECT_EQ(lay_out(shirt(), "", 100).size.x, 520 + 30);
}

TEST(Pages, ShowTheWholeOfEachPiece) {
  for (const Paper& paper : kPapers) {
    const Vec2 window = window_of(paper);
    const Sheet sheet = lay_out(shirt(), "Shirt", square_width(shirt(), window));
    const Pages pages = cut_up(sheet, paper);
    for (const Aabb2& box : sheet.pieces) {
      double shown = 0;
      for (const Page& page : pages.shown) {
        const Vec2 low = most_of(box.low, page.corner), high = least_of(box.high, page.corner + window);
        shown += std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y);
      }
      EXPECT_NEAR(shown, box.size().x * box.size().y, 1e-6) << paper.word;
    }
  }
}

TEST(Pages, AreNamedByColumnAndRowFromAbove) {
  const Pages pages = cut_up(lay_out(shirt(), "", 900), kPapers[0]);
  EXPECT_EQ(pages.columns, 5);
  ASSERT_FALSE(pages.shown.empty());
  EXPECT_EQ(pages.shown.front().name, "A1");
  for (const Page& page : pages.shown)
    EXPECT_EQ(page.name, std::string(1, static_cast<char>('A' + page.column)) + std::to_string(page.row + 1));
}

TEST(PatternPdf, HasAPageForEachAndAMapInTheSizeOfThePaper) {
  for (const Paper& paper : kPapers) {
    const auto pdf = pattern_pdf(shirt(), "Shirt", paper);
    ASSERT_TRUE(pdf) << pdf.error().message;
    EXPECT_TRUE(pdf->starts_with("%PDF-"));
    const Vec2 window = window_of(paper);
    const Pages pages = cut_up(lay_out(shirt(), "Shirt", square_width(shirt(), window)), paper);
    EXPECT_EQ(count(*pdf, "/Type /Page\n") + count(*pdf, "/Type /Page\r"), pages.shown.size() + 1)
        << paper.word;
    EXPECT_EQ(*pattern_pdf(shirt(), "Shirt", paper), *pdf) << "equal input gives equal bytes";
  }
}

TEST(PatternPdf, ShowsTheTestSquareInMillimetres) {
  const auto pdf = pattern_pdf(shirt(), "Shirt", kPapers[0]);
  ASSERT_TRUE(pdf);
  EXPECT_NE(pdf->find("2.83465 0 0 2.83465 0 0 cm"), std::string::npos) << "72 points to 25.4 mm";
  EXPECT_NE(pdf->find("15 15 m"), std::string::npos) << "a corner of the square";
  EXPECT_NE(pdf->find("65 65 c"), std::string::npos) << "50 mm on";
}

TEST(PatternPdf, TakesNamesThatItsFontsHaveNot) {
  pattern::Pattern pattern = shirt();
  pattern.panels[0].id = "Ärmel \xE8\xA2\x96";
  EXPECT_TRUE(pattern_pdf(pattern, "Größe 38", kPapers[0]));
}

TEST(PatternPdf, RefusesNothingAndTooMuch) {
  EXPECT_EQ(pattern_pdf({}, "", kPapers[0]).error().code, "print.nothing");
  EXPECT_EQ(pattern_svg({}, "").error().code, "print.nothing");
  pattern::Pattern vast;
  vast.panels = {rectangle("field", 90'000, 90'000)};
  EXPECT_EQ(pattern_pdf(vast, "", kPapers[0]).error().code, "print.too_large");
}

TEST(PatternSvg, IsInMillimetresWithEachLineOnce) {
  const auto svg = pattern_svg(shirt(), "Shirt & co");
  ASSERT_TRUE(svg);
  EXPECT_NE(svg->find("width=\"1400.000mm\""), std::string::npos) << svg->substr(0, 300);
  EXPECT_EQ(count(*svg, "class=\"outline\""), 4u);
  EXPECT_EQ(count(*svg, "class=\"inner\""), 1u);
  EXPECT_EQ(count(*svg, "class=\"grain\""), 12u);
  EXPECT_EQ(count(*svg, "class=\"mark\""), 2u) << "a notch and the square";
  EXPECT_NE(svg->find("sleeve &lt;left&gt;"), std::string::npos);
  EXPECT_NE(svg->find("Shirt &amp; co"), std::string::npos);
}

}  // namespace
}  // namespace toile::print
