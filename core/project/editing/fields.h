#pragma once
// The edits' fields, said once as project_fields.h says the document's, and their names in JSON.

#include <tuple>

#include "core/project/editing/edits.h"
#include "core/project/fields.h"

namespace toile::fields {

inline constexpr Range kFraction{0, 1};
inline constexpr Range kIndex{0, 1e6};

template <typename Visitor, typename Edit>
void describe_edge(Visitor& v, Edit& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("edge", edit.edge, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, MovePoint& edit) {
  describe_edge(v, edit);
  v.field("point", edit.point, Need::kRequired, kIndex);
  v.field("to", edit.to, Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, MoveHandle& edit) {
  describe_edge(v, edit);
  v.field("curve", edit.curve, Need::kRequired, kIndex);
  v.field("handle", edit.handle, Need::kRequired, Range{1, 2});
  v.field("to", edit.to, Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, InsertPoint& edit) {
  describe_edge(v, edit);
  v.field("at", edit.at, Need::kRequired, kFraction);
}

template <typename Visitor>
void describe(Visitor& v, DeletePoint& edit) {
  describe_edge(v, edit);
  v.field("point", edit.point, Need::kRequired, kIndex);
}

template <typename Visitor>
void describe(Visitor& v, SplitEdge& edit) {
  describe_edge(v, edit);
  v.field("at", edit.at, Need::kRequired, kFraction);
  v.field("id", edit.id);
}

template <typename Visitor>
void describe(Visitor& v, JoinEdges& edit) {
  describe_edge(v, edit);
  v.field("next", edit.next, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, StraightenEdge& edit) {
  describe_edge(v, edit);
  v.field("curve", edit.curve, Need::kOptional, Range{-1, kIndex.most});
}

template <typename Visitor>
void describe(Visitor& v, BendEdge& edit) {
  describe_edge(v, edit);
  v.field("curve", edit.curve, Need::kRequired, kIndex);
  v.field("handle1", edit.handle1, Need::kRequired, kLength);
  v.field("handle2", edit.handle2, Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, SetEdgeLength& edit) {
  describe_edge(v, edit);
  v.field("length_mm", edit.length_mm, Need::kRequired, Range{0.1, 1e5});
  v.choice("keep", edit.keep, {"start", "middle", "end"});
}

template <typename Visitor>
void describe(Visitor& v, MirrorPiece& edit) {
  v.field("piece", edit.piece, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, RotateGrain& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("angle", edit.angle, Need::kRequired, Range{-360, 360});
}

template <typename Visitor>
void describe(Visitor& v, AddLine& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("id", edit.line.id, Need::kRequired);
  v.field("points", edit.line.points, Need::kRequired, Range{2, 10000});
  v.field("drawn", edit.line.drawn);
}

template <typename Visitor>
void describe(Visitor& v, RemoveLine& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("line", edit.line, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, AddNotch& edit) {
  describe_edge(v, edit);
  v.field("at", edit.at, Need::kRequired, kFraction);
  v.field("depth_mm", edit.depth_mm, Need::kOptional, Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, MoveNotch& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("notch", edit.notch, Need::kRequired, kIndex);
  v.field("edge", edit.edge, Need::kRequired);
  v.field("at", edit.at, Need::kRequired, kFraction);
  v.field("depth_mm", edit.depth_mm, Need::kOptional, Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, RemoveNotch& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("notch", edit.notch, Need::kRequired, kIndex);
}

template <typename Visitor>
void describe(Visitor& v, AddDart& edit) {
  describe_edge(v, edit);
  v.field("at", edit.at, Need::kRequired, kFraction);
  v.field("width_mm", edit.width_mm, Need::kRequired, Range{1, 1e5});
  v.field("depth_mm", edit.depth_mm, Need::kRequired, Range{1, 1e5});
  v.field("id", edit.id, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, AddInnerDart& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("from", edit.from, Need::kRequired, kLength);
  v.field("to", edit.to, Need::kRequired, kLength);
  v.field("width_mm", edit.width_mm, Need::kRequired, Range{1, 1e5});
  v.field("at", edit.at, Need::kOptional, Range{0.05, 0.95});
  v.field("id", edit.id, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, RenameEdge& edit) {
  describe_edge(v, edit);
  v.field("to", edit.to, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, RemoveDart& edit) {
  v.field("seam", edit.seam, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, DrawnEdge& edge) {
  v.field("id", edge.id, Need::kRequired);
  v.field("points", edge.points, Need::kOptional, Range{2, 100000});
  v.field("curves", edge.curves, Need::kOptional, Range{1, 10000});
  v.exactly_one("points", "curves");
}

template <typename Visitor>
void describe(Visitor& v, AddHole& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("edges", edit.edges, Need::kRequired, kSome);
}

template <typename Visitor>
void describe(Visitor& v, RemoveHole& edit) {
  describe_edge(v, edit);
}

template <typename Visitor>
void describe(Visitor& v, MovePiece& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("by", edit.by, Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, RenamePiece& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("to", edit.to, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, DuplicatePiece& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("id", edit.id, Need::kRequired);
  v.field("by", edit.by, Need::kOptional, kLength);
  v.field("mirrored", edit.mirrored);
}

template <typename Visitor>
void describe(Visitor& v, DeletePiece& edit) {
  v.field("piece", edit.piece, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, NamedSeamEdge& edge) {
  describe_edge(v, edge);
  v.field("reversed", edge.reversed);
  v.field("from", edge.from, Need::kOptional, kFraction);
  v.field("to", edge.to, Need::kOptional, kFraction);
}

template <typename Visitor>
void describe(Visitor& v, AddSeam& edit) {
  v.field("id", edit.id, Need::kRequired);
  v.field("a", edit.a, Need::kRequired, kSome);
  v.field("b", edit.b, Need::kRequired, kSome);
  v.field("same_direction", edit.same_direction);
}

template <typename Visitor>
void describe(Visitor& v, RemoveSeam& edit) {
  v.field("seam", edit.seam, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, ReverseSeam& edit) {
  v.field("seam", edit.seam, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, SetFabric& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("fabric", edit.fabric, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, SetTexture& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("texture", edit.texture);
}

template <typename Visitor>
void describe(Visitor& v, SetPhysical& edit) {
  v.field("piece", edit.piece, Need::kRequired);
  v.field("physical", edit.physical);
}

template <typename Visitor, typename T>
void describe(Visitor& v, ListSplice<T>& splice) {
  v.field("at", splice.at, Need::kRequired, kIndex);
  v.field("remove", splice.remove, Need::kRequired, kIndex);
  v.field("insert", splice.insert, Need::kOptional, kMany);
}

template <typename Visitor>
void describe(Visitor& v, RestoreLists& edit) {
  v.field("pieces", edit.pieces);
  v.field("seams", edit.seams);
  v.field("attachments", edit.attachments);
  v.field("buttons", edit.buttons);
  v.field("elastics", edit.elastics);
  v.field("folds", edit.folds);
  v.field("cushions", edit.cushions);
  v.field("bodies", edit.bodies);
}

template <typename Edit>
struct NamedEdit {
  using Type = Edit;
  const char* name;
};

/// Every edit under the name that stands in "edit".
inline constexpr auto kEditNames = std::tuple{
    NamedEdit<MovePoint>{"move_point"},
    NamedEdit<MoveHandle>{"move_handle"},
    NamedEdit<InsertPoint>{"insert_point"},
    NamedEdit<DeletePoint>{"delete_point"},
    NamedEdit<SplitEdge>{"split_edge"},
    NamedEdit<JoinEdges>{"join_edges"},
    NamedEdit<StraightenEdge>{"straighten_edge"},
    NamedEdit<BendEdge>{"bend_edge"},
    NamedEdit<SetEdgeLength>{"set_edge_length"},
    NamedEdit<MirrorPiece>{"mirror_piece"},
    NamedEdit<RotateGrain>{"rotate_grain"},
    NamedEdit<AddLine>{"add_line"},
    NamedEdit<RemoveLine>{"remove_line"},
    NamedEdit<AddDart>{"add_dart"},
    NamedEdit<AddInnerDart>{"add_inner_dart"},
    NamedEdit<RenameEdge>{"rename_edge"},
    NamedEdit<RemoveDart>{"remove_dart"},
    NamedEdit<AddHole>{"add_hole"},
    NamedEdit<RemoveHole>{"remove_hole"},
    NamedEdit<MovePiece>{"move_piece"},
    NamedEdit<RenamePiece>{"rename_piece"},
    NamedEdit<DuplicatePiece>{"duplicate_piece"},
    NamedEdit<DeletePiece>{"delete_piece"},
    NamedEdit<AddSeam>{"add_seam"},
    NamedEdit<RemoveSeam>{"remove_seam"},
    NamedEdit<ReverseSeam>{"reverse_seam"},
    NamedEdit<SetFabric>{"set_fabric"},
    NamedEdit<SetTexture>{"set_texture"},
    NamedEdit<SetPhysical>{"set_physical"},
    NamedEdit<RestoreLists>{"restore"},
    NamedEdit<AddNotch>{"add_notch"},
    NamedEdit<MoveNotch>{"move_notch"},
    NamedEdit<RemoveNotch>{"remove_notch"},
};

static_assert(std::tuple_size_v<decltype(kEditNames)> ==
              std::variant_size_v<PatternEdit> + std::variant_size_v<ProjectEdit> - 1);

}  // namespace toile::fields
