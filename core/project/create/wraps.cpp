#include "core/project/create/wraps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/pattern/curve.h"
#include "core/pattern/own_mirror.h"
#include "core/pattern/seams/garment_words.h"
#include "core/project/create/drawn_lines.h"
#include "core/project/create/halves.h"

namespace toile::create {
namespace {

constexpr double kLap[] = {60, 260};         // mm that fronts lie over each other, from the middle
constexpr double kAlongGrain = 0.98;         // cosine
constexpr double kShort = 25;                // mm that the line may end before neck or hem
constexpr double kHalfBack[] = {0.82, 1.2};  // times half a back is wide what stays of the front …
constexpr double kTooWide = 1.25;            // … and the whole of it

/// Half as wide as the garment's back of that kind, mm; 0 where there is none.
double half_back(std::span<const pattern::Panel> panels, const std::vector<seams::PieceWords>& words,
                 seams::PieceKind kind) {
  double half = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    if (words[p].face >= 0 || words[p].kind != kind || words[p].layer || words[p].yoke) continue;
    const double width = width_of(panels[p]);
    half = std::max(half, pattern::is_own_mirror(panels[p].outline) ? width / 2 : width);
  }
  return half;
}

/// The front up to that line; nothing where it is no middle of one that is half a back wide from there on.
std::optional<Wrap> wrap_along(const pattern::Panel& front, const std::vector<Vec2>& line, double half) {
  const std::optional<Chord> chord = chord_across(line, pattern::flatten(front.outline, 0.1), kShort);
  if (!chord) return std::nullopt;
  const Vec2 along = normalized(chord->to - chord->from);
  if (std::abs(dot(along, normalized(front.grain))) < kAlongGrain) return std::nullopt;
  const std::optional<PartedPiece> parted = parted_along(front, *chord);
  if (!parted) return std::nullopt;
  const Wrap wrap{kNone, parted->line, breadth_of(parted->smaller, parted->line)};
  const double stays = breadth_of(parted->larger, parted->line) / half;
  if (wrap.long_as < kLap[0] || wrap.long_as > kLap[1] || stays < kHalfBack[0] || stays > kHalfBack[1] ||
      width_of(front) < kTooWide * half)
    return std::nullopt;
  return wrap;
}

}  // namespace

std::vector<Wrap> wraps(std::span<const pattern::Panel> panels, std::span<const char> pairs) {
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  std::vector<Wrap> found;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const seams::PieceWords& told = words[p];
    const bool upper = told.kind == seams::PieceKind::kTorso || told.kind == seams::PieceKind::kSkirt;
    if (!pairs[p] || told.face <= 0 || !upper || told.layer || told.flank) continue;
    const double half = half_back(panels, words, told.kind);
    if (half == 0) continue;
    std::optional<Wrap> best;
    for (const pattern::InnerLine& line : panels[p].lines) {
      const std::optional<Wrap> wrap = line.drawn ? wrap_along(panels[p], line.points, half) : std::nullopt;
      if (wrap && (!best || wrap->long_as > best->long_as)) best = wrap;  // the edge of a facing lies outside
    }
    if (!best) continue;
    best->panel = static_cast<Index>(p);
    found.push_back(*best);
  }
  return found;
}

}  // namespace toile::create
