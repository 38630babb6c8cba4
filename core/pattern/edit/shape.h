#pragma once
// Edits of the curves of one piece: no edge comes or goes. Internal to the edits; each changes `panel` and
// leaves it unspecified after an error.

#include "core/base/result.h"
#include "core/pattern/edit/edit.h"

namespace toile::edit {

Status edit_shape(pattern::Panel& panel, const MovePoint& edit);
Status edit_shape(pattern::Panel& panel, const MoveHandle& edit);
Status edit_shape(pattern::Panel& panel, const InsertPoint& edit);
Status edit_shape(pattern::Panel& panel, const DeletePoint& edit);
Status edit_shape(pattern::Panel& panel, const StraightenEdge& edit);
Status edit_shape(pattern::Panel& panel, const BendEdge& edit);
Status edit_shape(pattern::Panel& panel, const SetEdgeLength& edit);

/// A place on an edge: the curve it is in and the parameter there, or the joint before curve `curve` (t = 0).
struct CurvePlace {
  std::size_t curve = 0;
  double t = 0;
};
/// At a fraction of the edge's length; a joint within 0.01 mm is taken instead. Error: edit.out_of_range when
/// that is an end of the edge, or no number between 0 and 1.
Result<CurvePlace> place_on_edge(const pattern::PanelEdge& edge, double at, const std::string& where);

/// Unit vector of the edge's way about a place, mm from its start; null where it has none.
Vec2 direction_at(const pattern::PanelEdge& edge, double along);

/// The notches of `was` that lay on edges which are other curves now, moved to the like places of `panel`: at
/// the same joint, or as far along the edge.
void carry_notches(const pattern::Panel& was, pattern::Panel& panel);

/// What there is to tell of an edit that changed the outline of this piece, and no more.
EditEffect reshaped(const std::string& piece);

}  // namespace toile::edit
