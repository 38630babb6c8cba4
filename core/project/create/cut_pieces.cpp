#include "core/project/create/cut_pieces.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/names.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/upper_ends.h"
#include "core/pattern/validate.h"
#include "core/project/create/drawn_darts.h"
#include "core/project/create/fold_lines.h"
#include "core/project/create/pocket_corners.h"
#include "core/project/create/underlaps.h"
#include "core/project/create/wraps.h"

namespace toile::create {
namespace {

Result<pattern::Panel> panel_of(const dxf::DxfPiece& drawn) {
  pattern::Panel panel = TRY(dxf::panel_from_piece(drawn));
  panel.id = drawn.name;
  if (drawn.grain) panel.grain = *drawn.grain;
  TRY(pattern::validate(panel));
  return panel;
}

/// Darts that are only drawn are cut out, each where the piece can be cut so.
void cut_darts(CutPieces& cut) {
  for (std::size_t p = 0; p < cut.panels.size(); ++p) {
    int darts = 0;
    for (const DrawnDart& dart : drawn_darts(cut.panels[p])) {
      pattern::Panel with = with_dart(cut.panels[p], dart);
      if (!pattern::validate(with)) continue;
      cut.panels[p] = std::move(with);
      cut.filled[p] = 1;
      ++darts;
    }
    if (darts > 0)
      cut.drawing.notes.push_back("piece " + in_quotes(cut.panels[p].id) + " has " +
                                  (darts == 1 ? "a dart" : std::to_string(darts) + " darts") +
                                  " drawn within its outline: the cloth between the lines is sewn away");
  }
}

/// What is folded back is cut off, each where the piece can be cut so.
void fold_back(CutPieces& cut) {
  pattern::Pattern pattern;
  pattern.panels = cut.panels;
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  for (std::size_t p = 0; p < cut.panels.size(); ++p) {
    const std::optional<FoldLine> fold = fold_line(cut.panels[p], words[p]);
    if (!fold) continue;
    pattern::Panel rest = folded(cut.panels[p], *fold);
    if (!pattern::validate(rest)) continue;
    cut.panels[p] = std::move(rest);
    cut.filled[p] = 1;
    cut.drawing.notes.push_back(
        "piece " + in_quotes(cut.panels[p].id) +
        " is folded along a line that is drawn across it: what is folded back is cut off");
  }
}

void cut_underlap(CutPieces& cut, const Underlap& underlap) {
  pattern::Panel& band = cut.panels[underlap.panel];
  std::optional<pattern::Panel> rest = without_underlap(band, underlap);
  if (!rest || !pattern::validate(*rest)) return;
  band = std::move(*rest);
  cut.filled[underlap.panel] = 1;
  cut.drawing.notes.push_back("piece " + in_quotes(band.id) + " lies under its other end, or half, by " +
                              std::to_string(std::lround(underlap.long_as)) +
                              " mm where it is closed: they are cut off");
}

/// Fronts that lie over each other end in their middles, and so does the band above them.
void cut_wraps(CutPieces& cut) {
  std::vector<char> pairs;
  for (const dxf::DxfPiece& piece : cut.drawing.pieces)
    pairs.push_back(piece.quantity == 2 && piece.mirrored == 1);
  bool any = false;
  for (const Wrap& wrap : wraps(cut.panels, pairs)) {
    pattern::Panel rest = folded(cut.panels[wrap.panel], wrap.middle);
    if (!pattern::validate(rest)) continue;
    cut.panels[wrap.panel] = std::move(rest);
    cut.filled[wrap.panel] = 1;
    any = true;
    cut.drawing.notes.push_back("piece " + in_quotes(cut.panels[wrap.panel].id) +
                                " lies over the other front by " + std::to_string(std::lround(wrap.long_as)) +
                                " mm beyond the middle: they are cut off, and the fronts meet there");
  }
  if (!any) return;
  for (const Underlap& end : wrapped_ends(cut.panels)) cut_underlap(cut, end);
}

void fill_pockets(CutPieces& cut) {
  for (const PocketCorner& pocket : pocket_corners(cut.panels)) {
    pattern::Panel whole = with_corner(cut.panels[pocket.panel], pocket);
    if (!pattern::validate(whole)) continue;
    cut.panels[pocket.panel] = std::move(whole);
    cut.filled[pocket.panel] = 1;
    cut.drawing.notes.push_back("piece " + in_quotes(cut.panels[pocket.panel].id) +
                                " is cut away at a pocket between side and waist: it is drawn whole, as the "
                                "pocket's facing fills it");
  }
}

void cut_underlaps(CutPieces& cut) {
  for (const Underlap& underlap : underlaps(cut.panels)) cut_underlap(cut, underlap);
}

}  // namespace

Result<CutPieces> cut_pieces(const dxf::DxfDrawing& drawing) {
  CutPieces cut{drawing, {}, {}};
  cut.drawing.pieces.clear();
  std::optional<Error> first;
  for (const dxf::DxfPiece& drawn : drawing.pieces) {
    Result<pattern::Panel> panel = panel_of(drawn);
    if (!panel) {
      if (!first) first = panel.error();
      cut.drawing.notes.push_back("piece " + in_quotes(drawn.name) +
                                  " cannot be cut and is left out: " + to_string(panel.error()));
      continue;
    }
    cut.drawing.pieces.push_back(drawn);
    cut.panels.push_back(std::move(*panel));
  }
  if (first && cut.panels.empty()) return *first;
  const std::vector<Vec2> up = seams::grains_upwards(cut.panels);
  for (std::size_t p = 0; p < up.size(); ++p) cut.panels[p].grain = up[p];
  cut.filled.assign(cut.panels.size(), 0);
  cut_darts(cut);
  fold_back(cut);
  cut_wraps(cut);
  fill_pockets(cut);
  cut_underlaps(cut);
  return cut;
}

}  // namespace toile::create
