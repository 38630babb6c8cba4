// Buttons, elastic, folds, cushions, layers, modes and air: from the document to a drape.

#include <gtest/gtest.h>

#include "core/drape/pipeline.h"
#include "core/project/resolve/resolve.h"
#include "core/solver/constraints/pressure.h"
#include "tests/core/project/documents.h"

namespace toile {
namespace {

const std::string kExample = std::string(TOILE_SOURCE_DIR) + "/tests/data/notions.json";

std::string example_text() { return resolve::read_project_text(kExample).value(); }

Result<drape::DrapeInput> resolved(const std::string& text) {
  const project::Project project = TRY(project::parse_project(text));
  return resolve::resolve_project(project, resolve::files_in("."));
}

/// The mean place of a panel's vertices at a flat height, m.
Vec3 middle_at(const drape::DrapeResult& r, Index panel, double flat_y) {
  Vec3 sum;
  int count = 0;
  for (Index v = r.garment.first_vertex[panel]; v < r.garment.first_vertex[panel + 1]; ++v) {
    if (std::abs(r.garment.rest[v].y - flat_y) < 1e-9) {
      sum += r.positions[v];
      ++count;
    }
  }
  return sum * (1.0 / std::max(1, count));
}

TEST(ProjectNotions, ADrawnLineIsFollowedOnceAFoldLiesOnIt) {
  const project::Project project = project::parse_project(example_text()).value();
  const auto lines = [](project::Project p) {
    p.pieces[2].lines[0].drawn = true;
    return resolve::resolve_project(p, resolve::files_in("."));
  };
  EXPECT_FALSE(lines(project)->pattern.panels[2].lines[0].drawn);
  project::Project unfolded = project;
  unfolded.folds.clear();
  EXPECT_TRUE(lines(unfolded)->pattern.panels[2].lines[0].drawn);
  project::Project outside = project;
  outside.pieces[2].lines[0].points.back().x += 1e4;
  const Result<drape::DrapeInput> refused = lines(outside);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "pattern.bad_line");
  EXPECT_NE(refused.error().where.find("/folds/0"), std::string::npos) << refused.error().where;
  outside.folds.clear();
  EXPECT_TRUE(lines(outside)) << "only drawn, it may lie anywhere";
}

TEST(ProjectNotions, AreReadInTheCoresUnits) {
  const drape::DrapeInput input = resolve::read_project(kExample).value().input;
  const sewing::Notions& n = input.notions;
  ASSERT_EQ(n.buttons.size(), 1u);
  EXPECT_EQ(n.buttons[0].a.panel, 0);
  EXPECT_EQ(n.buttons[0].b.panel, 1);
  EXPECT_NEAR(n.buttons[0].b.at.y, 0.04, 1e-12);
  EXPECT_NEAR(n.buttons[0].distance, 1.5e-3, 1e-12);
  ASSERT_EQ(n.elastics.size(), 1u);
  EXPECT_EQ(n.elastics[0].panel, 2);
  EXPECT_EQ(n.elastics[0].edges, std::vector<Index>{2});
  EXPECT_TRUE(n.elastics[0].lines.empty());
  EXPECT_EQ(n.elastics[0].factor, 0.8);
  EXPECT_EQ(n.elastics[0].stiffness, 10);
  ASSERT_EQ(n.creases.size(), 1u);
  EXPECT_EQ(n.creases[0].lines, std::vector<Index>{0});
  EXPECT_NEAR(n.creases[0].angle, 2.0943951, 1e-6);
  EXPECT_NEAR(n.creases[0].stiffness, 0.02, 1e-12);
  ASSERT_EQ(n.cushions.size(), 1u);
  EXPECT_EQ(n.cushions[0].panels, (std::vector<Index>{3, 4}));
  EXPECT_EQ(n.cushions[0].pressure, 20);
  EXPECT_EQ(n.cushions[0].full_volume, 0);
  EXPECT_EQ(input.pattern.panels[0].layer, 1);
  EXPECT_EQ(input.pattern.panels[2].lines[0].points[1], (Vec2{60, 20}));
  EXPECT_EQ(input.settings.mode, drape::DrapeMode::kDynamic);
  EXPECT_FALSE(input.settings.until_settled);
  EXPECT_EQ(input.settings.air.wind, (Vec3{0, 0.1, 0}));
}

TEST(ProjectNotions, TheModeDecidesWhatIsNotSaid) {
  const std::string air =
      R"("air": {"density_kg_m3": 1.2, "drag_across": 1.2, "drag_along": 0.05, "wind_m_s": [0, 0.1, 0]})";
  const std::string text =
      changed(changed(example_text(), ",\n    " + air, ""), ",\n    \"end\": \"time\"", "");
  const drape::DrapeSettings dynamic = resolved(text).value().settings;
  EXPECT_FALSE(dynamic.until_settled);
  EXPECT_EQ(dynamic.air.density, 1.2);
  const drape::DrapeSettings drape = resolved(changed(text, R"("dynamic")", R"("drape")")).value().settings;
  EXPECT_TRUE(drape.until_settled);
  EXPECT_EQ(drape.air.density, 0);
}

TEST(ProjectNotions, NamesThatNothingBearsAreErrorsWithTheirPlace) {
  const auto error = [](const std::string& from, const std::string& to) {
    const Result<drape::DrapeInput> input = resolved(changed(example_text(), from, to));
    return input.ok() ? Error{"accepted", "", ""} : input.error();
  };
  const Error fold = error(R"("lines": ["crease"])", R"("lines": ["creese"])");
  EXPECT_EQ(fold.code, "project.unknown_line");
  EXPECT_EQ(fold.where, "/folds/0/lines/0");
  EXPECT_NE(fold.message.find("crease"), std::string::npos) << "it proposes the line that there is";
  EXPECT_EQ(error(R"("lines": ["top"])", R"("lines": ["tip"])").code, "project.unknown_line");
  EXPECT_EQ(error(R"("pieces": ["pad_front",)", R"("pieces": ["pad_frond",)").where, "/cushions/0/pieces/0");
  EXPECT_EQ(error(R"({"piece": "flap")", R"({"piece": "flop")").where, "/buttons/0/a/piece");
  EXPECT_EQ(error("[[-60, 20], [60, 20]]", "[[-60, 20], [90, 20]]").code, "pattern.bad_line");
}

TEST(ProjectNotions, AFoldLiesAlongLinesAndEdges) {
  const std::string lines = R"("lines": ["crease"])";
  const sewing::Notions n =
      resolved(changed(example_text(), lines, R"("lines": ["top", "crease"])")).value().notions;
  ASSERT_EQ(n.creases.size(), 1u);
  EXPECT_EQ(n.creases[0].edges.size(), 1u);
  EXPECT_EQ(n.creases[0].lines, std::vector<Index>{0});
}

TEST(ProjectNotions, TheExampleDrapes) {
  const drape::DrapeInput input = resolve::read_project(kExample).value().input;
  const Result<drape::DrapeResult> draped = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(draped.ok()) << to_string(draped.error());
  const drape::DrapeResult& r = *draped;
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kTime);
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_EQ(r.seam_gap_max, 0);
  std::vector<Tri> pad;
  for (std::size_t t = 0; t < r.garment.triangles.size(); ++t) {
    const auto& [a, b, c] = r.garment.triangles[t];
    if (r.garment.panel_of_triangle[t] < 3) continue;
    pad.push_back({r.garment.weld[a], r.garment.weld[b], r.garment.weld[c]});
  }
  const double volume = solver::constraints::volume_of(
      solver::constraints::make_chamber(pad, r.garment.vertex_count(), 0, 0), r.positions);
  EXPECT_GT(volume, 0.09e-3) << "80 × 120 mm hold about a tenth of a litre";
  EXPECT_LT(volume, 0.2e-3);
  const Vec3 across = middle_at(r, 2, 0.04) - middle_at(r, 2, 0);
  EXPECT_LT(length(across), 0.03) << "40 mm folded by 120 degrees: 20 mm, more while it swings";
}

}  // namespace
}  // namespace toile
