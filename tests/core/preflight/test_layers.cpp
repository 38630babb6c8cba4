#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/make_panel_meshes.h"
#include "core/preflight/preflight.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

/// Two sheets before a column, at depths z (m), with these layers.
preflight::Findings findings_of(double z0, int layer0, double z1, int layer1) {
  pattern::Pattern pattern;
  pattern.panels = {test::rectangle("shirt", 120, 100), test::rectangle("jacket", 120, 100)};
  pattern.panels[0].layer = layer0;
  pattern.panels[1].layer = layer1;
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  sewing::Assembly assembly = sewing::assemble(meshes,
                                               {sewing::RigidPlacement{{0, 0.1, z0}, {}, false},
                                                sewing::RigidPlacement{{0, 0.1, z1}, {}, false}},
                                               {})
                                  .value();
  const std::vector<body::Body> bodies{test::column(0.07, 0, 0.3)};
  return preflight::run_preflight({pattern, meshes, bodies, 0.02}, assembly);
}

const preflight::Finding* layer_finding(const preflight::Findings& findings) {
  const auto found = std::find_if(findings.begin(), findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kLayerInside;
  });
  return found == findings.end() ? nullptr : &*found;
}

TEST(Layers, AHigherLayerThatStartsNearerToTheBodyIsToldWithBothPieces) {
  const preflight::Findings findings = findings_of(0.11, 0, 0.09, 1);
  const preflight::Finding* f = layer_finding(findings);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->severity, preflight::Severity::kWarning);
  EXPECT_EQ(preflight::where_text(*f), "piece jacket");
  EXPECT_NE(f->message.find("shirt"), std::string::npos);
  EXPECT_NEAR(f->place.z, 0.09, 1e-3);
}

TEST(Layers, AHigherLayerFartherOutIsAsItShouldBe) {
  EXPECT_EQ(layer_finding(findings_of(0.09, 0, 0.11, 1)), nullptr);
  EXPECT_EQ(layer_finding(findings_of(0.11, 3, 0.09, 2)), nullptr);
}

TEST(Layers, PiecesOfOneLayerMayStandAsTheyLike) {
  EXPECT_EQ(layer_finding(findings_of(0.11, 1, 0.09, 1)), nullptr);
}

TEST(Layers, PiecesOnDifferentSidesOfTheBodyAreNotCompared) {
  EXPECT_EQ(layer_finding(findings_of(0.09, 0, -0.09, 1)), nullptr);
}

}  // namespace
}  // namespace toile
