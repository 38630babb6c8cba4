// What a person says of layers, where a drawing's layers are not those of AAMA.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;
using dxf::DxfRole;

/// A piece with all that layers tell, on layers of the caller's.
struct LayerNames {
  std::string cut = "1", sew = "14", internal = "8", grain = "7", notch = "4", drill = "13", turn = "2",
              hole = "11";
};

std::string drawn(const LayerNames& on) {
  return entities(rectangle({0, 0}, 300, 400, on.cut) + rectangle({10, 10}, 280, 380, on.sew) +
                  line({50, 100}, {50, 300}, on.internal) + line({150, 100}, {150, 200}, on.grain) +
                  line({0, 200}, {6, 200}, on.notch) + point({100, 100}, on.drill) +
                  point({150, 10}, on.turn) + rectangle({200, 200}, 20, 20, on.hole));
}

dxf::DxfSettings with_layers(dxf::DxfLayerMap layers) {
  dxf::DxfSettings settings = in_mm();
  settings.layers = std::move(layers);
  return settings;
}

/// The numbers of AAMA, all used for something else.
const LayerNames kSwapped{.cut = "8",
                          .sew = "7",
                          .internal = "14",
                          .grain = "1",
                          .notch = "13",
                          .drill = "4",
                          .turn = "11",
                          .hole = "2"};
const dxf::DxfLayerMap kSwappedMap{
    {"8", DxfRole::kCut},    {"7", DxfRole::kSew},   {"14", DxfRole::kInternal}, {"1", DxfRole::kGrain},
    {"13", DxfRole::kNotch}, {"4", DxfRole::kDrill}, {"11", DxfRole::kTurn},     {"2", DxfRole::kCutout}};

void expect_same_piece(const dxf::DxfDrawing& a, const dxf::DxfDrawing& b) {
  ASSERT_EQ(a.pieces.size(), 1u);
  ASSERT_EQ(b.pieces.size(), 1u);
  const dxf::DxfPiece &p = a.pieces[0], &q = b.pieces[0];
  EXPECT_EQ(p.outline, q.outline);
  EXPECT_EQ(p.holes, q.holes);
  EXPECT_EQ(p.grain, q.grain);
  EXPECT_EQ(p.notches.size(), q.notches.size());
  EXPECT_EQ(p.drills, q.drills);
  EXPECT_EQ(p.turn_points, q.turn_points);
  EXPECT_EQ(p.internals, q.internals);
  EXPECT_EQ(p.on_sew_line, q.on_sew_line);
}

TEST(DxfLayers, SwappedNumbersReadAsTheUsualOnesOnceTheyAreTold) {
  const dxf::DxfDrawing usual = read_trial(drawn({}), in_mm());
  ASSERT_EQ(usual.pieces.size(), 1u);
  const dxf::DxfPiece& piece = usual.pieces[0];
  EXPECT_TRUE(piece.on_sew_line);
  EXPECT_EQ(piece.holes.size(), 1u);
  EXPECT_EQ(piece.notches.size(), 1u);
  EXPECT_EQ(piece.drills.size(), 1u);
  EXPECT_EQ(piece.turn_points.size(), 1u);
  EXPECT_EQ(piece.internals.size(), 1u);
  expect_same_piece(usual, read_trial(drawn(kSwapped), with_layers(kSwappedMap)));
  const Result<dxf::DxfDrawing> untold = dxf::read_dxf(drawn(kSwapped), in_mm());
  EXPECT_TRUE(!untold || untold->pieces[0].outline != piece.outline) << "the map must make the difference";
}

TEST(DxfLayers, NamesOfOnesOwnReadAsTheUsualOnesOnceTheyAreTold) {
  const LayerNames own{"Aussen", "Naht", "Innen", "FL", "K", "B", "E", "L"};
  expect_same_piece(read_trial(drawn({}), in_mm()),
                    read_trial(drawn(own), with_layers({{"Aussen", DxfRole::kCut},
                                                        {"Naht", DxfRole::kSew},
                                                        {"Innen", DxfRole::kInternal},
                                                        {"FL", DxfRole::kGrain},
                                                        {"K", DxfRole::kNotch},
                                                        {"B", DxfRole::kDrill},
                                                        {"E", DxfRole::kTurn},
                                                        {"L", DxfRole::kCutout}})));
}

TEST(DxfLayers, OfNotchesAndGrainLinesAreKnownByTheirNamesWhereOthersGoByShape) {
  for (const auto& [notch, grain] : {std::pair{"TACCHE", "DRITTOFILO"},
                                     std::pair{"NACI\u0118CIA", "46_NITKA"}, std::pair{"Crans", "Droit_fil"},
                                     std::pair{"Knipse", "Fadenlauf"}, std::pair{"notches", "grain line"}}) {
    const std::string arrow = line({100, 206}, {106, 200}, grain) + line({200, 200}, {100, 206}, grain);
    const dxf::DxfDrawing d =
        read_trial(entities(rectangle({0, 0}, 300, 400, "KONTUR") + line({0, 200}, {6, 200}, notch) + arrow +
                            line({50, 100}, {50, 300}, "INNEN")),
                   in_mm());
    ASSERT_EQ(d.pieces.size(), 1u) << notch;
    EXPECT_EQ(d.pieces[0].notches.size(), 1u) << notch;
    EXPECT_EQ(d.pieces[0].internals.size(), 1u) << grain;
    ASSERT_TRUE(d.pieces[0].grain) << grain;
    EXPECT_NEAR(std::abs(d.pieces[0].grain->x), 1, 0.01) << "the line's way and not that of its arrow's head";
    const auto uses = d.layers;
    EXPECT_TRUE(std::any_of(uses.begin(), uses.end(), [&](const dxf::DxfLayerUse& use) {
      return use.name == notch && dxf::read_as(use) == "notch";
    })) << notch;
  }
}

TEST(DxfLayers, ALongLineOnALayerOfMarksIsNoNotch) {
  const dxf::DxfDrawing d = read_trial(
      entities(rectangle({0, 0}, 300, 400, "KONTUR") + line({50, 300}, {200, 300}, "REPERES")), in_mm());
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(d.pieces[0].notches.empty());
  EXPECT_EQ(d.pieces[0].internals.size(), 1u) << "where a pocket lies";
  const dxf::DxfDrawing corner =
      read_trial(entities(rectangle({0, 0}, 300, 400, "KONTUR") + line({50, 300}, {80, 300}, "REPERES") +
                          line({80, 300}, {80, 270}, "REPERES")),
                 in_mm());
  ASSERT_EQ(corner.pieces.size(), 1u);
  EXPECT_TRUE(corner.pieces[0].notches.empty()) << "two short lines that go on as each other are a long one";
  EXPECT_EQ(corner.pieces[0].internals.size(), 1u);
}

TEST(DxfLayers, WhatTellsNothingNewChangesNothing) {
  expect_same_piece(read_trial(drawn({}), in_mm()),
                    read_trial(drawn({}), with_layers({{"1", DxfRole::kCut}, {"14", DxfRole::kSew}})));
}

TEST(DxfLayers, AFoldLineUnfoldsAlsoInADrawingOfFreeLayers) {
  const std::string text = entities(rectangle({0, 0}, 150, 400, "OUT") + line({0, 0}, {0, 400}, "AXIS"));
  EXPECT_FALSE(read_trial(text, in_mm()).pieces[0].unfolded);
  const dxf::DxfDrawing d = read_trial(text, with_layers({{"AXIS", DxfRole::kMirror}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(d.pieces[0].unfolded);
  EXPECT_NEAR(area_of(d.pieces[0]), 2 * 150 * 400, 1e-6);
}

TEST(DxfLayers, AnInternalLineThatIsToldAsSuchIsNoSewLine) {
  const std::string text = entities(rectangle({0, 0}, 300, 400, "1") + rectangle({10, 10}, 280, 380, "8"));
  EXPECT_TRUE(read_trial(text, in_mm()).pieces[0].on_sew_line);
  const dxf::DxfDrawing d = read_trial(text, with_layers({{"8", DxfRole::kInternal}}));
  EXPECT_NEAR(area_of(d.pieces[0]), 300 * 400, 1e-6);
  EXPECT_EQ(d.pieces[0].internals.size(), 1u);
}

TEST(DxfLayers, IgnoredOnesAreLeftOutAndToldOf) {
  const std::string text =
      entities(rectangle({0, 0}, 300, 400, "A") + rectangle({600, 0}, 300, 400, "B") + point({10, 10}, "B") +
               dxf_text::text({700, 100}, "note", "B") + dxf_text::text({100, 100}, "Units: METRIC", "B") +
               dxf_text::text({100, 100}, "Front", "A"));
  EXPECT_EQ(read_trial(text, in_mm()).pieces.size(), 2u);
  const dxf::DxfDrawing d = read_trial(text, with_layers({{"B", DxfRole::kIgnored}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].layer, "A");
  EXPECT_EQ(d.pieces[0].name, "Front");
  std::size_t ignored = 0;
  for (const dxf::DxfEntityGroup& group : d.report.groups)
    if (group.reason.find("ignored") != std::string::npos) ignored += group.lines.size();
  EXPECT_EQ(ignored, 3u) << "outline, point and free text; what states something stays";
}

TEST(DxfLayers, AreListedWithWhatStandsOnThemAndWhatTheyAreReadAs) {
  const dxf::DxfDrawing d =
      read_trial(entities(rectangle({0, 0}, 300, 400, "1") + line({10, 10}, {20, 10}, "X") +
                          line({10, 20}, {20, 20}, "X") + point({100, 100}, "13") +
                          dxf_text::text({100, 100}, "Front", "15")),
                 with_layers({{"X", DxfRole::kGrain}}));
  ASSERT_EQ(d.layers.size(), 4u);
  const auto said = [&](std::size_t i) {
    const dxf::DxfLayerUse& layer = d.layers[i];
    std::string kinds;
    for (const auto& [type, count] : layer.kinds) kinds += " " + std::to_string(count) + " " + type;
    return layer.name + " " + std::string(dxf::read_as(layer)) + kinds + (layer.given ? " given" : "");
  };
  EXPECT_EQ(said(0), "1 cut 1 POLYLINE");
  EXPECT_EQ(said(1), "13 drill 1 POINT");
  EXPECT_EQ(said(2), "15 text 1 TEXT");
  EXPECT_EQ(said(3), "X grain 2 LINE given");
}

TEST(DxfLayers, OfADrawingOfFreeLayersGoByShape) {
  const dxf::DxfDrawing d =
      read_trial(entities(rectangle({0, 0}, 300, 400, "A") + line({10, 10}, {20, 10}, "B")),
                 with_layers({{"B", DxfRole::kGrain}}));
  ASSERT_EQ(d.layers.size(), 2u);
  EXPECT_EQ(dxf::read_as(d.layers[0]), "shape");
  EXPECT_EQ(dxf::read_as(d.layers[1]), "grain");
}

TEST(DxfLayers, AreListedOfAFileWithoutPiecesToo) {
  const std::string text = entities(line({0, 0}, {300, 0}, "1") + rectangle({0, 0}, 300, 400, "5"));
  EXPECT_EQ(dxf::read_dxf(text, in_mm()).error().code, "dxf.open_outline");
  const auto layers = dxf::read_dxf_layers(text, in_mm());
  ASSERT_TRUE(layers) << to_string(layers.error());
  ASSERT_EQ(layers->size(), 2u);
  EXPECT_EQ(dxf::read_as((*layers)[0]), "cut");
  EXPECT_EQ(dxf::read_as((*layers)[1]), "grade");
  EXPECT_TRUE((*layers)[1].drawn);
  const dxf::DxfLayerMap way_out{{"5", DxfRole::kCut}, {"1", DxfRole::kGrain}};
  EXPECT_EQ(read_trial(text, with_layers(way_out)).pieces.size(), 1u);
  EXPECT_EQ(dxf::read_dxf_layers("no dxf").error().code, "dxf.not_dxf");
}

TEST(DxfLayers, MayHelpWhereOutlinesAreWrongAndLinesStandOnSeveral) {
  const auto may_help = [](const std::string& text) {
    return dxf::layers_may_help(text, dxf::read_dxf(text, in_mm()).error());
  };
  EXPECT_TRUE(may_help(entities(line({0, 0}, {300, 0}, "1") + rectangle({0, 0}, 300, 400, "5"))));
  EXPECT_FALSE(may_help(entities(line({0, 0}, {300, 0}, "1"))));
  EXPECT_FALSE(may_help("no dxf"));
}

TEST(DxfLayers, ThatTheFileHasNotAreRefusedWithThoseThatItHas) {
  const Error error = dxf::read_dxf(drawn({}), with_layers({{"41", DxfRole::kCut}})).error();
  EXPECT_EQ(error.code, "dxf.unknown_layer");
  EXPECT_NE(error.message.find("\"14\""), std::string::npos) << error.message;
  const Error none =
      dxf::read_dxf(entities(rectangle({0, 0}, 300, 400, "A")), with_layers({{"A", DxfRole::kNotch}}))
          .error();
  EXPECT_EQ(none.code, "dxf.no_outline");
  EXPECT_NE(none.message.find("Layers are read as told: A as notch."), std::string::npos) << none.message;
}

TEST(DxfLayers, RolesHaveOneWordEach) {
  const std::vector<std::string> words = dxf::given_role_words();
  for (const std::string& word : words) {
    ASSERT_TRUE(dxf::role_named(word)) << word;
    EXPECT_EQ(dxf::role_word(*dxf::role_named(word)), word);
    EXPECT_EQ(std::count(words.begin(), words.end(), word), 1) << word;
  }
  for (int role = 0; role <= int(DxfRole::kIgnored); ++role)
    EXPECT_FALSE(dxf::role_word(DxfRole(role)).empty()) << role;
  EXPECT_EQ(dxf::role_named("saw").error().code, "dxf.unknown_role");
  EXPECT_NE(dxf::role_named("saw").error().message.find("\"sew\""), std::string::npos);
  EXPECT_FALSE(dxf::role_named("repeat")) << "it only follows from a number";
}

}  // namespace
}  // namespace toile
