#include "core/pattern/edit/edit.h"

#include <type_traits>

#include "core/pattern/edit/edges.h"
#include "core/pattern/edit/notches.h"
#include "core/pattern/edit/pieces.h"
#include "core/pattern/edit/places.h"
#include "core/pattern/edit/shape.h"
#include "core/pattern/validate.h"

namespace toile::edit {
namespace {

/// The edits that edit_shape, edit_edges and edit_piece know.
template <typename Edit>
concept ShapesCurves = requires(pattern::Panel& panel, const Edit& edit) {
  edit_shape(panel, edit);
};
template <typename Edit>
concept ChangesEdges = requires(pattern::Pattern& pattern, const Edit& edit) {
  edit_edges(pattern, Index{}, edit);
};

template <ShapesCurves Edit>
Result<EditEffect> edit_pattern(pattern::Pattern& pattern, const Edit& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel& panel = pattern.panels[std::size_t(at)];
  const pattern::Panel was = panel;
  TRY(edit_shape(panel, edit));
  carry_notches(was, panel);
  return reshaped(edit.piece);
}

template <ChangesEdges Edit>
Result<EditEffect> edit_pattern(pattern::Pattern& pattern, const Edit& edit) {
  Result<Index> at = Index{};
  if constexpr (std::is_same_v<Edit, RemoveDart>) {
    at = piece_of_dart(pattern, edit);
  } else {
    at = find_piece(pattern, edit.piece);
  }
  if (!at) return at.error();
  EditEffect effect = reshaped(pattern.panels[std::size_t(*at)].id);
  RenamedParts parts = TRY(edit_edges(pattern, *at, edit));
  effect.parts = std::move(parts);
  return effect;
}

template <typename Edit>
requires(!ShapesCurves<Edit> &&
         !ChangesEdges<Edit>) Result<EditEffect> edit_pattern(pattern::Pattern& pattern, const Edit& edit) {
  return edit_piece(pattern, edit);
}

}  // namespace

Vec2 moved(Vec2 p, const PieceMotion& motion) {
  if (motion.middle) p.x = *motion.middle * 2 - p.x;
  return p + motion.by;
}

Result<EditedPattern> apply_edit(const pattern::Pattern& pattern, const PatternEdit& edit) {
  EditedPattern out{pattern, {}};
  out.effect = TRY(std::visit([&](const auto& one) { return edit_pattern(out.pattern, one); }, edit));
  TRY(pattern::validate(out.pattern));
  return out;
}

}  // namespace toile::edit
