#include "core/exports/map_file.h"

#include "tests/core/exports/two_panels.h"
#include "tests/proto/schemas/kept_schema.h"

namespace toile::exports {
namespace {

std::vector<analysis::ClothMap> two_maps() {
  return {{analysis::MapKind::kWarp, {0, 1.5F, -0.25F, 3, 4, 5, 6, 7}},
          {analysis::MapKind::kPressure, std::vector<float>(8, 0.125F)}};
}

TEST(MapFile, ComesBackAsItWasWritten) {
  const TwoPanels t = two_panels();
  const std::string text = write_maps(t.garment, t.names, two_maps());
  EXPECT_NE(text.find(R"("id": "back", "first_vertex": 4, "vertex_count": 4)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("unit": "kPa")"), std::string::npos) << text;
  const auto maps = parse_maps(text);
  ASSERT_TRUE(maps) << to_string(maps.error());
  EXPECT_EQ(*maps, two_maps());
}

TEST(MapFile, WhatIsDamagedIsToldWithItsPlace) {
  const TwoPanels t = two_panels();
  const std::string whole = write_maps(t.garment, t.names, two_maps());
  EXPECT_EQ(parse_maps(whole.substr(0, whole.size() / 2)).error().code, "map.damaged");
  std::string other = whole;
  other.replace(other.find("\"warp\""), 6, "\"work\"");
  EXPECT_EQ(parse_maps(other).error().where, "/maps/0/map");
  std::string shorter = whole;
  shorter.replace(shorter.find("0.125, "), 7, "");
  EXPECT_EQ(parse_maps(shorter).error().where, "/maps/1/values");
}

TEST(MapSchema, IsKeptAsTheFieldsSayIt) { test::expect_kept("maps.schema.json", map_schema()); }

}  // namespace
}  // namespace toile::exports
