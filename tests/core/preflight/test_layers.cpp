#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/make_panel_meshes.h"
#include "core/preflight/preflight.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

/// Two sheets before a column, at depths z (m), with these layers.
Findings findings_of(double z0, int layer0, double z1, int layer1) {
  Pattern pattern;
  pattern.panels = {test::rectangle("shirt", 120, 100), test::rectangle("jacket", 120, 100)};
  pattern.panels[0].layer = layer0;
  pattern.panels[1].layer = layer1;
  const PanelMeshes meshes = make_panel_meshes(pattern, 0.02, {}).value();
  Assembly assembly =
      assemble(meshes, {RigidPlacement{{0, 0.1, z0}, {}, false}, RigidPlacement{{0, 0.1, z1}, {}, false}}, {})
          .value();
  const std::vector<Body> bodies{test::column(0.07, 0, 0.3)};
  return run_preflight({pattern, meshes, bodies, 0.02}, assembly);
}

const Finding* layer_finding(const Findings& findings) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [](const Finding& f) { return f.kind == FindingKind::kLayerInside; });
  return found == findings.end() ? nullptr : &*found;
}

TEST(Layers, AHigherLayerThatStartsNearerToTheBodyIsToldWithBothPieces) {
  const Findings findings = findings_of(0.11, 0, 0.09, 1);
  const Finding* f = layer_finding(findings);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->severity, Severity::kWarning);
  EXPECT_EQ(where_text(*f), "piece jacket");
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
