#include "core/exports/report_page.h"

#include <gtest/gtest.h>

#include "core/exports/write_report.h"

namespace toile::exports {
namespace {

std::string page_of(const analysis::Report& report, std::vector<PagePicture> pictures = {}) {
  return report_page(*json::parse_json(report_json(report)), pictures);
}

bool has(const std::string& page, std::string_view text) { return page.find(text) != std::string::npos; }

TEST(ReportPage, TellsWhereItIsTooTight) {
  analysis::Report report;
  analysis::FitLine waist;
  waist.place = "waist";
  waist.body = 0.721;
  waist.garment = 0.7;
  waist.tight_by = 0.021;
  waist.fit = analysis::Fit::kTooTight;
  report.fit = {waist};
  const std::string page = page_of(report);
  EXPECT_TRUE(has(page, "<tr class=\"too_tight\"><td>waist</td><td>72.1</td><td>70.0</td><td>-2.1</td>"));
  EXPECT_TRUE(has(page, "waist 2.1 cm too tight"));
}

TEST(ReportPage, HoldsItsPicturesAndNothingFromOutside) {
  const std::string page = page_of({}, {{"front", "Man"}, {"back", "Ma"}, {"side", "M"}});
  for (const char* bytes : {"base64,TWFu\"", "base64,TWE=\"", "base64,TQ==\""}) EXPECT_TRUE(has(page, bytes));
  EXPECT_FALSE(has(page, "http"));
  EXPECT_FALSE(has(page, "<script"));
}

TEST(ReportPage, ShowsNamesAsTheyAreAndNotAsMarkup) {
  analysis::Report report;
  report.name = "<script>alert(\"&\")</script>";
  report.findings = {
      preflight::found(preflight::FindingKind::kGap, "<b>", {preflight::piece_named("a<i>")}, {})};
  const std::string page = page_of(report);
  EXPECT_TRUE(has(page, "<h1>&lt;script&gt;alert(&quot;&amp;&quot;)&lt;/script&gt;</h1>"));
  EXPECT_FALSE(has(page, "<script"));
  EXPECT_FALSE(has(page, "a<i>"));
}

TEST(ReportPage, SaysNothingOfWhatIsMended) {
  analysis::Report report;
  report.findings = {preflight::found(preflight::FindingKind::kGap, "too near", {}, {})};
  EXPECT_TRUE(has(page_of(report), "too near"));
  report.findings[0].repaired = true;
  EXPECT_FALSE(has(page_of(report), "too near"));
  EXPECT_FALSE(has(page_of(report), "<h2>Findings</h2>"));
}

TEST(ReportPage, LeavesOutWhatThereIsNot) {
  const std::string page = page_of({});
  EXPECT_FALSE(has(page, "<h2>Fit</h2>"));
  EXPECT_FALSE(has(page, "<h2>Findings</h2>"));
  EXPECT_TRUE(has(page, "<h2>Figures</h2>"));
}

}  // namespace
}  // namespace toile::exports
