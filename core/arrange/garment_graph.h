#pragma once
// A garment's pieces and what is sewn to what, flat, with all that the arrangement asks of them.

#include <optional>
#include <string>
#include <vector>

#include "core/arrange/flat_move.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"

namespace toile::arrange {

/// What a piece covers, after its name or, where that says nothing, after how the garment hangs together.
enum class Cover { kUnknown, kTorso, kSkirt, kLeg, kSleeve, kWaistband, kCuff, kCollar, kHood };

struct GarmentPiece {
  std::string id;
  std::vector<Vec2> outline;   ///< m, counter-clockwise, each vertex once
  std::vector<bool> sewn;      ///< whether a seam or dart holds that vertex
  std::vector<Index> edge_of;  ///< of the segment from that vertex on: the panel's edge
  std::vector<Vec2> corners;   ///< m, where its edges begin
  Vec2 centroid;               ///< m
  double area = 0;             ///< m²
  Vec2 grain;                  ///< unit vector
  Cover cover = Cover::kUnknown;
  int face = 0;         ///< 1 worn in front, -1 behind, 0 not told
  int hand = 0;         ///< 1 on the wearer's left, -1 on the right, 0 not told
  int outside = 1;      ///< 1: the side that is up in the flat pattern is worn outside; -1: inside
  bool tube = false;    ///< it is sewn to itself, so that it goes around a limb alone
  bool strap = false;   ///< by its name: it goes over a shoulder and is held by its ends
  bool edging = false;  ///< a strip around the neck and down the fronts: where it is sewn says nothing of up
};

/// Two points that a seam brings together, m, each in its own piece's plane.
struct GarmentTie {
  Index a = kNone, b = kNone;
  Vec2 at_a, at_b;
  Index seam = kNone;
};

struct GarmentGraph {
  std::vector<GarmentPiece> pieces;
  std::vector<GarmentTie> ties;  ///< darts left out
  std::vector<double> borders;   ///< of the largest part that is sewn together: lengths, m, longest first
};

/// What pieces cover only by their names: cover_unnamed() (garment_kind.h) tells the rest.
GarmentGraph make_garment_graph(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes);

/// The isometries that lay piece `from` on piece `to`, mirrored or not as told, when they are alike to 1 % of
/// their size: the closest first, and of strips and other pieces alike both ways up several.
std::vector<FlatMove> ways_to_lay_on(const GarmentPiece& from, const GarmentPiece& to, bool mirrored);

/// The first of these.
std::optional<FlatMove> lay_on(const GarmentPiece& from, const GarmentPiece& to, bool mirrored);

/// Whether two pieces are sewn together all around: a front and a back, not a left and a right. Seen from the
/// piece's middle, a seam down the centre lies on one side, side seams lie on both.
bool sewn_around(const GarmentGraph& graph, Index piece, Index other);

/// The other piece that is `piece`'s mirror image in the garment: of one outline, mirrored, and worn on the
/// other side where names tell that. kNone where there is none, or several of which none stands out.
Index mirror_partner(const GarmentGraph& graph, Index piece);

/// All mirrorings that lay a piece on itself.
std::vector<FlatMove> own_mirrors(const GarmentPiece& piece);

}  // namespace toile::arrange
