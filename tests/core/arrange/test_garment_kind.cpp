// What a garment is by its borders, and which of two pieces is its front, where no name says it.

#include "core/arrange/garment_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/arrange/flat_layout.h"
#include "core/arrange/layout_measures.h"
#include "core/arrange/piece_cover.h"
#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using arrange::Cover;

constexpr double kWaist = 0.7;  // m

Cover cover_of(const pattern::Pattern& pattern) {
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
  arrange::cover_unnamed(graph, {}, kWaist);
  return graph.pieces.front().cover;
}

void forget_names(pattern::Pattern& pattern) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) pattern.panels[p].id = "p" + std::to_string(p);
}

/// Two half rings sewn along their straight sides: a skirt or a poncho, as wide as the hole is. mm.
pattern::Pattern ring_of_two(double hole) {
  const std::vector<Vec2> half{{-hole / 4 - 400, 0}, {hole / 4 + 400, 0}, {hole / 4, 400}, {-hole / 4, 400}};
  pattern::Pattern pattern;
  pattern.panels = {test::polygon("p0", half), test::polygon("p1", half)};
  pattern.seams = {test::seam("left", {{0, 1}}, {{1, 3}}), test::seam("right", {{0, 3}}, {{1, 1}})};
  return pattern;
}

TEST(GarmentKind, ATubeThatTheWaistFitsIsASkirtAndANarrowerOneGoesOverTheHead) {
  EXPECT_EQ(cover_of(ring_of_two(720)), Cover::kSkirt);
  EXPECT_EQ(cover_of(ring_of_two(560)), Cover::kTorso);
}

TEST(GarmentKind, AWaistAndTwoLegsAreTrousersAndAnOpenFrontIsNone) {
  pattern::Pattern trousers = test::trousers(), vest = test::collared_vest();
  forget_names(trousers);
  EXPECT_EQ(cover_of(trousers), Cover::kLeg);
  vest.panels.resize(3);  // two fronts and a back: without a collar nothing says that it is a top
  vest.seams.resize(4);
  forget_names(vest);
  EXPECT_EQ(cover_of(vest), Cover::kTorso);
}

TEST(GarmentKind, NamesGoBeforeBorders) {
  pattern::Pattern pattern = ring_of_two(560);
  pattern.panels[0].id = "skirt_front";
  EXPECT_EQ(cover_of(pattern), Cover::kSkirt);
  pattern = ring_of_two(720);
  pattern.panels[1].id = "poncho_back";
  EXPECT_EQ(cover_of(pattern), Cover::kTorso);
  EXPECT_EQ(arrange::cover_of_name("Hoodie Front"), Cover::kTorso);
  EXPECT_EQ(arrange::cover_of_name("Hood Side"), Cover::kHood);
  EXPECT_EQ(arrange::cover_of_name("HEM BAND"), Cover::kWaistband);
  EXPECT_EQ(arrange::cover_of_name("RIB SLEEVE"), Cover::kCuff) << "closes about the wrist";
  EXPECT_EQ(arrange::cover_of_name("Neck rib"), Cover::kCollar);
}

/// Two bodies that differ in their necks alone, and in how long they are below; the first is the deeper one's
/// number.
arrange::FlatLayout laid_out(int deeper, double longer, std::vector<std::string> names) {
  pattern::Pattern pattern = test::shirt(names[0], names[1]);
  pattern.panels.resize(2);
  pattern.seams.resize(4);
  const auto body = [&](Index p, double neck, double hem) {
    pattern.panels[static_cast<std::size_t>(p)] =
        test::polygon(names[static_cast<std::size_t>(p)], {{-260, hem},
                                                           {260, hem},
                                                           {260, 340},
                                                           {205, 560},
                                                           {80, 590},
                                                           {0, neck},
                                                           {-80, 590},
                                                           {-205, 560},
                                                           {-260, 340}});
  };
  body(0, deeper == 0 ? 490 : 570, deeper == 0 ? 0 : -longer);
  body(1, deeper == 1 ? 490 : 570, deeper == 1 ? 0 : -longer);
  pattern.seams = {test::seam("side_left", {{0, 1}}, {{1, 8}}), test::seam("side_right", {{0, 8}}, {{1, 1}}),
                   test::seam("shoulder_left", {{0, 3}}, {{1, 6}}),
                   test::seam("shoulder_right", {{0, 6}}, {{1, 3}})};
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
  return arrange::lay_out_trunk(graph, {0, 1});
}

TEST(LayOutTrunk, WithoutNamesTheDeeperNeckIsInFrontEvenOfTheSmallerPiece) {
  for (const int deeper : {0, 1})
    for (const double longer : {-20.0, 20.0}) {
      const arrange::FlatLayout layout = laid_out(deeper, longer, {"p0", "p1"});
      EXPECT_EQ(layout.face[static_cast<std::size_t>(deeper)], 1) << deeper << " " << longer;
      EXPECT_EQ(layout.face[static_cast<std::size_t>(1 - deeper)], -1) << deeper << " " << longer;
    }
}

TEST(LayOutTrunk, ADeepBackIsBehindWhereNamesSayIt) {
  const arrange::FlatLayout layout = laid_out(1, 20, {"front", "back"});
  EXPECT_EQ(layout.face[0], 1);
  EXPECT_EQ(layout.face[1], -1);
}

TEST(GarmentKind, StripsThatMeetAlongOneLongEdgeAreNotSewnAround) {
  pattern::Pattern bands;
  for (const char* name : {"p0", "p1"})
    bands.panels.push_back(test::polygon(name, {{0, 0}, {940, 0}, {940, 30}, {0, 30}}));
  const auto around = [&] {
    const mesh::PanelMeshes meshes = mesh::make_panel_meshes(bands, 0.02, {}).value();
    return arrange::sewn_around(arrange::make_garment_graph(bands, meshes), 0, 1);
  };
  for (const bool aslant : {false, true}) {
    if (aslant)
      for (pattern::Panel& band : bands.panels) band = garments::turned(band, 0.6);
    bands.seams = {test::seam("middle", {{0, 0}}, {{1, 0}})};
    EXPECT_FALSE(around()) << "the bands of two fronts";
    bands.seams.push_back(test::seam("other", {{0, 2}}, {{1, 2}}));
    EXPECT_TRUE(around()) << "a hose";
  }
}

TEST(LayOutTrunk, HalvesOfABandSayNothingOfHands) {
  // One may be sewn to the other's leg, and would turn the whole inside out.
  arrange::GarmentGraph graph;
  graph.pieces.resize(2);
  graph.pieces[0].cover = Cover::kWaistband;
  graph.pieces[1].cover = Cover::kLeg;
  graph.pieces[0].hand = graph.pieces[1].hand = 1;
  graph.pieces[0].centroid = {-0.3, 0};
  graph.pieces[1].centroid = {0.2, 0};
  arrange::FlatLayout layout;
  layout.face = {1, 1};
  layout.pose.resize(2);
  EXPECT_DOUBLE_EQ(arrange::hands_right(graph, layout), 0.2);
}

TEST(GarmentKind, AHandThatAllNamesTellIsNone) {
  const auto hands = [](std::array<const char*, 3> names) {
    pattern::Pattern pattern = ring_of_two(300);
    pattern.panels.push_back(test::polygon("p2", {{0, 0}, {200, 0}, {200, 300}, {0, 300}}));
    for (std::size_t p = 0; p < names.size(); ++p) pattern.panels[p].id = names[p];
    const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
    std::array<int, 3> told{};
    const arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
    for (std::size_t p = 0; p < told.size(); ++p) told[p] = graph.pieces[p].hand;
    return told;
  };
  EXPECT_EQ(hands({"Front_L", "Back_L", "Sleeve_L"}), (std::array<int, 3>{0, 0, 0})) << "a size";
  EXPECT_EQ(hands({"Front", "Back", "Sleeve_L"}), (std::array<int, 3>{0, 0, 1}));
}

TEST(GarmentKind, AYokeMayBeTheHips) {
  pattern::Pattern pattern = ring_of_two(720);
  pattern.panels[0].id = "yoke_p0";
  EXPECT_EQ(cover_of(pattern), Cover::kSkirt) << "its borders tell";
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
  arrange::cover_unnamed(graph, {"yoke interlining"}, kWaist);
  EXPECT_EQ(graph.pieces[0].cover, Cover::kSkirt) << "nor does one that is left out make it a top";
  pattern.panels[1].id = "bodice";
  EXPECT_EQ(cover_of(pattern), Cover::kTorso);
}

}  // namespace
}  // namespace toile
