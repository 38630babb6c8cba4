#include "core/project/create/halves.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::create {
namespace {

constexpr double kLeastShare = 0.25;  // of the largest piece: smaller ones may be of one side alone

bool is_pair(const dxf::DxfPiece& piece) { return piece.mirrored > 0 && piece.quantity > 1; }

/// Whether the garment's pieces are told once and cut twice, as far as they are no layers.
bool told_as_pairs(const dxf::DxfDrawing& drawing) {
  int pairs = 0, single = 0;
  for (const dxf::DxfPiece& piece : drawing.pieces)
    if (!seams::words_of(piece.name).layer) ++(is_pair(piece) ? pairs : single);
  return pairs >= 2 && pairs >= single;
}

}  // namespace

std::vector<char> forgotten_halves(const dxf::DxfDrawing& drawing, std::span<const pattern::Panel> panels) {
  std::vector<char> halves(panels.size(), 0);
  if (!told_as_pairs(drawing)) return halves;
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const seams::SeamModel model = seams::make_seam_model(pattern);
  double largest = 0;
  const auto area = [&](std::size_t p) { return std::abs(pattern::signed_area(panels[p].outline)); };
  for (std::size_t p = 0; p < panels.size(); ++p) largest = std::max(largest, area(p));
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const dxf::DxfPiece& piece = drawing.pieces[p];
    const seams::PieceWords words = seams::words_of(piece.name);
    const bool trunk = words.face != 0 && words.side == 0 && !words.layer && !words.limb;
    halves[p] = trunk && piece.quantity == 1 && piece.mirrored == 0 && !piece.unfolded &&
                model.twin[p] == kNone && area(p) > kLeastShare * largest;
  }
  return halves;
}

}  // namespace toile::create
