// Seams of parts of edges, and of many edges on both sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/make_panel_meshes.h"
#include "core/mesh/resample.h"
#include "core/pattern/curve.h"

namespace toile {
namespace {

pattern::Panel rectangle(const std::string& id, double width, double height) {
  const Vec2 c[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  pattern::Panel panel;
  panel.id = id;
  for (int i = 0; i < 4; ++i)
    panel.outline.edges.push_back({"e" + std::to_string(i), {pattern::line_segment(c[i], c[(i + 1) % 4])}});
  return panel;
}

Vec2 point(const mesh::SampledPattern& s, const mesh::EdgeSample& e) {
  return s.edges[e.panel][e.edge][e.sample];
}

TEST(SeamRanges, PairThePointsOfThePartsAlone) {
  pattern::Pattern p;
  p.panels = {rectangle("long", 300, 100), rectangle("short", 100, 100)};
  p.seams = {{"s", {{0, 0, false, 0.2, 0.6}}, {{1, 2}}, false}};  // 120 mm to 100 mm
  const auto sampled = mesh::resample(p, 0.010);
  ASSERT_TRUE(sampled.ok()) << to_string(sampled.error());
  const mesh::SampledSeam& seam = sampled->seams[0];
  EXPECT_NEAR(seam.length_a, 0.12, 1e-12);
  EXPECT_NEAR(seam.length_b, 0.10, 1e-12);
  ASSERT_EQ(seam.pairs.size(), 13u) << "as many as the longer side asks for";
  EXPECT_NEAR(point(*sampled, seam.pairs.front().a).x, 0.06, 1e-12);
  EXPECT_NEAR(point(*sampled, seam.pairs.back().a).x, 0.18, 1e-12);
  EXPECT_NEAR(point(*sampled, seam.pairs.front().b).x, 0.0, 1e-12) << "the outlines run against each other";
  const auto& edge = sampled->edges[0][0];
  for (std::size_t k = 1; k < edge.size(); ++k) EXPECT_NEAR(edge[k].x - edge[k - 1].x, 0.01, 2e-3) << k;
  EXPECT_TRUE(mesh::make_panel_meshes(p, 0.010, {}).ok());
}

TEST(SeamRanges, ShareAnEdgeBetweenTwoSeamsInAnyOrder) {
  pattern::Pattern p;
  p.panels = {rectangle("long", 200, 100), rectangle("b", 80, 100), rectangle("c", 120, 100)};
  p.seams = {{"second", {{0, 0, true, 0.4, 1}}, {{2, 2, true}}, false},
             {"first", {{0, 0, false, 0, 0.4}}, {{1, 2}}, false}};
  const auto sampled = mesh::resample(p, 0.010);
  ASSERT_TRUE(sampled.ok()) << to_string(sampled.error());
  ASSERT_EQ(sampled->edges[0][0].size(), 21u);
  for (const mesh::SampledSeam& seam : sampled->seams) {
    const double from = seam.length_a < 0.1 ? 0 : 0.08;
    for (const auto& pair : seam.pairs) {
      const double along = point(*sampled, pair.a).x - from;
      EXPECT_NEAR(point(*sampled, pair.b).x,
                  seam.length_b - (seam.length_a < 0.1 ? seam.length_a - along : seam.length_a - along),
                  1e-9);
    }
  }
  p.seams[1].a[0].to = 0.5;
  const auto twice = mesh::resample(p, 0.010);
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, "mesh.seam_edge");
}

TEST(SeamRanges, GiveManyToManyTheSameCountOnBothSidesEvenly) {
  // Three edges of 70, 110 and 90 mm, gathered to two of 60 and 50 mm.
  pattern::Pattern p;
  p.panels = {rectangle("p0", 70, 50), rectangle("p1", 110, 50), rectangle("p2", 90, 50),
              rectangle("q0", 60, 50), rectangle("q1", 50, 50)};
  p.seams = {{"gather", {{0, 0}, {1, 0}, {2, 0}}, {{4, 0}, {3, 0}}, false}};
  const double distance = 0.008;
  const auto sampled = mesh::resample(p, distance);
  ASSERT_TRUE(sampled.ok()) << to_string(sampled.error());
  const mesh::SampledSeam& seam = sampled->seams[0];
  EXPECT_NEAR(seam.length_a / seam.length_b, 270.0 / 110, 1e-9);
  // Every point of either side is in a pair, and the steps of the longer side keep the asked distance.
  for (const Index panel : {0, 1, 2, 3, 4}) {
    const auto& edge = sampled->edges[panel][0];
    for (Index k = 0; k < static_cast<Index>(edge.size()); ++k) {
      EXPECT_TRUE(std::any_of(seam.pairs.begin(), seam.pairs.end(),
                              [&](const auto& pair) {
                                return (pair.a.panel == panel && pair.a.sample == k) ||
                                       (pair.b.panel == panel && pair.b.sample == k);
                              }))
          << panel << " " << k;
    }
    const double even = panel < 3 ? distance : distance * 110 / 270;
    for (std::size_t k = 1; k < edge.size(); ++k)
      EXPECT_NEAR((edge[k].x - edge[k - 1].x) / even, 1, 0.25) << panel;
  }
}

TEST(SeamRanges, SewADartOfOneEdgeToItself) {
  pattern::Pattern p;
  p.panels = {rectangle("piece", 200, 100)};
  p.seams = {{"fold", {{0, 0, false, 0.1, 0.5}}, {{0, 0, false, 0.5, 0.9}}, false}};
  const auto meshes = mesh::make_panel_meshes(p, 0.010, {});
  ASSERT_TRUE(meshes.ok()) << to_string(meshes.error());
  EXPECT_EQ(meshes->seams[0].pairs.size(), 8u) << "the fold's own point has no partner";
}

}  // namespace
}  // namespace toile
