#pragma once
// The edits' fields, said once as core/project/fields.h says the document's, and their names in JSON.

#include <tuple>

#include "core/project/editing/edits.h"
#include "core/project/fields.h"

namespace toile::fields {

inline constexpr Range kFraction{0, 1};
inline constexpr Range kIndex{0, 1e6};

/// The piece that an edit is about.
template <typename Visitor, typename Edit>
void describe_piece(Visitor& v, Edit& edit) {
  v.field("piece", edit.piece, "Id of a piece.", Need::kRequired);
}

/// The piece and the edge that an edit is about.
template <typename Visitor, typename Edit>
void describe_edge(Visitor& v, Edit& edit,
                   const char* which = "Id of one of its edges or of its holes' edges.") {
  describe_piece(v, edit);
  v.field("edge", edit.edge, which, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::MovePoint& edit) {
  v.object("move_point",
           "Moves a point of an outline; handles beside it move along, straight curves stay straight.");
  describe_edge(v, edit);
  v.field("point", edit.point,
          "Joint of the edge's curves: 0 is its start, their number its end. A corner belongs to both edges.",
          Need::kRequired, kIndex);
  v.field("to", edit.to, "mm.", Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, edit::MoveHandle& edit) {
  v.object("move_handle", "Moves a handle of a curve.");
  describe_edge(v, edit);
  v.field("curve", edit.curve, "Of the edge, from 0.", Need::kRequired, kIndex);
  v.field("handle", edit.handle, "The first or the second.", Need::kRequired, Range{1, 2});
  v.field("to", edit.to, "mm.", Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, edit::InsertPoint& edit) {
  v.object("insert_point", "Parts a curve in two that look the same.");
  describe_edge(v, edit);
  v.field("at", edit.at, "Fraction of the edge's length, in the outline's direction.", Need::kRequired,
          kFraction);
}

template <typename Visitor>
void describe(Visitor& v, edit::DeletePoint& edit) {
  v.object("delete_point", "Makes one curve of the two beside a point within an edge.");
  describe_edge(v, edit);
  v.field("point", edit.point, "Joint of the edge's curves, neither its start nor its end.", Need::kRequired,
          kIndex);
}

template <typename Visitor>
void describe(Visitor& v, edit::SplitEdge& edit) {
  v.object("split_edge", "Parts an edge in two. What was sewn stays sewn.");
  describe_edge(v, edit);
  v.field("at", edit.at, "Fraction of the edge's length; a joint of its curves within 0.01 mm is taken.",
          Need::kRequired, kFraction);
  v.field("id", edit.id, "Of the second part. Without it, the edge's id with a number.");
}

template <typename Visitor>
void describe(Visitor& v, edit::JoinEdges& edit) {
  v.object(
      "join_edges",
      "Makes one edge, under the first one's id, of two that follow each other. What was sewn stays sewn.");
  describe_edge(v, edit);
  v.field("next", edit.next, "Id of the edge that follows in the outline's direction.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::StraightenEdge& edit) {
  v.object("straighten_edge", "Makes a curve straight, or the whole edge one straight line.");
  describe_edge(v, edit);
  v.field("curve", edit.curve, "Of the edge, from 0. Default -1: the whole edge.", Need::kOptional,
          Range{-1, kIndex.most});
}

template <typename Visitor>
void describe(Visitor& v, edit::BendEdge& edit) {
  v.object("bend_edge", "Gives a curve both its handles.");
  describe_edge(v, edit);
  v.field("curve", edit.curve, "Of the edge, from 0.", Need::kRequired, kIndex);
  v.field("handle1", edit.handle1, "mm.", Need::kRequired, kLength);
  v.field("handle2", edit.handle2, "mm.", Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, edit::SetEdgeLength& edit) {
  v.object("set_edge_length", "Scales the edge to a length; the edges beside it follow.");
  describe_edge(v, edit);
  v.field("length_mm", edit.length_mm, "mm, along its curves.", Need::kRequired, Range{0.1, 1e5});
  v.choice("keep", edit.keep, "What stays in place. Default start.", {"start", "middle", "end"});
}

template <typename Visitor>
void describe(Visitor& v, edit::MirrorPiece& edit) {
  v.object("mirror_piece", "Turns the piece over, about the upright middle line of its box.");
  describe_piece(v, edit);
}

template <typename Visitor>
void describe(Visitor& v, edit::RotateGrain& edit) {
  v.object("rotate_grain", "Turns the direction of the warp.");
  describe_piece(v, edit);
  v.field("angle", edit.angle, "Degrees, counter-clockwise.", Need::kRequired, Range{-360, 360});
}

template <typename Visitor>
void describe(Visitor& v, edit::AddLine& edit) {
  v.object("add_line", "Draws a line on the piece.");
  describe_piece(v, edit);
  v.field("id", edit.line.id, "Unique within the piece.", Need::kRequired);
  v.field("points", edit.line.points, "mm; inside the outline, or on it at the ends.", Need::kRequired,
          Range{2, 10000});
  v.field("drawn", edit.line.drawn, "Only drawn: the mesh takes no notice of it. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, edit::RemoveLine& edit) {
  v.object("remove_line", "Takes a line away.");
  describe_piece(v, edit);
  v.field("line", edit.line, "Id of the line.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::AddNotch& edit) {
  v.object("add_notch", "Marks a place on an edge, with a cut into the cloth; the edge gets a point there.");
  describe_edge(v, edit, "Id of one of its edges.");
  v.field("at", edit.at, "Fraction of the edge's length, in the outline's direction.", Need::kRequired,
          kFraction);
  v.field("depth_mm", edit.depth_mm, "Depth of the cut. Default 0.", Need::kOptional, Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, edit::MoveNotch& edit) {
  v.object("move_notch", "Moves a notch to a place on any edge of its piece.");
  describe_piece(v, edit);
  v.field("notch", edit.notch, "Which one, from 0, in the piece's order.", Need::kRequired, kIndex);
  v.field("edge", edit.edge, "Id of the edge to which it comes.", Need::kRequired);
  v.field("at", edit.at, "Fraction of the edge's length, in the outline's direction.", Need::kRequired,
          kFraction);
  v.field("depth_mm", edit.depth_mm, "Its depth from here on; without it, as it was.", Need::kOptional,
          Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, edit::RemoveNotch& edit) {
  v.object("remove_notch", "Takes a notch away, and its point where the edge looks the same without it.");
  describe_piece(v, edit);
  v.field("notch", edit.notch, "Which one, from 0, in the piece's order.", Need::kRequired, kIndex);
}

template <typename Visitor>
void describe(Visitor& v, edit::AddDart& edit) {
  v.object(
      "add_dart",
      "Cuts a wedge into an edge and sews its legs together. What was sewn stays sewn on both sides of it.");
  describe_edge(v, edit);
  v.field("at", edit.at, "Where its middle is, as a fraction of the edge's length.", Need::kRequired,
          kFraction);
  v.field("width_mm", edit.width_mm, "mm, along the edge.", Need::kRequired, Range{1, 1e5});
  v.field("depth_mm", edit.depth_mm, "mm, from the edge to the tip.", Need::kRequired, Range{1, 1e5});
  v.field("id", edit.id, "Of its seam; the legs are <id>_a and <id>_b.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::AddInnerDart& edit) {
  v.object("add_inner_dart",
           "Cuts a fish-eye dart, a diamond within the cloth, and sews its sides together.");
  describe_piece(v, edit);
  v.field("from", edit.from, "mm, one tip.", Need::kRequired, kLength);
  v.field("to", edit.to, "mm, the other tip.", Need::kRequired, kLength);
  v.field("width_mm", edit.width_mm, "mm, where it is widest.", Need::kRequired, Range{1, 1e5});
  v.field("at", edit.at, "Where it is widest, as a fraction of the way from the first tip. Default 0.5.",
          Need::kOptional, Range{0.05, 0.95});
  v.field("id", edit.id, "Of its seam; its sides are <id>_a and <id>_b.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::RenameEdge& edit) {
  v.object("rename_edge", "Gives an edge another name; seams and all else that names it follow.");
  describe_edge(v, edit);
  v.field("to", edit.to, "Its new id, that no edge or line of the piece has.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::RemoveDart& edit) {
  v.object("remove_dart",
           "Takes a dart away: by a straight line over its mouth, or with its hole where it lies within the "
           "cloth.");
  v.field("seam", edit.seam, "Id of the seam that closes it.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::DrawnEdge& edge) {
  describe_drawn_edge(v, edge);
}

template <typename Visitor>
void describe(Visitor& v, edit::AddHole& edit) {
  v.object("add_hole", "Cuts a hole.");
  describe_piece(v, edit);
  v.field("edges", edit.edges, "Its edges in order, either way round.", Need::kRequired, kSome);
}

template <typename Visitor>
void describe(Visitor& v, edit::RemoveHole& edit) {
  v.object("remove_hole", "Fills a hole; seams of its edges go.");
  describe_edge(v, edit, "Id of one of its edges.");
}

template <typename Visitor>
void describe(Visitor& v, edit::MovePiece& edit) {
  v.object("move_piece", "Moves a piece in its drawing. In space it stays where it stands.");
  describe_piece(v, edit);
  v.field("by", edit.by, "mm.", Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, edit::RenamePiece& edit) {
  v.object("rename_piece", "Gives a piece another id, wherever it is named.");
  describe_piece(v, edit);
  v.field("to", edit.to, "The new id.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::DuplicatePiece& edit) {
  v.object("duplicate_piece", "Adds a copy at the end of the list, without seams.");
  describe_piece(v, edit);
  v.field("id", edit.id, "Of the copy.", Need::kRequired);
  v.field("by", edit.by, "mm that it lies and stands away from its original. Default [0, 0].",
          Need::kOptional, kLength);
  v.field("mirrored", edit.mirrored, "Turned over first. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, edit::DeletePiece& edit) {
  v.object("delete_piece", "Removes a piece, its part of all seams, and what is on it.");
  describe_piece(v, edit);
}

template <typename Visitor>
void describe(Visitor& v, edit::NamedSeamEdge& edge) {
  v.object("seam_edge", "An edge of a piece, or a part of one.");
  describe_edge(v, edge, "Id of one of its edges.");
  v.field("reversed", edge.reversed, "Traversed against the outline's own direction. Default false.");
  v.field("from", edge.from,
          "Where the sewn part begins: a fraction of the edge's length, in the outline's own direction. "
          "Default 0.",
          Need::kOptional, kFraction);
  v.field("to", edge.to, "Where it ends. Default 1.", Need::kOptional, kFraction);
}

template <typename Visitor>
void describe(Visitor& v, edit::AddSeam& edit) {
  v.object("add_seam", "Sews two series of edges together.");
  v.field("id", edit.id, "Unique among the seams.", Need::kRequired);
  v.field("a", edit.a, "One side.", Need::kRequired, kSome);
  v.field("b", edit.b, "The other side.", Need::kRequired, kSome);
  v.field("same_direction", edit.same_direction,
          "The start of a meets the start of b. Default false: its end.");
}

template <typename Visitor>
void describe(Visitor& v, edit::RemoveSeam& edit) {
  v.object("remove_seam", "Takes a seam away.");
  v.field("seam", edit.seam, "Its id.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::ReverseSeam& edit) {
  v.object("reverse_seam", "Turns the direction of a seam over.");
  v.field("seam", edit.seam, "Its id.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, edit::SetFabric& edit) {
  v.object("set_fabric", "Cuts a piece of another fabric.");
  describe_piece(v, edit);
  v.field("fabric", edit.fabric, "Id of a fabric of the document, or the name of one of the library.",
          Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, editing::SetTexture& edit) {
  v.object("set_texture", "Prints a picture on a piece, or takes it away.");
  describe_piece(v, edit);
  v.field("texture", edit.texture, "Without it, the piece has none.");
}

template <typename Visitor>
void describe(Visitor& v, editing::SetPhysical& edit) {
  v.object("set_physical", "Says what a piece has otherwise than its fabric, or that it has nothing.");
  describe_piece(v, edit);
  v.field("physical", edit.physical, "All of it; what is not given is as the fabric has it.");
}

template <typename Visitor>
void describe(Visitor& v, editing::SetSolver& edit) {
  v.object("set_solver", "Says by which method the garment is draped.");
  v.choice("solver", edit.solver, "As settings.solver of the document.", {"toile", "paper"}, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, editing::SetMaxTime& edit) {
  v.object("set_max_time", "Says when a drape that has not settled ends.");
  v.field("max_time_s", edit.max_time_s, "s of simulated time, as settings.max_time_s of the document.",
          Need::kRequired, Range{0, 3600});
}

template <typename Visitor, typename T>
void describe(Visitor& v, editing::ListSplice<T>& splice) {
  v.object("", "");
  v.field("at", splice.at, "First element, from 0.", Need::kRequired, kIndex);
  v.field("remove", splice.remove, "How many go from there on.", Need::kRequired, kIndex);
  v.field("insert", splice.insert, "What comes there instead.", Need::kOptional, kMany);
}

template <typename Visitor>
void describe(Visitor& v, editing::RestoreLists& edit) {
  v.object("restore", "Puts back parts of the document's lists: what an undo does.");
  v.field("pieces", edit.pieces, "Of this list.");
  v.field("seams", edit.seams, "Of this list.");
  v.field("attachments", edit.attachments, "Of this list.");
  v.field("buttons", edit.buttons, "Of this list.");
  v.field("elastics", edit.elastics, "Of this list.");
  v.field("folds", edit.folds, "Of this list.");
  v.field("cushions", edit.cushions, "Of this list.");
  v.field("bodies", edit.bodies, "Of this list.");
}

template <typename Edit>
struct NamedEdit {
  using Type = Edit;
  const char* name;
};

/// Every edit under the name that stands in "edit".
inline constexpr auto kEditNames = std::tuple{
    NamedEdit<edit::MovePoint>{"move_point"},
    NamedEdit<edit::MoveHandle>{"move_handle"},
    NamedEdit<edit::InsertPoint>{"insert_point"},
    NamedEdit<edit::DeletePoint>{"delete_point"},
    NamedEdit<edit::SplitEdge>{"split_edge"},
    NamedEdit<edit::JoinEdges>{"join_edges"},
    NamedEdit<edit::StraightenEdge>{"straighten_edge"},
    NamedEdit<edit::BendEdge>{"bend_edge"},
    NamedEdit<edit::SetEdgeLength>{"set_edge_length"},
    NamedEdit<edit::MirrorPiece>{"mirror_piece"},
    NamedEdit<edit::RotateGrain>{"rotate_grain"},
    NamedEdit<edit::AddLine>{"add_line"},
    NamedEdit<edit::RemoveLine>{"remove_line"},
    NamedEdit<edit::AddDart>{"add_dart"},
    NamedEdit<edit::AddInnerDart>{"add_inner_dart"},
    NamedEdit<edit::RenameEdge>{"rename_edge"},
    NamedEdit<edit::RemoveDart>{"remove_dart"},
    NamedEdit<edit::AddHole>{"add_hole"},
    NamedEdit<edit::RemoveHole>{"remove_hole"},
    NamedEdit<edit::MovePiece>{"move_piece"},
    NamedEdit<edit::RenamePiece>{"rename_piece"},
    NamedEdit<edit::DuplicatePiece>{"duplicate_piece"},
    NamedEdit<edit::DeletePiece>{"delete_piece"},
    NamedEdit<edit::AddSeam>{"add_seam"},
    NamedEdit<edit::RemoveSeam>{"remove_seam"},
    NamedEdit<edit::ReverseSeam>{"reverse_seam"},
    NamedEdit<edit::SetFabric>{"set_fabric"},
    NamedEdit<editing::SetTexture>{"set_texture"},
    NamedEdit<editing::SetPhysical>{"set_physical"},
    NamedEdit<editing::SetSolver>{"set_solver"},
    NamedEdit<editing::SetMaxTime>{"set_max_time"},
    NamedEdit<editing::RestoreLists>{"restore"},
    NamedEdit<edit::AddNotch>{"add_notch"},
    NamedEdit<edit::MoveNotch>{"move_notch"},
    NamedEdit<edit::RemoveNotch>{"remove_notch"},
};

static_assert(std::tuple_size_v<decltype(kEditNames)> ==
              std::variant_size_v<edit::PatternEdit> + std::variant_size_v<editing::ProjectEdit> - 1);

}  // namespace toile::fields
