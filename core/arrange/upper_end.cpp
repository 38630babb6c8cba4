#include "core/arrange/upper_end.h"

#include <algorithm>
#include <cmath>

namespace toile::arrange {

namespace {

/// How high on a body a cover is worn.
int level_of(Cover c) {
  switch (c) {
    case Cover::kHood:
      return 6;
    case Cover::kCollar:
      return 5;
    case Cover::kSleeve:
      return 4;
    case Cover::kTorso:
      return 3;
    case Cover::kWaistband:
      return 2;
    case Cover::kSkirt:
    case Cover::kLeg:
      return 1;
    default:
      return 0;
  }
}

double distance_to(Vec2 from, const std::vector<Vec2>& points) {
  double least = HUGE_VAL;
  for (const Vec2 q : points) least = std::min(least, length(q - from));
  return least;
}

/// The way up along a seam between two legs whose stitches lie at `points` from the piece's middle, of the
/// length at which they lie from there: of short and wide legs they lie farther to the side than up. It goes
/// down to the inner leg seam, whose stitches are among `legs`, with the outer one's; without them the way
/// up is the one that leads away from the middle.
Vec2 along_crotch(const std::vector<Vec2>& points, const std::vector<Vec2>& legs) {
  Vec2 low, high, mean;
  for (const Vec2 a : points) {
    mean = mean + a * (1 / static_cast<double>(points.size()));
    for (const Vec2 b : points) {
      if (length(b - a) <= length(high - low)) continue;
      low = a;
      high = b;
    }
  }
  const Vec2 chord = high - low;
  if (length(chord) == 0) return mean;
  const bool upside_down =
      legs.empty() ? dot(chord, mean) < 0 : distance_to(high, legs) < distance_to(low, legs);
  return chord * ((upside_down ? -1 : 1) * length(mean) / length(chord));
}

}  // namespace

Vec2 upper_end(const GarmentGraph& graph, const std::vector<Index>& partner, Index p) {
  const auto piece = [&](Index q) -> const GarmentPiece& { return graph.pieces[q]; };
  const Vec2 up = piece(p).grain * 1e-3;
  std::vector<Vec2> crotch, legs;  // from the middle: legs hang together at their upper ends
  std::size_t count = 0;
  Vec2 sum;
  for (const GarmentTie& tie : graph.ties) {
    if (tie.a == tie.b || (tie.a != p && tie.b != p)) continue;
    const Index other = tie.a == p ? tie.b : tie.a;
    if (piece(other).edging) continue;
    const Vec2 at = (tie.a == p ? tie.at_a : tie.at_b) - piece(p).centroid;
    const int sign = level_of(piece(other).cover) - level_of(piece(p).cover);
    if (sign == 0 && piece(p).cover == Cover::kLeg) (partner[p] == other ? crotch : legs).push_back(at);
    if (sign == 0) continue;
    sum = sum + at * (sign > 0 ? 1.0 : -1.0);
    ++count;
  }
  sum = sum + along_crotch(crotch, legs) * static_cast<double>(crotch.size());
  count += crotch.size();
  return count > 0 ? up + sum * (1 / static_cast<double>(count)) : up;
}

}  // namespace toile::arrange
