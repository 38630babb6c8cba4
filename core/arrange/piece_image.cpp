#include "core/arrange/piece_image.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace toile::arrange {

namespace {

constexpr double kSameArea = 0.02;   ///< relative
constexpr double kSameSeams = 1e-3;  ///< m, that another way than the closest must be better by

/// Where a piece is sewn, in its plane, and to which other.
struct SewnPoint {
  Vec2 at;
  Index other = kNone;
};

std::vector<SewnPoint> sewn_points(const GarmentGraph& graph, Index piece) {
  std::vector<SewnPoint> points;
  for (const GarmentTie& tie : graph.ties) {
    if (tie.a == tie.b) continue;
    if (tie.a == piece) points.push_back({tie.at_a, tie.b});
    if (tie.b == piece) points.push_back({tie.at_b, tie.a});
  }
  return points;
}

bool alike(const GarmentPiece& a, const GarmentPiece& b) {
  return a.cover == b.cover && a.face == b.face && std::abs(a.area - b.area) < kSameArea * b.area;
}

/// m, mean way from where the image, laid on the piece, is sewn to where that is sewn to the like; 0 where
/// nothing is alike.
double seams_apart(const GarmentGraph& graph, const std::vector<SewnPoint>& of_image,
                   const std::vector<SewnPoint>& of_piece, const FlatMove& onto) {
  double sum = 0;
  int count = 0;
  for (const SewnPoint& i : of_image) {
    double least = HUGE_VAL;
    for (const SewnPoint& p : of_piece)
      if (alike(graph.pieces[i.other], graph.pieces[p.other]))
        least = std::min(least, length(onto(i.at) - p.at));
    if (least == HUGE_VAL) continue;
    sum += least;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

std::optional<FlatMove> image_on(const GarmentGraph& graph, Index image, Index piece) {
  const GarmentPiece &from = graph.pieces[image], &to = graph.pieces[piece];
  // On one sheet, both right side out or both not, a mirror image is cut as one.
  const std::vector<FlatMove> ways = ways_to_lay_on(from, to, from.outside == to.outside);
  if (ways.size() < 2) return ways.empty() ? std::nullopt : std::optional(ways.front());
  const std::vector<SewnPoint> of_image = sewn_points(graph, image), of_piece = sewn_points(graph, piece);
  const FlatMove* best = &ways.front();
  double least = seams_apart(graph, of_image, of_piece, *best);
  for (const FlatMove& way : ways) {
    const double apart = seams_apart(graph, of_image, of_piece, way);
    if (apart >= least - kSameSeams) continue;
    least = apart;
    best = &way;
  }
  return *best;
}

}  // namespace toile::arrange
