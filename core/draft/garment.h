#pragma once
// A garment, or something for the house, as drafting hands it on: all that a document says but the body.

#include <string>
#include <utility>
#include <vector>

#include "core/draft/outline.h"
#include "core/geometry/triangle_mesh.h"
#include "core/pattern/pattern.h"

namespace toile::draft {

/// A cloth that the garment may be made of.
struct Cloth {
  std::string id;    ///< in the document; pieces name it
  std::string like;  ///< name in the library
  Vec3 colour;       ///< linear, 0 to 1, as in a document
};

/// What the construction says that the garment measures around the body, mm.
struct Girth {
  std::string place;   ///< "bust", "waist", "hip", …
  double body = 0;     ///< the wearer's
  double garment = 0;  ///< of the closed garment there, flat
  double ease() const { return garment - body; }
};

/// A point of a piece, mm.
struct PiecePoint {
  std::string piece;
  Vec2 at;
};

struct DraftedButton {
  std::string id;
  PiecePoint a, b;
};

/// Inner lines of a piece along which it is pressed, and edges along which it is pressed to what they are
/// sewn to.
struct DraftedFold {
  std::string id, piece;
  std::vector<std::string> lines;
  double angle = 0;       ///< degrees; positive: the right side stays outside
  double stiffness = 20;  ///< mN·m per radian and metre
};

struct DraftedElastic {
  std::string id, piece;
  std::vector<std::string> lines;  ///< edges or inner lines
  double factor = 1, stiffness_n = 20;
};

/// Where a piece is sewn from when no person wears it: metres, degrees about x, then y, then z.
struct PiecePlace {
  std::string piece;
  Vec3 translation, rotation;
};

/// The rotation of a piece that lies, its right side up.
inline constexpr Vec3 kLying{-90, 0, 0};

/// Upright, bent to a part of a cylinder about an upright axis, its right side outwards.
struct BentPlace {
  PiecePoint anchor;  ///< comes to the front of the cylinder
  Vec3 at;            ///< m, the anchor's
  double radius = 1;  ///< m
};

/// Points and edges of a piece that stay where they begin.
struct DraftedHold {
  std::string id, piece;
  std::vector<Vec2> points = {};  ///< mm
  std::vector<std::string> edges = {};
};

/// Points of a piece that are led to places in space while the garment is sewn, and stay there.
struct DraftedHooks {
  std::string id, piece;
  std::vector<Vec2> points = {};  ///< mm
  std::vector<Vec3> places = {};  ///< m, one for each point
};

/// What cloth is laid over: its mesh, metres, closed.
struct Solid {
  std::string id;
  geometry::TriangleMesh mesh;
};

struct DraftedCushion {
  std::string id;
  std::vector<std::string> pieces;
  double pressure_pa = 100;
};

struct Garment {
  std::string name;   ///< as files are called: "tshirt"
  std::string title;  ///< for people
  pattern::Pattern pattern = {};
  std::vector<Cloth> cloths = {};  ///< the first is what it is cut of where a piece does not say
  std::vector<std::pair<std::string, std::string>> interlinings = {};  ///< piece, name in the library
  std::vector<DraftedButton> buttons = {};
  std::vector<DraftedFold> folds = {};
  std::vector<DraftedElastic> elastics = {};
  std::vector<Girth> girths = {};
  /// Of what no person wears:
  std::vector<PiecePlace> places = {};
  std::vector<BentPlace> bent = {};
  std::vector<DraftedHold> holds = {};
  std::vector<DraftedHooks> hooks = {};
  std::vector<DraftedCushion> cushions = {};
  std::vector<Solid> solids = {};
  double particle_distance_mm = 15;
  double max_time_s = 8;  ///< by when it is at rest; what hangs freely takes longest
};

/// An edge in a seam: piece and edge by their names. `reversed`: run against the outline's direction.
struct EdgeName {
  std::string piece, edge;
  bool reversed = false;
};

/// Adds the seam that joins the two series; see pattern::Seam for how they meet. REQUIRES that the edges are
/// there.
void sew(Garment& garment, const std::string& id, const std::vector<EdgeName>& a,
         const std::vector<EdgeName>& b, bool same_direction = false);

/// The panel of that name. REQUIRES that there is one.
pattern::Panel& panel_of(Garment& garment, const std::string& id);

/// mm, of all these edges together.
double length_of(const pattern::Panel& panel, const std::vector<std::string>& edges);

/// Lays the pieces side by side (outline.h), and what is told by points of theirs along with them. Places
/// stay those of the pieces as they were.
void lay_out(Garment& garment);

}  // namespace toile::draft
