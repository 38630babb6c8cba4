#include "core/arrange/layout_measures.h"

#include <algorithm>
#include <cmath>

#include "core/base/aabb.h"

namespace toile::arrange {

FlatLayout empty_layout(std::size_t count) {
  return {std::vector<FlatMove>(count), std::vector<int>(count, 0), std::vector<Index>(count, kNone)};
}

namespace {

/// Whether it is of one hand and no seam joins it to the other: how far it lies from the middle nobody can
/// tell before what is nearer lies there.
bool is_aside(const GarmentGraph& graph, Index p) {
  const int hand = graph.pieces[p].hand;
  if (hand == 0) return false;
  return std::none_of(graph.ties.begin(), graph.ties.end(), [&](const GarmentTie& tie) {
    if (tie.a != p && tie.b != p) return false;
    return graph.pieces[tie.a == p ? tie.b : tie.a].hand * hand < 0;
  });
}

/// The highest y of a closed line at x; −∞ where it does not come there.
double top_at(const std::vector<Vec2>& line, double x) {
  double top = -HUGE_VAL;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i], b = line[(i + 1) % line.size()];
    if ((a.x < x) == (b.x < x)) continue;
    top = std::max(top, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  }
  return top;
}

}  // namespace

Index root_of_trunk(const GarmentGraph& graph, const std::vector<Index>& members) {
  const auto merit = [&](Index p) {
    const GarmentPiece& piece = graph.pieces[p];
    double m = piece.area;
    if (piece.face > 0) m *= 10;
    if (piece.face < 0) m *= 0.1;
    if (piece.cover == Cover::kTorso) m *= 100;
    if (is_aside(graph, p)) m *= 0.2;
    return m;
  };
  return *std::max_element(members.begin(), members.end(),
                           [&](Index a, Index b) { return merit(a) < merit(b); });
}

double hands_right(const GarmentGraph& graph, const FlatLayout& layout) {
  double sum = 0;
  for (std::size_t p = 0; p < graph.pieces.size(); ++p) {
    // Halves of a band are so much alike that one may be sewn to the other's leg.
    const bool counts = layout.face[p] != 0 && graph.pieces[p].cover != Cover::kWaistband;
    if (counts) sum += graph.pieces[p].hand * layout.pose[p](graph.pieces[p].centroid).x;
  }
  return sum;
}

double middle_of(const GarmentGraph& graph, Index piece, const FlatMove& pose) {
  double sum = 0;
  int count = 0;
  for (const GarmentTie& tie : graph.ties) {
    if ((tie.a != piece && tie.b != piece) || graph.pieces[tie.a].hand * graph.pieces[tie.b].hand >= 0)
      continue;
    sum += pose(tie.a == piece ? tie.at_a : tie.at_b).x;
    ++count;
  }
  if (count > 0) return sum / count;
  return bounding_box(outline_on_sheet(graph.pieces[piece], pose)).middle().x;
}

void stand_in_the_middle(const GarmentGraph& graph, const std::vector<Index>& members, FlatLayout& layout) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Index p : members) {
    if (layout.partner[p] != kNone) return;
    if (!layout.has(p)) continue;
    for (const Vec2 q : outline_on_sheet(graph.pieces[p], layout.pose[p])) {
      low = std::min(low, q.x);
      high = std::max(high, q.x);
    }
  }
  for (const Index p : members) layout.pose[p].t.x -= (low + high) / 2;
}

double front_is_lower(const GarmentGraph& graph, const FlatLayout& layout) {
  constexpr double kBeside = 0.015;  // m: what lies open in the middle, or meets there, ends beside it
  double sum = 0;
  for (const double x : {-kBeside, kBeside}) {
    double top[2] = {-HUGE_VAL, -HUGE_VAL};  // of fronts, of backs
    for (std::size_t p = 0; p < graph.pieces.size(); ++p) {
      if (layout.face[p] == 0) continue;
      double& most = top[layout.face[p] < 0];
      most = std::max(most, top_at(outline_on_sheet(graph.pieces[p], layout.pose[p]), x));
    }
    if (top[0] == -HUGE_VAL || top[1] == -HUGE_VAL) return 0;
    sum += top[1] - top[0];
  }
  return sum / 2;
}

std::vector<Vec2> outline_on_sheet(const GarmentPiece& piece, const FlatMove& pose) {
  std::vector<Vec2> out;
  out.reserve(piece.outline.size());
  for (const Vec2 p : piece.outline) out.push_back(pose(p));
  return out;
}

}  // namespace toile::arrange
