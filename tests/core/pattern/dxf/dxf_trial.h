#pragma once
// Reading small drawings in tests, and asking what came of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "tests/core/pattern/dxf/dxf_text.h"

namespace toile::dxf_text {

/// The drawing; a failure when it cannot be read, or when its report leaves anything out.
inline dxf::DxfDrawing read_trial(const std::string& text, const dxf::DxfSettings& settings = {}) {
  Result<dxf::DxfDrawing> drawing = dxf::read_dxf(text, settings);
  if (!drawing) {
    ADD_FAILURE() << to_string(drawing.error());
    return {};
  }
  const dxf::DxfReport& r = drawing->report;
  EXPECT_EQ(r.records, r.structure + r.elsewhere + r.vertices + r.entities);
  EXPECT_EQ(r.entities, r.kept + r.converted + r.dropped);
  std::size_t listed = 0;
  for (const dxf::DxfEntityGroup& g : r.groups) {
    listed += g.lines.size();
    EXPECT_NE(g.reason, "nothing is made of it") << g.type << " on layer " << g.layer;
  }
  EXPECT_EQ(listed, r.entities);
  return *drawing;
}

/// Whether a warning or the reason of any entity has these words.
inline bool told(const dxf::DxfDrawing& drawing, const std::string& words) {
  const auto has = [&](const std::string& text) { return text.find(words) != std::string::npos; };
  return std::any_of(drawing.notes.begin(), drawing.notes.end(), has) ||
         std::any_of(drawing.report.groups.begin(), drawing.report.groups.end(),
                     [&](const dxf::DxfEntityGroup& g) { return has(g.reason); });
}

inline double area_of(const dxf::DxfPiece& piece) { return std::abs(geometry::signed_area(piece.outline)); }

/// The panel; a failure when the piece makes none.
inline pattern::Panel panel_of(const dxf::DxfPiece& piece) {
  const Result<pattern::Panel> panel = dxf::panel_from_piece(piece);
  EXPECT_TRUE(panel) << (panel ? "" : to_string(panel.error()));
  return panel ? *panel : pattern::Panel{};
}

inline std::string point(Vec2 at, const std::string& layer) {
  return groups({{0, "POINT"}, {8, layer}, {10, number(at.x)}, {20, number(at.y)}});
}

/// One block of a piece, as pattern systems write it.
inline std::string piece_block(const std::string& name, const std::string& body) { return block(name, body); }

inline std::string blocks_and_inserts(std::initializer_list<std::pair<std::string, std::string>> list,
                                      const std::string& more = "") {
  std::string blocks, inserts;
  for (const auto& [name, body] : list) {
    blocks += piece_block(name, body);
    inserts += insert(name, {0, 0});
  }
  return section("BLOCKS", blocks) + entities(inserts + more);
}

}  // namespace toile::dxf_text
