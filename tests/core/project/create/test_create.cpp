// Projects of patterns that have none yet.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/pattern/curve.h"
#include "core/pattern/dxf/write.h"
#include "core/pattern/validate.h"
#include "core/project/create/choose_fabrics.h"
#include "core/project/create/create.h"
#include "core/project/resolve/resolve.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"
#include "tests/core/project/create/slashed_trousers.h"

namespace toile {
namespace {

const char* const kSpecification = R"({"pattern": {"panels": {
    "front": {"translation": [0, 100, 20], "rotation": [0, 0, 0],
      "vertices": [[0, 0], [40, 0], [40, 60], [0, 60]],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
    "back": {"translation": [0, 100, -20], "rotation": [0, 0, 0],
      "vertices": [[0, 0], [0, 60], [40, 60], [40, 0]],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
    "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
                 [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}]]}})";

std::string drawing_of(std::vector<pattern::Panel> panels) {
  const Result<std::string> text = dxf::write_dxf({std::move(panels), {}});
  EXPECT_TRUE(text.ok()) << (text ? "" : to_string(text.error()));
  return text ? *text : std::string{};
}

create::NewProjectSettings settings(std::optional<double> accept = {}) {
  create::NewProjectSettings s;
  s.name = "trial";
  s.pattern_file = "trial.dxf";
  s.body_file = "body.obj";
  s.accept_seams = accept;
  return s;
}

TEST(ProjectNew, TakesSeamsAndPlacesFromASpecification) {
  const auto made = create::new_project(kSpecification, settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.pieces.size(), 2u);
  EXPECT_EQ(made->project.pieces[0].id, "front");
  EXPECT_NEAR(made->project.pieces[0].placement.rigid->translation.y, 1.0, 1e-12);
  EXPECT_EQ(made->project.seams.size(), 2u);
  EXPECT_TRUE(made->proposals.empty()) << "true seams need no proposals";
  const std::vector<json::JsonValue> seams = create::seams_json(*made);
  ASSERT_EQ(seams.size(), 2u);
  EXPECT_EQ(*seams[0].find("confidence")->number(), 1);
  EXPECT_EQ(*seams[0].find("length_a_mm")->number(), 600);
}

TEST(ProjectNew, WritesADocumentThatReadsBack) {
  for (const std::string& text : {std::string(kSpecification), drawing_of(garments::trousers().panels)}) {
    const auto made = create::new_project(text, settings(0.8));
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_TRUE(pattern::validate(made->pattern).ok());
    const auto read = project::parse_project(project::write_project(made->project));
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(project::write_project(*read), project::write_project(made->project));
    EXPECT_EQ(read->seams.size(), made->pattern.seams.size());
  }
}

TEST(ProjectNew, AcceptsNoProposalUnasked) {
  const std::string text = drawing_of(garments::trousers().panels);
  const auto none = create::new_project(text, settings()), sure = create::new_project(text, settings(0.8));
  ASSERT_TRUE(none.ok() && sure.ok());
  EXPECT_TRUE(none->project.seams.empty());
  EXPECT_EQ(none->proposals.size(), sure->proposals.size());
  const auto accepted = std::count_if(sure->proposals.begin(), sure->proposals.end(),
                                      [](const seams::SeamProposal& p) { return p.confidence >= 0.8; });
  EXPECT_GE(accepted, 5);
  EXPECT_EQ(sure->project.seams.size(), static_cast<std::size_t>(accepted));
}

TEST(ProjectNew, CutsAPieceAsOftenAsTheDrawingSays) {
  const pattern::Panel front = garments::piece("front", {{0, 0}, {300, 0}, {260, 500}, {0, 520}});
  dxf::DxfDrawing drawing = dxf::read_dxf(drawing_of({front})).value();
  ASSERT_EQ(drawing.pieces.size(), 1u);
  drawing.pieces[0].quantity = 2;
  drawing.pieces[0].mirrored = 1;
  const auto made = create::new_project(drawing, settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.pieces.size(), 2u);
  EXPECT_TRUE(made->project.pieces[0].from.has_value()) << "the drawing's own piece stays in the drawing";
  EXPECT_FALSE(made->project.pieces[1].outline.empty()) << "the one turned over stands in the document";
  EXPECT_NE(made->project.pieces[0].id, made->project.pieces[1].id);
  const pattern::Panel &a = made->pattern.panels[0], &b = made->pattern.panels[1];
  EXPECT_NEAR(pattern::signed_area(a.outline), pattern::signed_area(b.outline), 1e-6)
      << "both counter-clockwise";
}

TEST(ProjectNew, WhatIsDrawnWithinAPieceReachesTheProject) {
  pattern::Panel front = garments::piece("front", {{0, 0}, {300, 0}, {260, 500}, {0, 520}});
  front.lines = {{"pocket", {{50, 300}, {120, 300}, {120.5, 400.25}}}};
  std::string text = drawing_of({front});
  text.replace(text.find("Quantity: 1"), 11, "Quantity: 2");
  const auto made = create::new_project(text, settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.pieces.size(), 2u);
  EXPECT_TRUE(made->project.pieces[0].lines.empty()) << "they stand in the file";
  ASSERT_EQ(made->project.pieces[1].lines.size(), 1u) << "the one turned over stands in the document";
  EXPECT_TRUE(made->project.pieces[1].lines[0].drawn);
  project::Project cloth = project::parse_project(project::write_project(made->project)).value();
  cloth.bodies.clear();
  resolve::ProjectFiles files;
  files.dxf_text = [&](const std::string&) -> Result<std::string> { return text; };
  const Result<drape::DrapeInput> input = resolve::resolve_project(cloth, files);
  ASSERT_TRUE(input) << to_string(input.error());
  for (const double side : {1.0, -1.0}) {
    const pattern::Panel& panel = input->pattern.panels[side > 0 ? 0 : 1];
    ASSERT_EQ(panel.lines.size(), 1u);
    ASSERT_EQ(panel.lines[0].points.size(), 3u);
    EXPECT_TRUE(panel.lines[0].drawn);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 p = front.lines[0].points[i];
      EXPECT_LT(length(panel.lines[0].points[i] - Vec2{side * p.x, p.y}), 0.1);
    }
  }
}

TEST(ProjectNew, OfTwoOfAKindOneIsTurnedOver) {
  // What `quantity` says → how many pieces, and how many of them are the drawing's mirror images.
  const std::initializer_list<std::tuple<const char*, std::size_t, std::size_t>> cases{
      {"2", 2, 1}, {"1,1", 2, 1}, {"1,0", 1, 0}, {"2,0", 2, 0}, {"4", 4, 2}, {"0", 1, 0}};
  const pattern::Panel front = garments::piece("front", {{0, 0}, {300, 0}, {260, 500}, {0, 520}});
  for (const auto& [words, count, mirrored] : cases) {
    std::string text = drawing_of({front});
    const std::size_t at = text.find("Quantity: 1");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 11, std::string("Quantity: ") + words);
    const auto made = create::new_project(text, settings());
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    ASSERT_EQ(made->project.pieces.size(), count) << words;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const project::ProjectPiece& piece = made->project.pieces[i];
      turned += piece.from ? 0 : 1;
      EXPECT_EQ(piece.id.find("mirrored") != std::string::npos, !piece.from) << piece.id;
      // The slanted side: to the right in the drawing, to the left in its mirror image.
      double top = 0;
      for (const pattern::PanelEdge& edge : made->pattern.panels[i].outline.edges)
        for (const pattern::CubicBezier& c : edge.curves)
          if (c.p0.y > 499 && c.p0.y < 501) top = c.p0.x;
      EXPECT_NEAR(top, piece.from ? 260 : -260, 1e-6) << words;
    }
    EXPECT_EQ(turned, mirrored) << words;
  }
}

/// A grain line in a file has two ends; the document's points up.
TEST(ProjectNew, PiecesLaidOutHeadFirstHaveTheirGrainTurnedUp) {
  std::vector<pattern::Panel> panels = garments::trousers().panels;
  for (const bool head_first : {false, true}) {
    const auto made = create::new_project(drawing_of(panels), settings());
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    ASSERT_EQ(made->project.pieces.size(), panels.size());
    for (std::size_t p = 0; p < panels.size(); ++p) {
      EXPECT_NEAR(made->pattern.panels[p].grain.y, head_first ? -1 : 1, 1e-6) << made->pattern.panels[p].id;
      EXPECT_EQ(made->project.pieces[p].grain.has_value(), head_first);
    }
    for (pattern::Panel& panel : panels) panel = garments::turned(panel, std::numbers::pi);
  }
}

TEST(ProjectNew, GoresAreNumberedInARowAndNoneIsTurnedOver) {
  const pattern::Panel gore = garments::piece("gore", {{-110, 0}, {110, 0}, {47, 600}, {-47, 600}});
  std::string text = drawing_of({gore});
  text.replace(text.find("Quantity: 1"), 11, "Quantity: 8");
  create::NewProjectSettings seams = settings();
  seams.accept_seams = 0.8;
  const auto made = create::new_project(text, seams);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.pieces.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(made->project.pieces[k].id, "gore_" + std::to_string(k + 1));
    EXPECT_TRUE(made->project.pieces[k].from) << "all from the file";
  }
  EXPECT_EQ(made->project.seams.size(), 8U) << "once around";
}

TEST(ProjectNew, AHalfBackAmongPairsIsCutTwice) {
  const std::vector<garments::Node> half{{0, 0}, {300, 0}, {260, 500}, {0, 520}};
  const auto made_of = [&](const std::vector<garments::Node>& back, const char* fronts) {
    std::string text = drawing_of({garments::piece("front", {{0, 0}, {280, 0}, {250, 500}, {20, 480}}),
                                   garments::piece("sleeve", {{0, 0}, {200, 0}, {180, 400}, {30, 420}}),
                                   garments::piece("back", back)});
    for (int k = 0; k < 2; ++k) text.replace(text.find("Quantity: 1"), 11, fronts);
    return create::new_project(text, settings()).value();
  };
  const create::NewProject halves = made_of(half, "Quantity: 2");
  EXPECT_EQ(halves.project.pieces.size(), 6U);
  ASSERT_FALSE(halves.notes.empty());
  EXPECT_NE(halves.notes.back().find("\"back\""), std::string::npos) << halves.notes.back();
  const create::NewProject whole = made_of({{-300, 0}, {300, 0}, {260, 500}, {-260, 500}}, "Quantity: 2");
  EXPECT_EQ(whole.project.pieces.size(), 5U) << "its own mirror image needs no other";
  EXPECT_EQ(made_of(half, "Quantity: 1").project.pieces.size(), 3U) << "as the file counts";
}

/// Of a front and a back this wide, as nodes from the middle or around it, and a sleeve of this name.
dxf::DxfDrawing top_that_counts_nothing(const std::vector<garments::Node>& front,
                                        const std::vector<garments::Node>& back, const std::string& sleeve) {
  dxf::DxfDrawing drawing =
      dxf::read_dxf(drawing_of({garments::piece("front", front), garments::piece("back", back),
                                garments::piece(sleeve, {{0, 0}, {200, 0}, {180, 400}, {30, 420}})}))
          .value();
  for (dxf::DxfPiece& piece : drawing.pieces) {
    EXPECT_TRUE(piece.counted) << "it says 'Quantity: 1'";
    piece.counted = false;
  }
  return drawing;
}

std::size_t pieces_of(const dxf::DxfDrawing& drawing) {
  return create::new_project(drawing, settings()).value().project.pieces.size();
}

TEST(ProjectNew, AGarmentDrawnByHalvesIsTakenTwice) {
  const std::vector<garments::Node> front{{0, 0}, {280, 0}, {250, 500}, {0, 480}},
      back{{0, 0}, {300, 0}, {260, 500}, {0, 520}};
  const dxf::DxfDrawing halves = top_that_counts_nothing(front, back, "sleeve");
  const create::NewProject made = create::new_project(halves, settings()).value();
  EXPECT_EQ(made.project.pieces.size(), 6U);
  EXPECT_EQ(std::count_if(made.project.pieces.begin(), made.project.pieces.end(),
                          [](const project::ProjectPiece& p) { return p.id.ends_with("_mirrored"); }),
            3);
  EXPECT_EQ(made.notes.size(), 3U) << "each is told";
  dxf::DxfDrawing counted = halves;
  for (dxf::DxfPiece& piece : counted.pieces) piece.counted = true;
  EXPECT_EQ(pieces_of(counted), 3U) << "as the file says";
  EXPECT_EQ(pieces_of(top_that_counts_nothing(front, back, "left_sleeve")), 3U) << "sides are told apart";
  const std::vector<garments::Node> wide{{0, 0}, {460, 0}, {420, 500}, {0, 480}};
  EXPECT_EQ(pieces_of(top_that_counts_nothing(wide, wide, "sleeve")), 4U)
      << "goes around a person by itself, however uneven";
}

TEST(ProjectNew, AFileWithOneSleeveForBothArmsGivesTwo) {
  const std::vector<garments::Node> whole{{-280, 0}, {280, 0}, {250, 500}, {-250, 500}};
  const create::NewProject made =
      create::new_project(top_that_counts_nothing(whole, whole, "sleeve"), settings()).value();
  ASSERT_EQ(made.project.pieces.size(), 4U);
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_NE(made.notes[0].find("\"sleeve\""), std::string::npos) << made.notes[0];
}

TEST(ProjectNew, NamesTellWhatAGarmentIsMadeOf) {
  const std::vector<std::string> bodice{"front", "back", "sleeve"}, legs{"pant_front_left", "pant_back_left"};
  EXPECT_EQ(create::garment_fabric("summer T-shirt", bodice), "single-jersey");
  EXPECT_EQ(create::garment_fabric("BoxyTee", bodice), "single-jersey");
  EXPECT_EQ(create::garment_fabric("work_pants", {"a", "b"}), "twill");
  EXPECT_EQ(create::garment_fabric("shirt dress", bodice), "shirting");
  EXPECT_EQ(create::garment_fabric("trial", bodice), "shirting");
  EXPECT_EQ(create::garment_fabric("trial", legs), "twill") << "pieces tell, too";
  EXPECT_EQ(create::garment_fabric("trial", {"front", "back", "sleeve", "neckband"}), "single-jersey");
  EXPECT_EQ(create::garment_fabric("trial", {"front", "back", "collar", "neckband"}), "shirting");
  EXPECT_EQ(create::garment_fabric("trial", {"pant_front", "left_torso"}), "shirting") << "an overall";
  EXPECT_EQ(create::garment_fabric("trial", {"LEGGING LEG", "waistband"}), "ponte");
  EXPECT_EQ(create::garment_fabric("Bluse Anna", bodice), "shirting");
  EXPECT_EQ(create::garment_fabric("Modell 3", {"Vorderhose", "Hinterhose"}), "twill");
  EXPECT_EQ(create::piece_fabric("back_lining"), "lining");
  EXPECT_EQ(create::piece_fabric("\u00c4rmelfutter"), "lining");
  EXPECT_EQ(create::piece_fabric("collar-interfacing"), "interlining");
  EXPECT_EQ(create::piece_fabric("front"), "");
  EXPECT_EQ(create::piece_fabric("RIB HEM"), "rib");
  EXPECT_EQ(create::garment_fabric("trial", {"front", "back", "hood", "hem rib"}), "sweatshirt-fleece");
  EXPECT_EQ(create::garment_fabric("trial", {"front", "back", "hood"}), "shirting");
}

TEST(ProjectNew, LegsThatEndNarrowerThanAHeelAreOfAClothThatStretches) {
  for (const bool narrow : {true, false}) {
    pattern::Pattern trousers{garments::trousers().panels, {}};
    project::Project project;
    for (std::size_t p = 0; p < trousers.panels.size(); ++p) {
      pattern::Panel& panel = trousers.panels[p];
      if (narrow) panel = garments::scaled(panel, 0.5);
      panel.id = std::to_string(p + 1);
      project.pieces.emplace_back().id = panel.id;
    }
    create::choose_fabrics(trousers, {}, project);
    EXPECT_EQ(project.fabric, narrow ? "ponte" : "twill");
  }
}

TEST(ProjectNew, APieceThatCannotBeCutIsLeftOutAndNamed) {
  const std::vector<garments::Node> sound{{0, 0}, {280, 0}, {280, 500}, {0, 500}};
  dxf::DxfDrawing drawing =
      dxf::read_dxf(drawing_of({garments::piece("front", sound), garments::piece("flap", sound),
                                garments::piece("back", sound)}))
          .value();
  for (dxf::DxfPiece& piece : drawing.pieces) {
    if (piece.name != "flap") continue;
    piece.outline = {{0, 0}, {200, 0}, {0, 100}, {200, 100}};  // crosses itself
    piece.breaks.clear();
    piece.breaks_are_edges = false;
  }
  const Result<create::NewProject> made = create::new_project(drawing, settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.pieces.size(), 2U);
  EXPECT_EQ(made->project.pieces[0].id, "front");
  EXPECT_EQ(made->project.pieces[1].id, "back");
  const bool told = std::any_of(made->notes.begin(), made->notes.end(),
                                [](const std::string& n) { return n.find("\"flap\"") != std::string::npos; });
  EXPECT_TRUE(told);
  std::erase_if(drawing.pieces, [](const dxf::DxfPiece& piece) { return piece.name != "flap"; });
  const Result<create::NewProject> none = create::new_project(drawing, settings());
  ASSERT_FALSE(none.ok()) << "nothing is left";
  EXPECT_EQ(none.error().code, "pattern.self_crossing");
}

TEST(ProjectNew, SaysWhatIsWrongWithAPattern) {
  EXPECT_EQ(create::new_project("", settings()).error().code, "dxf.empty");
  EXPECT_EQ(create::new_project("{", settings()).error().code, "json.syntax");
  EXPECT_EQ(create::new_project("{\"pattern\": {}}", settings()).error().code.substr(0, 12), "garmentcode.");
}

/// Half of a pair of pyjama trousers, as wide at the waist as at the hip, or narrower there.
pattern::Panel pyjama(const std::string& name, double crotch, double waist) {
  return garments::piece(name, {{0, 0},
                                {270, 0, Vec2{310, 500}, Vec2{310, 900}},
                                {waist, 1060},
                                {0, 1060, Vec2{0, 900}, Vec2{0, 775}},
                                {-crotch, 760}});
}

std::vector<pattern::Panel> pyjamas(double waist) {
  const pattern::Panel front = pyjama("Front", 60, waist), back = pyjama("Back", 120, waist);
  return {front, garments::mirrored(front, "Front_2"), back, garments::mirrored(back, "Back_2")};
}

TEST(ProjectNew, TrousersWithoutAWaistbandHaveAnElasticWhereTheyArePulledOn) {
  const auto made = create::new_project(drawing_of(pyjamas(300)), settings(0.8));
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->project.elastics.size(), 4u);
  for (const project::ProjectElastic& elastic : made->project.elastics) {
    EXPECT_EQ(elastic.lines.size(), 1u) << elastic.piece;
    EXPECT_LT(elastic.factor, 0.7);
  }
  EXPECT_NE(made->notes.back().find("elastics"), std::string::npos);
}

TEST(ProjectNew, AShapedWaistAndAShorterWaistbandNeedNoElastic) {
  EXPECT_TRUE(create::new_project(drawing_of(pyjamas(220)), settings(0.8))->project.elastics.empty());
  for (const double length : {1100.0, 1300.0}) {
    std::vector<pattern::Panel> banded = pyjamas(300);
    banded.push_back(garments::piece("Waistband", {{0, 0}, {length, 0}, {length, 40}, {0, 40}}));
    EXPECT_TRUE(create::new_project(drawing_of(banded), settings(0.8))->project.elastics.empty()) << length;
  }
}

TEST(ProjectNew, ABandAsLongAsAWideWaistIsACasing) {
  std::vector<pattern::Panel> banded = pyjamas(300);
  banded.push_back(garments::piece("Waistband", {{0, 0}, {1200, 0}, {1200, 40}, {0, 40}}));
  const auto made = create::new_project(drawing_of(banded), settings(0.8));
  ASSERT_EQ(made->project.elastics.size(), 1u);
  EXPECT_EQ(made->project.elastics[0].piece, "Waistband");
  EXPECT_EQ(made->project.elastics[0].lines.size(), 1u) << "the free one of its long edges";
}

TEST(ProjectNew, WithoutAnOpeningAWaistThatIsShapedALittleIsPulledOnToo) {
  std::vector<pattern::Panel> banded = pyjamas(280);  // 93 % of the hip
  banded.push_back(garments::piece("Waistband", {{0, 0}, {1120, 0}, {1120, 40}, {0, 40}}));
  const auto elastics = [](const std::vector<pattern::Panel>& panels) {
    return create::new_project(drawing_of(panels), settings(0.8))->project.elastics.size();
  };
  EXPECT_EQ(elastics(banded), 1u);
  std::vector<pattern::Panel> narrow = pyjamas(255);  // 85 %
  narrow.push_back(garments::piece("Waistband", {{0, 0}, {1020, 0}, {1020, 40}, {0, 40}}));
  EXPECT_EQ(elastics(narrow), 1u);
  banded.push_back(garments::piece("Fly facing", {{0, 0}, {50, 0}, {50, 170}, {0, 170}}));
  EXPECT_EQ(elastics(banded), 0u) << "it has a zip";
}

TEST(ProjectNew, ACordHoldsNothingUpAndTakesTheWaistFromNoElastic) {
  std::vector<pattern::Panel> banded = pyjamas(255);  // 85 % of the hip
  banded.push_back(garments::piece("CORDON", {{0, 0}, {1300, 0}, {1300, 30}, {0, 30}}));
  EXPECT_EQ(create::new_project(drawing_of(banded), settings(0.8))->project.elastics.size(), 4u);
}

TEST(ProjectNew, MoreThanAPairOfACuffAreItsLayers) {
  dxf::DxfDrawing drawing =
      dxf::read_dxf(drawing_of({garments::piece("Cuff", {{0, 0}, {240, 0}, {240, 60}, {0, 60}}),
                                garments::piece("Gore", {{0, 0}, {240, 0}, {240, 600}, {0, 600}})}))
          .value();
  for (dxf::DxfPiece& piece : drawing.pieces) {
    piece.quantity = 4;
    piece.mirrored = 2;
  }
  const auto made = create::new_project(drawing, settings());
  std::vector<std::string> names;
  for (const project::ProjectPiece& piece : made->project.pieces) names.push_back(piece.id);
  EXPECT_EQ(names, (std::vector<std::string>{"Cuff", "Cuff_2", "Cuff_mirrored", "Cuff_mirrored_2", "Gore_1",
                                             "Gore_2", "Gore_3", "Gore_4"}));
}

TEST(ProjectNew, APieceThatIsDrawnWholeIsNoLongerTheDrawings) {
  const std::vector<pattern::Panel> panels{
      garments::slashed_front(840), garments::back_of_trousers(1000),
      garments::piece("Pocket facing", {{0, 0}, {60, 0}, {60, 200}, {0, 200}})};
  const auto made = create::new_project(drawing_of(panels), settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_FALSE(made->project.pieces[0].outline.empty()) << "it is no longer the drawing's";
  EXPECT_FALSE(made->project.pieces[0].from.has_value());
}

TEST(ProjectNew, MaterialsOfTheDrawingTellTheCloth) {
  dxf::DxfDrawing drawing = *dxf::read_dxf(drawing_of(garments::trousers().panels));
  for (dxf::DxfPiece& piece : drawing.pieces) piece.material = "JERSEY";
  drawing.pieces.back().material = "Bord-c\u00f4te";
  const auto made = create::new_project(drawing, settings());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->project.fabric, "single-jersey");
  EXPECT_EQ(made->project.pieces.front().fabric, "");
  EXPECT_EQ(made->project.pieces.back().fabric, "rib")
      << "ribs are the garment's own only where nothing else is";
  EXPECT_EQ(create::material_fabric("Popeline 100 % Baumwolle"), "poplin");
  EXPECT_EQ(create::material_fabric("DRESOWKA"), "sweatshirt-fleece");
  EXPECT_EQ(create::material_fabric("SELF"), "");
}

}  // namespace
}  // namespace toile
