#include "core/pattern/edit/pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/edit/places.h"

namespace toile::edit {
namespace {

EditEffect on(const std::string& piece, bool reshaped) {
  EditEffect effect;
  effect.piece = effect.was = piece;
  effect.reshaped = reshaped;
  return effect;
}

void move_loop(pattern::Loop& loop, const PieceMotion& motion) {
  for (pattern::PanelEdge& edge : loop.edges)
    for (pattern::CubicBezier& c : edge.curves)
      for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) *p = moved(*p, motion);
}

/// All that has a place on the piece. Mirrored loops are run the other way, so that they wind as before.
void move_panel(pattern::Panel& panel, const PieceMotion& motion) {
  move_loop(panel.outline, motion);
  for (pattern::Loop& hole : panel.holes) move_loop(hole, motion);
  for (pattern::InnerLine& line : panel.lines)
    for (Vec2& p : line.points) p = moved(p, motion);
  for (pattern::Notch& notch : panel.notches) notch.at = moved(notch.at, motion);
  if (!motion.middle) return;
  panel.outline = pattern::reversed(panel.outline);
  for (pattern::Loop& hole : panel.holes) hole = pattern::reversed(hole);
  panel.grain.x = 0 - panel.grain.x;  // no negative null
  for (pattern::Notch& notch : panel.notches) notch.inwards.x = 0 - notch.inwards.x;
}

/// The upright middle line of the outline's box.
double middle_of(const pattern::Panel& panel) {
  constexpr double kFlat = 0.02;  // mm
  const std::vector<Vec2> outline = pattern::flatten(panel.outline, kFlat);
  const auto [low, high] =
      std::minmax_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  return (low->x + high->x) / 2;
}

/// Where reversing the loops has put each edge.
std::vector<Index> reversed_places(const pattern::Panel& panel) {
  std::vector<Index> places;
  const auto add = [&](const pattern::Loop& loop) {
    const auto first = Index(places.size()), n = Index(loop.edges.size());
    for (Index e = 0; e < n; ++e) places.push_back(first + (n - e) % n);
  };
  add(panel.outline);
  for (const pattern::Loop& hole : panel.holes) add(hole);
  return places;
}

/// Seams keep their threads when a piece is turned over: its edges run the other way.
void turn_seams(pattern::Pattern& pattern, Index panel, const std::vector<Index>& places) {
  const auto turn = [&](pattern::SeamEdge& item) {
    if (item.panel != panel) return;
    item = {panel, places[std::size_t(item.edge)], !item.reversed, 1 - item.to, 1 - item.from};
  };
  for (pattern::Seam& seam : pattern.seams) {
    std::for_each(seam.a.begin(), seam.a.end(), turn);
    std::for_each(seam.b.begin(), seam.b.end(), turn);
  }
}

Result<std::vector<pattern::SeamEdge>> series_of(const pattern::Pattern& pattern,
                                                 const std::vector<NamedSeamEdge>& given) {
  std::vector<pattern::SeamEdge> series;
  for (const NamedSeamEdge& item : given) {
    const Index panel = TRY(find_piece(pattern, item.piece));
    const EdgePlace edge = TRY(find_edge(pattern.panels[std::size_t(panel)], item.edge));
    series.push_back({panel, edge.index, item.reversed, item.from, item.to});
  }
  return series;
}

void forget_panel(std::vector<pattern::SeamEdge>& series, Index panel) {
  std::erase_if(series, [&](const pattern::SeamEdge& item) { return item.panel == panel; });
  for (pattern::SeamEdge& item : series) item.panel -= item.panel > panel ? 1 : 0;
}

}  // namespace

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MirrorPiece& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel& panel = pattern.panels[std::size_t(at)];
  EditEffect effect = on(edit.piece, true);
  effect.motion = PieceMotion{middle_of(panel), {}};
  move_panel(panel, *effect.motion);
  turn_seams(pattern, at, reversed_places(panel));
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RotateGrain& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  if (!(std::abs(edit.angle) <= 360)) {
    return Error{"edit.out_of_range", "An angle is -360 to 360 degrees.", piece_text(edit.piece)};
  }
  Vec2& grain = pattern.panels[std::size_t(at)].grain;
  const double c = std::cos(radians_from_degrees(edit.angle)), s = std::sin(radians_from_degrees(edit.angle));
  grain = normalized(Vec2{c * grain.x - s * grain.y, s * grain.x + c * grain.y});
  return on(edit.piece, false);
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddLine& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern.panels[std::size_t(at)].lines.push_back(edit.line);
  return on(edit.piece, false);
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveLine& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  const auto same = [&](const pattern::InnerLine& line) { return line.id == edit.line; };
  if (std::erase_if(pattern.panels[std::size_t(at)].lines, same) == 0) {
    return Error{"edit.unknown_line", "The piece has no line of that name.",
                 piece_text(edit.piece) + ", line " + edit.line};
  }
  EditEffect effect = on(edit.piece, false);
  effect.parts = {{edit.line, {}}};
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MovePiece& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  EditEffect effect = on(edit.piece, true);
  effect.motion = PieceMotion{std::nullopt, edit.by};
  move_panel(pattern.panels[std::size_t(at)], *effect.motion);
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RenamePiece& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern.panels[std::size_t(at)].id = edit.to;
  EditEffect effect = on(edit.to, false);
  effect.was = edit.piece;
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const DuplicatePiece& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel copy = pattern.panels[std::size_t(at)];
  copy.id = edit.id;
  EditEffect effect = on(edit.id, true);
  effect.was.clear();
  effect.copy_of = edit.piece;
  effect.motion = PieceMotion{edit.mirrored ? std::optional(middle_of(copy)) : std::nullopt, edit.by};
  move_panel(copy, *effect.motion);
  pattern.panels.push_back(std::move(copy));
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const DeletePiece& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  if (pattern.panels.size() == 1) {
    return Error{"edit.last_piece", "A pattern keeps at least one piece.", piece_text(edit.piece)};
  }
  for (pattern::Seam& seam : pattern.seams) {
    forget_panel(seam.a, at);
    forget_panel(seam.b, at);
  }
  std::erase_if(pattern.seams, [](const pattern::Seam& seam) { return seam.a.empty() || seam.b.empty(); });
  pattern.panels.erase(pattern.panels.begin() + at);
  EditEffect effect;
  effect.was = edit.piece;
  return effect;
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const SetFabric& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern.panels[std::size_t(at)].fabric = edit.fabric;
  return on(edit.piece, false);
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddSeam& edit) {
  std::vector<pattern::SeamEdge> a = TRY(series_of(pattern, edit.a));
  std::vector<pattern::SeamEdge> b = TRY(series_of(pattern, edit.b));
  pattern.seams.push_back({edit.id, std::move(a), std::move(b), edit.same_direction});
  return EditEffect{};
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveSeam& edit) {
  const std::size_t at = TRY(find_seam(pattern, edit.seam));
  pattern.seams.erase(pattern.seams.begin() + std::ptrdiff_t(at));
  return EditEffect{};
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const ReverseSeam& edit) {
  const std::size_t at = TRY(find_seam(pattern, edit.seam));
  pattern::Seam& seam = pattern.seams[at];
  seam.same_direction = !seam.same_direction;
  return EditEffect{};
}

}  // namespace toile::edit
