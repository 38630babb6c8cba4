#pragma once
// Edits of a pattern as data: what a hand does on the page, a program through the API, and an undo history
// keeps. Each names pieces, edges, lines and seams by their ids, so that it means the same when it is done
// again elsewhere. Lengths in millimetres, angles in degrees, positions along an edge as fractions of its
// length in the outline's own direction.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/pattern.h"

namespace toile::edit {

/// Moves a point of an outline. `point` counts the joints of the edge's curves: 0 is its start, the number of
/// curves its end; corners belong to both edges. Handles beside it move along, straight curves stay straight.
struct MovePoint {
  std::string piece, edge;
  int point = 0;
  Vec2 to;
};

/// Moves the first or second handle (1 or 2) of a curve of the edge.
struct MoveHandle {
  std::string piece, edge;
  int curve = 0, handle = 1;
  Vec2 to;
};

/// Parts a curve in two that look the same.
struct InsertPoint {
  std::string piece, edge;
  double at = 0.5;
};

/// Makes one curve of the two beside a point within an edge: undoes InsertPoint, and smooths otherwise.
struct DeletePoint {
  std::string piece, edge;
  int point = 1;
};

/// Parts an edge in two: at a joint of its curves when one is there, else within a curve. What was sewn stays
/// sewn.
struct SplitEdge {
  std::string piece, edge;
  double at = 0.5;
  std::string id;  ///< of the second part; empty: the edge's with a number that is free
};

/// Makes one edge, under the first one's id, of two that follow each other. What was sewn stays sewn.
struct JoinEdges {
  std::string piece, edge, next;
};

/// Makes a curve of the edge straight, or (-1) the whole edge one straight line.
struct StraightenEdge {
  std::string piece, edge;
  int curve = -1;
};

/// Gives a curve of the edge both its handles: bends what was straight.
struct BendEdge {
  std::string piece, edge;
  int curve = 0;
  Vec2 handle1, handle2;
};

/// Scales the edge to a length. What it keeps stays in place: "start", "end", or "middle" of the line between
/// them; the edges beside it follow.
struct SetEdgeLength {
  std::string piece, edge;
  double length_mm = 0;
  std::string keep = "start";
};

/// Turns the piece over, about the upright middle line of its box. Edges keep their ids, seams their threads.
struct MirrorPiece {
  std::string piece;
};

/// Turns the direction of the warp, counter-clockwise; the piece stays.
struct RotateGrain {
  std::string piece;
  double angle = 0;
};

/// Gives an edge of an outline or a hole another name; seams and all else follow.
struct RenameEdge {
  std::string piece, edge, to;
};

/// Marks a place on an edge, with a cut of that depth into the cloth. The edge gets a point there, unless it
/// has one within half a millimetre, which is marked instead.
struct AddNotch {
  std::string piece, edge;
  double at = 0.5, depth_mm = 0;
};

/// Moves a notch to a place on any edge of its piece. Notches count from 0, in the piece's order. Its depth
/// stays when none is given.
struct MoveNotch {
  std::string piece;
  int notch = 0;
  std::string edge;
  double at = 0.5;
  std::optional<double> depth_mm;
};

struct RemoveNotch {
  std::string piece;
  int notch = 0;
};

struct AddLine {
  std::string piece;
  pattern::InnerLine line;
};

struct RemoveLine {
  std::string piece, line;
};

/// Cuts a wedge into an edge, with its middle at `at`, and sews its legs together: a seam of this id between
/// edges <id>_a and <id>_b. What was sewn stays sewn on both sides of it.
struct AddDart {
  std::string piece, edge;
  double at = 0.5, width_mm = 0, depth_mm = 0;
  std::string id;
};

/// Cuts a fish-eye dart, a diamond within the cloth from one tip to the other, and sews its sides together: a
/// seam of this id between edges <id>_a and <id>_b of a hole, of two straight curves each. `at` says how far
/// along from the first tip it is widest.
struct AddInnerDart {
  std::string piece;
  Vec2 from, to;
  double width_mm = 0, at = 0.5;
  std::string id;
};

/// Takes the dart that this seam closes away: by a straight line over its mouth, or, of one within the cloth,
/// with its hole.
struct RemoveDart {
  std::string seam;
};

/// An edge as it is drawn: either a line through points or a chain of cubic Béziers.
struct DrawnEdge {
  std::string id;
  std::vector<Vec2> points;
  std::vector<std::array<Vec2, 4>> curves;
};

/// Cuts a hole: edges in order, each from where the one before ends, either way round.
struct AddHole {
  std::string piece;
  std::vector<DrawnEdge> edges;
};

/// Fills the hole that this edge belongs to.
struct RemoveHole {
  std::string piece, edge;
};

/// Moves a piece in its drawing; where it stands in space is not changed by that.
struct MovePiece {
  std::string piece;
  Vec2 by;
};

struct RenamePiece {
  std::string piece, to;
};

/// A copy at the pattern's end, turned over like MirrorPiece when `mirrored`, then moved, without seams. It
/// also stands in space beside its original, as far as it was moved.
struct DuplicatePiece {
  std::string piece, id;
  Vec2 by;
  bool mirrored = false;
};

/// Removes a piece and its place in all seams; a seam without a side goes.
struct DeletePiece {
  std::string piece;
};

/// SeamEdge by names.
struct NamedSeamEdge {
  std::string piece, edge;
  bool reversed = false;
  double from = 0, to = 1;
};

struct AddSeam {
  std::string id;
  std::vector<NamedSeamEdge> a, b;
  bool same_direction = false;
};

struct RemoveSeam {
  std::string seam;
};

/// Turns Seam::same_direction over.
struct ReverseSeam {
  std::string seam;
};

struct SetFabric {
  std::string piece, fabric;
};

using PatternEdit =
    std::variant<MovePoint, MoveHandle, InsertPoint, DeletePoint, SplitEdge, JoinEdges, StraightenEdge,
                 BendEdge, SetEdgeLength, MirrorPiece, RotateGrain, RenameEdge, AddLine, RemoveLine, AddDart,
                 AddInnerDart, RemoveDart, AddHole, RemoveHole, MovePiece, RenamePiece, DuplicatePiece,
                 DeletePiece, AddSeam, RemoveSeam, ReverseSeam, SetFabric, AddNotch, MoveNotch, RemoveNotch>;

/// An edge or line of the edited piece that goes by other names now; by none when it is gone.
struct RenamedPart {
  std::string was;
  std::vector<std::string> now;
};

/// What became of flat points of a piece that moved as a whole: mirrored about x = middle, then shifted.
struct PieceMotion {
  std::optional<double> middle;
  Vec2 by;
};
Vec2 moved(Vec2 p, const PieceMotion& motion);

/// What an edit did, for whoever keeps more about a pattern than it knows itself.
struct EditEffect {
  std::string piece;      ///< the piece concerned, as it is called now; empty: none, or it is gone
  std::string was;        ///< as it was called; empty: none, or it is new
  std::string copy_of;    ///< of a new piece
  bool reshaped = false;  ///< its outline, holes or notches are others
  std::vector<RenamedPart> parts;
  std::optional<PieceMotion> motion;
};

struct EditedPattern {
  pattern::Pattern pattern;
  EditEffect effect;
};

/// The pattern after the edit; the given one is not touched. REQUIRES a pattern that validate() accepts;
/// gives one. Errors, with the piece and edge in `where`: edit.unknown_piece, edit.unknown_edge,
/// edit.unknown_line, edit.unknown_notch, edit.unknown_seam, edit.unknown_point, edit.out_of_range (a figure
/// that cannot be met), edit.not_neighbours, edit.no_dart, edit.sewn (what a dart would cut away is sewn by
/// itself), edit.last_piece; and pattern.* where the result could not be cut or sewn.
Result<EditedPattern> apply_edit(const pattern::Pattern& pattern, const PatternEdit& edit);

}  // namespace toile::edit
