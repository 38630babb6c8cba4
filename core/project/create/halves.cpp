#include "core/project/create/halves.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::create {
namespace {

constexpr double kLeastShare = 0.25;  // of the largest piece: smaller ones may be of one side alone

/// mm: fronts and backs that are no wider together go around no grown person, since the chests of the
/// smallest adults measure 76 cm (EN 13402-3). Halves for chests up to some 140 cm are narrower.
constexpr double kNarrow = 750;

bool is_pair(const dxf::DxfPiece& piece) { return piece.mirrored > 0 && piece.quantity > 1; }

bool is_single(const dxf::DxfPiece& piece) {
  return piece.quantity == 1 && piece.mirrored == 0 && !piece.unfolded;
}

/// Whether the garment's pieces are told once and cut twice, as far as they are no layers.
bool told_as_pairs(const dxf::DxfDrawing& drawing) {
  int pairs = 0, single = 0;
  for (const dxf::DxfPiece& piece : drawing.pieces)
    if (!seams::words_of(piece.name).layer) ++(is_pair(piece) ? pairs : single);
  return pairs >= 2 && pairs >= single;
}

/// Whether the file tells of no piece how often it is cut, or on which side it is worn.
bool tells_nothing(const dxf::DxfDrawing& drawing) {
  return std::none_of(drawing.pieces.begin(), drawing.pieces.end(), [](const dxf::DxfPiece& piece) {
    return piece.counted || piece.unfolded || seams::words_of(piece.name).side != 0;
  });
}

/// Fronts and backs of the trunk, by their names.
bool is_trunk(const seams::PieceWords& words) {
  return words.face != 0 && words.side == 0 && !words.layer && !words.limb;
}

/// Whether the trunk's pieces are all halves.
bool drawn_by_halves(const seams::SeamModel& model, std::span<const pattern::Panel> panels) {
  double width = 0;
  bool front = false, back = false;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const seams::PieceWords& words = model.words[p];
    if (!is_trunk(words)) continue;
    if (model.twin[p] != kNone) return false;
    (words.face > 0 ? front : back) = true;
    width += width_of(panels[p]);
  }
  return front && back && width <= kNarrow;
}

std::vector<Twice> where_nothing_is_told(const seams::SeamModel& model,
                                         std::span<const pattern::Panel> panels) {
  const bool halves = drawn_by_halves(model, panels);
  std::vector<Twice> twice;
  for (Index p = 0; p < static_cast<Index>(panels.size()); ++p) {
    const bool alone = model.twin[p] == kNone, symmetric = model.twin[p] == p;
    const bool limb = model.words[p].limb && (alone || symmetric);
    twice.push_back(limb ? Twice::kLimb : halves && alone ? Twice::kDrawnHalf : Twice::kNo);
  }
  return twice;
}

std::vector<Twice> among_pairs(const dxf::DxfDrawing& drawing, const seams::SeamModel& model,
                               std::span<const pattern::Panel> panels) {
  double largest = 0;
  const auto area = [&](std::size_t p) { return std::abs(pattern::signed_area(panels[p].outline)); };
  for (std::size_t p = 0; p < panels.size(); ++p) largest = std::max(largest, area(p));
  std::vector<Twice> twice;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const bool half = is_trunk(seams::words_of(drawing.pieces[p].name)) && is_single(drawing.pieces[p]) &&
                      model.twin[p] == kNone && area(p) > kLeastShare * largest;
    twice.push_back(half ? Twice::kForgottenHalf : Twice::kNo);
  }
  return twice;
}

}  // namespace

double width_of(const pattern::Panel& panel) {
  const Vec2 up = normalized(panel.grain);
  double low = 1e30, high = -1e30;
  for (const Vec2 p : pattern::flatten(panel.outline, 1)) {
    low = std::min(low, cross(up, p));
    high = std::max(high, cross(up, p));
  }
  return high - low;
}

std::vector<Twice> taken_twice(const dxf::DxfDrawing& drawing, std::span<const pattern::Panel> panels) {
  const bool pairs = told_as_pairs(drawing);
  if (!pairs && !tells_nothing(drawing)) return std::vector<Twice>(panels.size(), Twice::kNo);
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const seams::SeamModel model = seams::make_seam_model(pattern);
  return pairs ? among_pairs(drawing, model, panels) : where_nothing_is_told(model, panels);
}

}  // namespace toile::create
