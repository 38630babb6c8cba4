#include "core/project/create/underlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/aabb.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/loop_part.h"
#include "core/pattern/seams/garment_words.h"

namespace toile::create {
namespace {

constexpr double kLeast = 15, kMost = 70;  // mm that a waistband laps over
constexpr double kOnNotch = 2;             // mm, of a notch from where the lap begins
constexpr double kWrap[] = {60, 260};      // mm that a band laps over where fronts do
constexpr double kAlike = 6;               // mm, of the two notches from their ends
constexpr double kLikeBox = 0.98;          // of its box, that a straight band fills

/// A straight band, along its longer sides.
struct Strip {
  Vec2 along;
  double low = 0, high = 0, wide = 0;  ///< mm, of the ends along it, and across
  double long_as() const { return high - low; }
};

Vec2 across(Vec2 along) { return {-along.y, along.x}; }

/// The piece as a strip along one of its edges; nothing where it has other than four or is not straight.
std::optional<Strip> strip_of(const pattern::Panel& panel) {
  if (panel.outline.edges.size() != 4 || !panel.holes.empty()) return std::nullopt;
  const std::vector<Vec2> outline = pattern::flatten(panel.outline, 0.1);
  for (std::size_t e = 0; e < 2; ++e) {
    const pattern::PanelEdge& edge = panel.outline.edges[e];
    const Vec2 along = normalized(edge.curves.back().p3 - edge.curves.front().p0);
    std::vector<Vec2> seen;
    seen.reserve(outline.size());
    for (const Vec2 p : outline) seen.push_back({dot(p, along), dot(p, across(along))});
    const Aabb2 box = bounding_box(seen);
    const Vec2 size = box.high - box.low;
    if (size.x < size.y) continue;
    const bool straight = geometry::signed_area(outline) > kLikeBox * size.x * size.y;
    return straight ? std::optional(Strip{along, box.low.x, box.high.x, size.y}) : std::nullopt;
  }
  return std::nullopt;
}

/// +1 where a notch marks the lap at the strip's far end, −1 at its near end, 0 where none does.
int marked_end(const pattern::Panel& panel, const Strip& strip, double lap) {
  const auto marked = [&](double at) {
    return std::any_of(panel.notches.begin(), panel.notches.end(), [&](const pattern::Notch& notch) {
      return std::abs(dot(notch.at, strip.along) - at) < kOnNotch;
    });
  };
  const bool far = marked(strip.high - lap), near = marked(strip.low + lap);
  return far == near ? 0 : far ? 1 : -1;
}

/// Whether notches lie at the same places seen from either end.
bool same_from_both_ends(const pattern::Panel& panel, const Strip& strip) {
  return std::all_of(panel.notches.begin(), panel.notches.end(), [&](const pattern::Notch& notch) {
    const double other = strip.low + strip.high - dot(notch.at, strip.along);
    return std::any_of(panel.notches.begin(), panel.notches.end(), [&](const pattern::Notch& n) {
      return std::abs(dot(n.at, strip.along) - other) < kOnNotch;
    });
  });
}

/// Of a band that goes all around: what lies beyond the one notch that is so near an end, and has none like
/// it at the other end.
std::optional<Underlap> marked_underlap(const pattern::Panel& panel, const Strip& strip) {
  std::optional<Underlap> found;
  for (const pattern::Notch& notch : panel.notches) {
    const double at = dot(notch.at, strip.along);
    const bool near = at - strip.low < strip.high - at;
    const double lap = near ? at - strip.low : strip.high - at;
    if (lap < kOnNotch) continue;  // at the very end
    if (lap > kMost) continue;
    if (lap < kLeast || marked_end(panel, strip, lap) == 0) return std::nullopt;
    if (found && std::abs(found->long_as - lap) > kOnNotch) return std::nullopt;
    found = Underlap{kNone, lap, near ? -strip.along : strip.along};
  }
  return found;
}

}  // namespace

std::vector<Underlap> underlaps(std::span<const pattern::Panel> panels) {
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  const auto is_half = [&](std::size_t p) {
    return words[p].kind == seams::PieceKind::kBand && words[p].side != 0 && !words[p].layer;
  };
  std::vector<Underlap> found;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    if (words[p].kind == seams::PieceKind::kBand && words[p].side == 0 && !words[p].layer) {
      const std::optional<Strip> strip = strip_of(panels[p]);
      std::optional<Underlap> underlap = strip ? marked_underlap(panels[p], *strip) : std::nullopt;
      if (!underlap) continue;
      underlap->panel = static_cast<Index>(p);
      found.push_back(*underlap);
      continue;
    }
    const std::optional<Strip> longer = is_half(p) ? strip_of(panels[p]) : std::nullopt;
    for (std::size_t q = 0; longer && q < panels.size(); ++q) {
      if (!is_half(q) || words[p].side + words[q].side != 0) continue;
      const std::optional<Strip> shorter = strip_of(panels[q]);
      if (!shorter || std::abs(longer->wide - shorter->wide) > kOnNotch) continue;
      const double lap = longer->long_as() - shorter->long_as();
      if (lap < kLeast || lap > kMost) continue;
      const int end = marked_end(panels[p], *longer, lap);
      if (end == 0 && !same_from_both_ends(panels[p], *longer)) continue;
      found.push_back({static_cast<Index>(p), lap, end < 0 ? -longer->along : longer->along});
      break;
    }
  }
  return found;
}

std::vector<Underlap> wrapped_ends(std::span<const pattern::Panel> panels) {
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  std::vector<Underlap> found;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const bool band = words[p].kind == seams::PieceKind::kBand && words[p].side == 0 && !words[p].layer;
    const std::optional<Strip> strip = band ? strip_of(panels[p]) : std::nullopt;
    if (!strip) continue;
    double low = HUGE_VAL, high = HUGE_VAL;
    for (const pattern::Notch& notch : panels[p].notches) {
      const double at = dot(notch.at, strip->along);
      low = std::min(low, at - strip->low);
      high = std::min(high, strip->high - at);
    }
    if (std::abs(low - high) > kAlike || low < kWrap[0] || low > kWrap[1]) continue;
    found.push_back({static_cast<Index>(p), low, -strip->along});
    found.push_back({static_cast<Index>(p), high, strip->along});
  }
  return found;
}

std::optional<pattern::Panel> without_underlap(const pattern::Panel& band, const Underlap& underlap) {
  const std::vector<Vec2> outline = pattern::flatten(band.outline, 0.1);
  double end = -HUGE_VAL;
  for (const Vec2 p : outline) end = std::max(end, dot(p, underlap.away));
  const double cut = end - underlap.long_as;
  const auto stays = [&](Vec2 p) { return dot(p, underlap.away) < cut; };
  const std::vector<pattern::PanelEdge>& edges = band.outline.edges;
  const std::size_t n = edges.size();
  std::size_t gone = 0;
  while (gone < n && (stays(edges[gone].curves.front().p0) || stays(edges[gone].curves.back().p3))) ++gone;
  if (gone == n) return std::nullopt;
  const pattern::PanelEdge &before = edges[(gone + n - 1) % n], &after = edges[(gone + 1) % n];
  const auto on_cut = [&](Vec2 corner) {
    return corner - (dot(corner, underlap.away) - cut) * underlap.away;
  };
  const Vec2 from = on_cut(after.curves.front().p0), to = on_cut(before.curves.back().p3);
  pattern::Panel rest = band;
  const std::vector<pattern::PanelEdge> left = pattern::edges_between(band.outline, from, to);
  if (left.size() + 1 != n) return std::nullopt;
  for (std::size_t k = 0; k < left.size(); ++k)
    rest.outline.edges[(gone + 1 + k) % n].curves = left[k].curves;
  rest.outline.edges[gone].curves = {
      pattern::line_segment(left.back().curves.back().p3, left.front().curves.front().p0)};
  std::erase_if(rest.notches,
                [&](const pattern::Notch& notch) { return dot(notch.at, underlap.away) > cut - kOnNotch; });
  std::erase_if(rest.lines, [&](const pattern::InnerLine& line) {
    return !std::all_of(line.points.begin(), line.points.end(), stays);
  });
  return rest;
}

}  // namespace toile::create
