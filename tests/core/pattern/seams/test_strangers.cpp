// Pieces that nothing tells of are sewn after those that names tell, and take none of their edges.

#include "core/pattern/seams/strangers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/pattern/seams/model.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::strip;

/// A shirt with a strip that is as long as its front's hem.
std::vector<pattern::Panel> shirt_with(const std::string& trim) {
  std::vector<pattern::Panel> panels = garments::shirt().panels;
  panels.push_back(strip(trim, garments::length_of(panels[0], 0), 40));
  return panels;
}

TEST(Strangers, ASmallPieceOfNoKnownNameComesLastAndTakesNoHem) {
  const std::vector<pattern::Panel> panels = shirt_with("Zwirbel");
  EXPECT_EQ(seams::sewn_last({panels, {}}), (std::vector<char>{0, 0, 0, 0, 1}));
  const test::WornSeams worn(panels);
  EXPECT_FALSE(worn.takes("front.e0") || worn.takes("back.e0")) << worn.text();
  EXPECT_TRUE(worn.takes("sleeve_r.e2") && worn.takes("front.e1")) << worn.text();
}

TEST(Strangers, WhatANameTellsOfIsNone) {
  EXPECT_EQ(seams::sewn_last({shirt_with("hem band"), {}}), (std::vector<char>{0, 0, 0, 0, 0}));
  EXPECT_EQ(seams::sewn_last({shirt_with("button band"), {}}), (std::vector<char>{0, 0, 0, 0, 0}));
  EXPECT_EQ(seams::sewn_last({shirt_with("front facing"), {}}), (std::vector<char>{0, 0, 0, 0, 1}))
      << "but a layer comes last, too";
}

TEST(Strangers, WhereNoNameTellsAFrontAndABackNobodyIs) {
  std::vector<pattern::Panel> panels = shirt_with("5");
  for (std::size_t p = 0; p < panels.size(); ++p) panels[p].id = std::to_string(p + 1);
  EXPECT_EQ(seams::sewn_last({panels, {}}), (std::vector<char>{0, 0, 0, 0, 0}));
}

TEST(Strangers, ALargePieceIsPartOfTheShellWhateverItIsCalled) {
  std::vector<pattern::Panel> panels = shirt_with("Zwirbel");
  panels.back() = strip("Zwirbel", 500, 300);
  EXPECT_EQ(seams::sewn_last({panels, {}}), (std::vector<char>{0, 0, 0, 0, 0}));
}

TEST(NamedLayers, AWordBesideSeveralPiecesNamesOfTheirFormTellsOfLayers) {
  // As interlinings in a language that no table has.
  std::vector<pattern::Panel> panels = garments::shirt().panels;
  panels.push_back(strip("collar", 400, 60));
  panels.push_back(strip("cuff", 220, 60));
  panels.push_back(strip("Zwirbel collar", 380, 45));
  panels.push_back(strip("cuff zwirbel", 220, 60));
  const auto layers = [&] {
    std::vector<char> found;
    for (const seams::PieceWords& w : seams::make_seam_model({panels, {}}).words) found.push_back(w.layer);
    return found;
  };
  EXPECT_EQ(layers(), (std::vector<char>{0, 0, 0, 0, 0, 0, 1, 1}));
  panels.back().id = "cuff brosel";
  EXPECT_EQ(layers(), (std::vector<char>(8, 0))) << "one alone may be another version of a piece";
  panels.back() = strip("cuff zwirbel", 80, 60);
  EXPECT_EQ(layers(), (std::vector<char>(8, 0))) << "nor where the second has another form";
}

}  // namespace
}  // namespace toile
