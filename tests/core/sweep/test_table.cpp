#include "core/sweep/table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/sweep/contact_sheet.h"

namespace toile::sweep {
namespace {

constexpr const char* kReport = R"({"settled": true, "stop_reason": "settled", "worn": "yes", "cpu_s": 4.256,
  "simulated_s": 2.5, "particles": 3124, "hash": "abc", "open_seams": [{"id": "s", "gap_mm": 3}],
  "intersections": {"cloth_body": 0, "cloth_cloth": 1, "worst_frame": {"step": 1, "cloth_body": 2, "cloth_cloth": 3}},
  "strain": {"warp": {"tension": {"p99": 0.0123}}, "weft": {"tension": {"p99": 0.02}}, "shear": {"p99": 0.1}},
  "fit": [{"at": "waist", "fit": "fits", "ease_mm": 12}, {"at": "waist", "fit": "too_tight", "ease_mm": -21.04},
          {"at": "hip", "fit": "fits", "ease_mm": 60}]})";

Table one_by_two() {
  Table table;
  table.name = "Skirt <A>";
  table.bodies = {"eu36, tall"};
  table.fabrics = {"denim", "the \"best\""};
  Cell done;
  done.job = "j_1";
  done.state = "succeeded";
  done.reason_code = "settled";
  done.fraction = 1;
  done.figures = figures_of(*json::parse_json(kReport));
  done.pictured = true;
  Cell waits;
  waits.job = "j_2";
  waits.state = "queued";
  table.cells = {done, waits};
  return table;
}

TEST(SweepTable, TakesItsFiguresFromTheReport) {
  const Figures f = *figures_of(*json::parse_json(kReport));
  EXPECT_TRUE(f.settled);
  EXPECT_EQ(f.worn, "yes");
  EXPECT_FALSE(f.bust);
  EXPECT_EQ(f.waist, (Ease{"too_tight", -21.04})) << "the tightest of that name";
  EXPECT_EQ(f.hip->ease_mm, 60);
  EXPECT_EQ(f.warp_p99, 0.0123);
  EXPECT_EQ(f.cloth_cloth, 1);
  EXPECT_EQ(f.worst_cloth, 3);
  EXPECT_EQ(f.open_seams, 1);
  EXPECT_EQ(f.particles, 3124);
  EXPECT_FALSE(figures_of(*json::parse_json("{}")));
  EXPECT_FALSE(figures_of(*json::parse_json("null")));
}

TEST(SweepTable, ALineOfCsvForEachCell) {
  const std::string csv = table_csv(one_by_two());
  const auto end = csv.find("\r\n");
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  const std::string names = csv.substr(0, end);
  EXPECT_EQ(
      csv.substr(end + 2),
      "\"eu36, tall\",denim,succeeded,settled,yes,yes,,,too_tight,-21.0,fits,60.0,1.23,2.00,5.73,0,1,2,3,"
      "1,4.26,2.50,3124,abc,j_1\r\n"
      "\"eu36, tall\",\"the \"\"best\"\"\",queued,,,,,,,,,,,,,,,,,,,,,,j_2\r\n");
  EXPECT_EQ(commas(names) + 1, commas(csv.substr(end + 2)) / 2) << "as many names as fields";
}

TEST(SweepTable, CountsItsCells) {
  const Counts counts = counts_of(one_by_two());
  EXPECT_EQ(counts.succeeded, 1);
  EXPECT_EQ(counts.queued, 1);
  EXPECT_EQ(counts.unfinished(), 1);
  EXPECT_EQ(counts.fraction, 0.5);
}

TEST(SweepTable, CellsAsJson) {
  const json::JsonValue done = cell_json(one_by_two(), 0, 0), waits = cell_json(one_by_two(), 0, 1);
  EXPECT_EQ(*done.find("fabric")->text(), "denim");
  EXPECT_EQ(*done.find("figures")->find("waist")->find("fit")->text(), "too_tight");
  EXPECT_TRUE(std::holds_alternative<std::nullptr_t>(waits.find("figures")->data));
}

TEST(SweepTable, CellsComeBackFromJson) {
  for (const std::size_t fabric : {0u, 1u}) {
    const Cell cell = one_by_two().at(0, fabric), back = cell_from(cell_json(one_by_two(), 0, fabric));
    EXPECT_EQ(back.job, cell.job);
    EXPECT_EQ(back.state, cell.state);
    EXPECT_EQ(back.reason_code, cell.reason_code);
    EXPECT_EQ(back.fraction, cell.fraction);
    EXPECT_EQ(back.pictured, cell.pictured);
    EXPECT_EQ(back.figures, cell.figures);
  }
}

TEST(ContactSheet, HasAPictureOrTheStateOfEachCell) {
  const ContactSheet sheet = contact_sheet(one_by_two(), {"png", ""});
  EXPECT_NE(sheet.svg.find("data:image/png;base64,cG5n\""), std::string::npos);
  EXPECT_NE(sheet.svg.find(">queued<"), std::string::npos);
  EXPECT_NE(sheet.svg.find("Skirt &lt;A&gt;"), std::string::npos) << "names are no markup";
  EXPECT_NE(sheet.svg.find("worn, settled"), std::string::npos);
  EXPECT_NE(sheet.svg.find("waist −2.1"), std::string::npos);
  EXPECT_GT(sheet.width, 2 * kStillWidth);
  EXPECT_GT(sheet.height, kStillHeight);
}

}  // namespace
}  // namespace toile::sweep
