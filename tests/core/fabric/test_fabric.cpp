// Fabric files and the library that they make.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "core/base/text.h"
#include "core/fabric/card.h"
#include "core/fabric/library.h"
#include "core/fabric/schema.h"
#include "tests/proto/schemas/kept_schema.h"

namespace toile {
namespace {

constexpr const char* kCard = R"({
  "toile_fabric": 1, "name": "cloth", "title": "Cloth", "fibre": "cotton", "construction": "woven",
  "weave": "plain", "areal_mass_g_m2": 150, "thickness_mm": 0.3,
  "bend_warp_un_m": 12, "bend_weft_un_m": 8, "bend_bias_un_m": 9,
  "stretch_warp": [{"strain_percent": 4, "tension_n_m": 80}, {"strain_percent": 6, "tension_n_m": 490}],
  "stretch_weft": [{"strain_percent": 5, "tension_n_m": 50}],
  "stretch_coupling_n_m": 100, "stretch_shear_n_m": 90, "limit_shear_rad": 0.3, "friction": 0.3,
  "colour": [0.5, 0.6, 0.7],
  "sources": [
    {"of": ["areal_mass_g_m2", "thickness_mm", "friction"], "source": "a balance"},
    {"of": ["bend_warp_un_m", "bend_weft_un_m", "bend_bias_un_m", "stretch_warp", "stretch_weft",
            "stretch_coupling_n_m", "stretch_shear_n_m", "limit_shear_rad"], "estimated_from": "others"}
  ]
})";

std::string with(std::string from, const std::string& to) {
  std::string text = kCard;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string code_of(const std::string& text) {
  const Result<fabric::FabricCard> card = fabric::parse_fabric(text);
  return card ? "read" : card.error().code;
}

TEST(Fabric, SchemaIsKeptAsTheFieldsSayIt) {
  test::expect_kept("fabric.schema.json", fabric::fabric_schema());
}

TEST(Fabric, ACardReadsBackAsItIsWritten) {
  const Result<fabric::FabricCard> card = fabric::parse_fabric(kCard);
  ASSERT_TRUE(card) << to_string(card.error());
  const Result<fabric::FabricCard> again = fabric::parse_fabric(fabric::write_fabric(*card));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(*card, *again);
}

TEST(Fabric, FiguresComeInTheSolversUnits) {
  const material::Fabric cloth = fabric::fabric_of(*fabric::parse_fabric(kCard));
  EXPECT_DOUBLE_EQ(cloth.areal_mass, 0.15);
  EXPECT_DOUBLE_EQ(cloth.thickness, 0.3e-3);
  EXPECT_DOUBLE_EQ(cloth.bend_warp, 12e-6);
  EXPECT_DOUBLE_EQ(cloth.stretch_warp, 2000);
  EXPECT_DOUBLE_EQ(cloth.stretch_weft, 1000);
  EXPECT_NEAR(cloth.limit_warp, 0.04, 1e-12) << "where the curve bends";
  EXPECT_EQ(cloth.limit_weft, 0) << "a straight line never gets stiffer";
  EXPECT_DOUBLE_EQ(cloth.limit_shear, 0.3);
}

TEST(Fabric, TheLimitOfARoundCurveIsWhereItsFirstAndItsLastLineMeet) {
  const fabric::StretchLaw law = fabric::stretch_law({{10, 10}, {20, 40}, {30, 140}});
  EXPECT_DOUBLE_EQ(law.stiffness, 100);
  EXPECT_NEAR(100 * law.limit, 140 - 1000 * (0.3 - law.limit), 1e-9);
}

TEST(Fabric, WhatIsWrongInAFileIsTold) {
  EXPECT_EQ(code_of(kCard), "read");
  EXPECT_EQ(code_of("[]"), "project.wrong_type");
  EXPECT_EQ(code_of(with("\"friction\": 0.3", "\"friction\": 3")), "project.out_of_range");
  EXPECT_EQ(code_of(with(", \"friction\": 0.3", "")), "project.missing_key");
  EXPECT_EQ(code_of(with("\"woven\"", "\"wooven\"")), "project.unknown_value");
  EXPECT_EQ(code_of(with("\"tension_n_m\": 490", "\"tension_n_m\": 80")), "fabric.curve");
  EXPECT_EQ(code_of(with("\"stretch_coupling_n_m\": 100", "\"stretch_coupling_n_m\": 1500")),
            "fabric.unstable");
  EXPECT_EQ(code_of(with("\"thickness_mm\", \"friction\"]", "\"thickness_mm\"]")), "fabric.source");
  EXPECT_EQ(code_of(with("\"thickness_mm\", \"friction\"]", "\"friction\", \"friction\"]")), "fabric.source");
  EXPECT_EQ(code_of(with("\"thickness_mm\", \"friction\"]", "\"thickness_mm\", \"friction\", \"taste\"]")),
            "fabric.source");
  EXPECT_EQ(
      code_of(with("\"source\": \"a balance\"", "\"source\": \"a balance\", \"estimated_from\": \"x\"")),
      "project.two_ways");
}

TEST(FabricLibrary, EveryFileOfTheFolderIsAFabricOfItsName) {
  std::set<std::string> files;
  const std::filesystem::path folder = std::filesystem::path(TOILE_SOURCE_DIR) / "fabrics";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path().stem());
  std::set<std::string> built;
  for (const fabric::FabricFile& file : fabric::fabric_files()) {
    const Result<fabric::FabricCard> card = fabric::parse_fabric(file.text);
    ASSERT_TRUE(card) << file.name << ": " << to_string(card.error());
    EXPECT_EQ(card->name, file.name);
    EXPECT_TRUE(built.insert(card->name).second) << card->name << " stands twice";
    EXPECT_EQ(card->name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos);
  }
  EXPECT_EQ(files, built);
}

TEST(FabricLibrary, EveryFabricCanBeSolved) {
  for (const fabric::FabricCard& card : fabric::library()) {
    const material::Fabric cloth = fabric::fabric_of(card);
    EXPECT_GT(cloth.stretch_warp * cloth.stretch_weft, cloth.stretch_coupling * cloth.stretch_coupling)
        << card.name;
    EXPECT_GT(4 * cloth.bend_bias, cloth.bend_warp + cloth.bend_weft)
        << card.name << ": the twist's rigidity is not positive";
  }
}

/// Bending lengths of apparel lie between those of a limp knit and of a stiff felt, whatever the mass.
TEST(FabricLibrary, BendingLengthsAreThoseOfCloth) {
  for (const fabric::FabricCard& card : fabric::library()) {
    const material::Fabric cloth = fabric::fabric_of(card);
    for (const double rigidity : {cloth.bend_warp, cloth.bend_weft, cloth.bend_bias}) {
      const double length = fabric::bending_length(rigidity, cloth.areal_mass);
      EXPECT_GT(length, 0.010) << card.name;
      EXPECT_LT(length, 0.045) << card.name;
    }
  }
}

TEST(FabricLibrary, ANameThatNothingBearsIsToldWithTheNearest) {
  ASSERT_TRUE(fabric::named("single-jersey", ""));
  const Result<const fabric::FabricCard*> other = fabric::named("singel-jersey", "/pieces/2/fabric");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, "project.unknown_fabric");
  EXPECT_EQ(other.error().where, "/pieces/2/fabric");
  EXPECT_NE(other.error().message.find("\"single-jersey\"?"), std::string::npos) << other.error().message;
}

}  // namespace
}  // namespace toile
