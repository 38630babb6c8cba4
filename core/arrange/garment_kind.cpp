#include "core/arrange/garment_kind.h"

#include <algorithm>

#include "core/arrange/piece_cover.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::arrange {

namespace {

/// Of the waist's girth, what a skirt's upper edge measures at least: knits are cut smaller than the body.
constexpr double kLeastWaist = 0.85;
/// Of both legs' openings, what the waist of trousers measures at most, a fly that is open included.
constexpr double kMostWaist = 1.8;

/// Times its breadth, that a strip is long.
constexpr double kStripAspect = 12;
constexpr double kLongerThanNeck = 0.9;  ///< m

/// What the names tell of all pieces without a name; kUnknown where they tell nothing.
Cover cover_by_names(const GarmentGraph& graph, const std::vector<std::string>& absent) {
  bool any[9] = {};
  for (const std::string& name : absent)  // a yoke may be the hips'
    if (!seams::words_of(name).yoke) any[static_cast<int>(cover_of_name(name))] = true;
  for (const GarmentPiece& p : graph.pieces) any[static_cast<int>(p.cover)] = true;
  const auto has = [&](Cover c) { return any[static_cast<int>(c)]; };
  if (has(Cover::kTorso) || has(Cover::kSleeve) || has(Cover::kCollar) || has(Cover::kHood))
    return Cover::kTorso;
  if (has(Cover::kLeg)) return Cover::kLeg;
  return has(Cover::kSkirt) ? Cover::kSkirt : Cover::kUnknown;
}

/// Whether a piece is a strip that goes around the neck and down the fronts, a collar by its name or nothing:
/// longer than a neck, and sewn to fronts and backs alike.
bool is_front_band(const GarmentGraph& graph, Index p) {
  const GarmentPiece& piece = graph.pieces[p];
  const Vec2 size = bounding_box(piece.outline).size();
  if ((piece.cover != Cover::kUnknown && piece.cover != Cover::kCollar) || piece.tube) return false;
  if (std::max(size.x, size.y) < std::max(kLongerThanNeck, kStripAspect * std::min(size.x, size.y)))
    return false;
  bool front = false, back = false;
  for (const GarmentTie& t : graph.ties) {
    if (t.a == t.b || (t.a != p && t.b != p)) continue;
    const int face = graph.pieces[t.a == p ? t.b : t.a].face;
    front = front || face > 0;
    back = back || face < 0;
  }
  return front && back;
}

}  // namespace

Cover cover_by_borders(std::span<const double> borders, double waist) {
  if (borders.size() == 2 && borders[1] > kLeastWaist * waist) return Cover::kSkirt;
  if (borders.size() == 3 && borders[0] < kMostWaist * (borders[1] + borders[2])) return Cover::kLeg;
  return Cover::kTorso;
}

void cover_unnamed(GarmentGraph& graph, const std::vector<std::string>& absent, double waist) {
  Cover rest = cover_by_names(graph, absent);
  if (rest == Cover::kUnknown) rest = cover_by_borders(graph.borders, waist);
  for (Index p = 0; rest == Cover::kTorso && p < static_cast<Index>(graph.pieces.size()); ++p) {
    if (!is_front_band(graph, p)) continue;
    graph.pieces[p].cover = Cover::kCollar;
    graph.pieces[p].face = 0;
    graph.pieces[p].edging = true;
  }
  double largest = 0;
  for (const GarmentPiece& p : graph.pieces) largest = std::max(largest, p.area);
  for (GarmentPiece& p : graph.pieces) {
    if (p.cover != Cover::kUnknown) continue;
    // A piece of a top that closes around a limb by itself is a sleeve.
    p.cover = rest == Cover::kTorso && p.tube && p.area < 0.6 * largest ? Cover::kSleeve : rest;
  }
}

}  // namespace toile::arrange
