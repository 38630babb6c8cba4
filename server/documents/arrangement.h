#pragma once
// Where the pieces of a project stand. Each change is one step of the project's history.

#include <string>
#include <vector>

#include "core/arrange/arrange.h"
#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/json/tree.h"
#include "core/project/project.h"
#include "server/documents/documents.h"

namespace toile::documents {

/// Places for all pieces (core/arrange/arrange.h). Those that nothing holds on stay where `input` has them,
/// with a finding each (core/drape/worn_part.h). Errors: mesh.*, those of arrange().
Result<arrange::Arrangement> arrangement_of(const drape::DrapeInput& input);

/// The arrangement's places and holds in the document. Holds of an arrangement before this one are replaced:
/// those that are named and made as it makes them. Others stay, whatever their ids. REQUIRES that `project`
/// and `pattern` have the same pieces.
void take_arrangement(const arrange::Arrangement& made, const pattern::Pattern& pattern,
                      project::Project& project);

/// {"pieces": [{"id", "place"}], "holds": [id], "findings": […]}
std::vector<json::JsonMember> arrangement_members(const arrange::Arrangement& made);

struct ArrangedProject {
  store::ProjectRow project;
  json::JsonValue arrangement;  ///< its members
};
/// Places all pieces around the body (core/arrange/arrange.h) when the project stands at revision `expected`
/// (0: at any). Errors: those of reading it, of arrange(), store.*.
Result<ArrangedProject> arrange_project(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, int expected);

/// Where a person puts a piece.
struct PieceWish {
  std::string piece;
  std::string part = "torso";  ///< name_of(BodyPart)
  std::string side = "front";  ///< "front", "back", "left", "right": the wearer's
  Vec2 at_mm;                  ///< from the side's middle: to the right as one looks at it, and up
  double away_mm = 50;         ///< from the side; of a wrapped piece from what stands out farthest
  double turn = 0;             ///< degrees, counter-clockwise as one looks at it
  bool wrapped = false;        ///< rolled around the part
  bool flipped = false;        ///< turned over: the right side faces the body
  bool with_partner = false;   ///< its mirror image in the garment, if any, goes to the other side
};
/// Keys as in PieceWish; all but "piece" may be missing. Errors: request.unknown_key, request.place.
Result<PieceWish> read_piece_wish(const json::JsonValue& object);
/// The middle of the piece comes there. Errors: edit.unknown_piece, body.not_standing, arrange.no_body,
/// store.*.
Result<store::ProjectRow> place_piece(Documents& documents, const store::RequestContext& context,
                                      const std::string& id, const PieceWish& wish, int expected);

}  // namespace toile::documents
