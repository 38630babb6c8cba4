#include "core/pattern/seams/piece_up.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/own_mirror.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// The grain, or, where the cloth lies on the bias, the middle of the piece.
Vec2 grain_or_middle(const pattern::Panel& panel) {
  constexpr double kAlong = 0.94, kAcross = 0.34;  // cosines: of 20 and 70 degrees
  const Vec2 grain = normalized(panel.grain);
  Vec2 middle = grain;
  for (const Vec2 axis : pattern::mirror_axes(panel.outline)) {
    const double along = dot(axis, grain);
    if (std::abs(along) > kAlong) return grain;
    if (std::abs(along) > kAcross) middle = along > 0 ? axis : -axis;
  }
  return middle;
}

/// From start to end of the straighter of two edges, mm.
Vec2 chord_of_straight(const pattern::Panel& panel) {
  const auto chord = [&](std::size_t e) {
    const std::vector<pattern::CubicBezier>& curves = panel.outline.edges[e].curves;
    return curves.back().p3 - curves.front().p0;
  };
  const auto bow = [&](std::size_t e) {
    return pattern::arc_length(panel.outline.edges[e]) / length(chord(e));
  };
  return chord(bow(0) < bow(1) ? 0 : 1);
}

/// A cuff with round ends: all that has no corner is one edge, and the straight one is sewn on.
bool is_rounded(const pattern::Panel& panel) { return panel.outline.edges.size() == 2; }

/// That direction, or against it: the lower edge of a shaped band, towards the hip or the shoulders, is
/// longer than its upper one.
Vec2 from_longer_edge(const pattern::Panel& panel, Vec2 way) {
  constexpr double kShaped = 0.97;  // of the longer edge
  if (panel.outline.edges.size() != 4) return way;
  const auto length = [&](std::size_t e) { return pattern::arc_length(panel.outline.edges[e]); };
  const std::size_t along = length(0) + length(2) > length(1) + length(3) ? 0 : 1;
  const std::size_t longer = length(along) > length(along + 2) ? along : along + 2,
                    shorter = 2 * along + 2 - longer;
  if (length(shorter) > kShaped * length(longer)) return way;
  const auto middle = [&](std::size_t e) {
    return pattern::point_at_length(panel.outline.edges[e], length(e) / 2);
  };
  return dot(middle(shorter) - middle(longer), way) < 0 ? -way : way;
}

/// The direction that is up when the piece is worn, as far as it tells: mostly along its grain, but bands,
/// cuffs and collars are often cut with the grain along them, and then go around a limb all the same.
Vec2 up_of(const pattern::Panel& panel, PieceKind kind) {
  constexpr double kStrip = 2.5;  // times as long as wide
  constexpr double kHand = 160;   // mm, of a rib that a grown-up's hand passes
  const Vec2 grain = normalized(panel.grain), across = perpendicular(grain);
  if (kind != PieceKind::kBand && kind != PieceKind::kCuff) return grain_or_middle(panel);
  if (kind == PieceKind::kCuff && is_rounded(panel))
    return -perpendicular(normalized(chord_of_straight(panel)));
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const pattern::PanelEdge& edge : panel.outline.edges) {
    const Vec2 p = edge.curves.front().p0;
    const double at[2] = {dot(p, grain), dot(p, across)};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  if (kind == PieceKind::kCuff) {  // a hand has to pass it
    const double tall = high[0] - low[0], wide = high[1] - low[1];
    const bool tight = wide < kHand && tall >= kHand && tall < 2 * kHand;
    return wide < kPairWeights.least_ring_mm || tight ? across : grain;
  }
  return from_longer_edge(panel, high[0] - low[0] > kStrip * (high[1] - low[1]) ? across : grain);
}

/// Of a yoke over both shoulders, whose grain often runs across the back: from the edge that the back hangs
/// from, the longest, to the neck in its middle. The grain where it is not its own mirror image across that.
Vec2 up_of_yoke(const pattern::Panel& panel) {
  constexpr double kAcross = 0.9;  // cosine
  const Vec2 grain = normalized(panel.grain);
  const auto longer = [](const pattern::PanelEdge& a, const pattern::PanelEdge& b) {
    return pattern::arc_length(a) < pattern::arc_length(b);
  };
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const pattern::PanelEdge& lower = *std::max_element(edges.begin(), edges.end(), longer);
  const Vec2 up = normalized(perpendicular(lower.curves.back().p3 - lower.curves.front().p0));
  for (const Vec2 axis : pattern::mirror_axes(panel.outline))
    if (std::abs(dot(axis, up)) > kAcross && std::abs(dot(axis, grain)) < 1 - kAcross)
      return dot(axis, up) > 0 ? axis : -axis;
  return grain_or_middle(panel);
}

/// Of a band that is folded: its fold lies above a waist and around a neck, below where it ends a limb or a
/// top.
std::optional<Vec2> up_from_fold(const pattern::Panel& panel, const PieceWords& words) {
  const bool ends = words.kind == PieceKind::kCuff || words.hem_band;
  if (!ends && words.kind != PieceKind::kBand && words.kind != PieceKind::kCollar) return std::nullopt;
  for (const pattern::PanelEdge& edge : panel.outline.edges) {
    if (edge.id != pattern::kFoldEdge) continue;
    const Vec2 inwards = normalized(perpendicular(edge.curves.back().p3 - edge.curves.front().p0));
    return ends ? inwards : -inwards;
  }
  return std::nullopt;
}

}  // namespace

Vec2 up_of_piece(const pattern::Panel& panel, const PieceWords& words) {
  const bool half_cuff = words.kind == PieceKind::kCuff && words.face != 0;
  const bool strip = panel.outline.edges.size() == 4;  // a collar's stand has a shape
  const bool neckband = words.stand && words.kind == PieceKind::kCollar && strip;
  const bool band = words.hem_band || neckband;
  const bool over_shoulders = words.yoke && words.face == 0;
  if (over_shoulders) return up_of_yoke(panel);
  if (const std::optional<Vec2> from_fold = up_from_fold(panel, words)) return *from_fold;
  return up_of(panel, band ? PieceKind::kBand : half_cuff ? PieceKind::kOther : words.kind);
}

}  // namespace toile::seams
