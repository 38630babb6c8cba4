#pragma once
// The pieces where they start, each in its own bounds tree, so that pieces can be tried in other places
// without building anything anew.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/collision/crossings.h"
#include "core/geometry/bvh.h"
#include "core/preflight/body_probe.h"
#include "core/sewing/assembly.h"

namespace toile::preflight {

/// Who stands in a piece's way.
struct Opponent {
  bool is_body = false;
  Index index = kNone;  ///< of the body, or of the piece
  friend bool operator==(const Opponent&, const Opponent&) = default;
};

/// How near two things are, and where.
struct Nearness {
  double gap = 1;  ///< m; 0 where they cross or one is inside; the distance asked for when they are farther
  bool crosses = false;
  bool inside = false;  ///< the piece lies in the body without crossing its skin
  Vec3 place;           ///< m, on the piece
};

class StartField {
 public:
  /// Everything must outlive the field.
  StartField(const sewing::Assembly& assembly, std::span<const BodyProbe> probes);

  Index piece_count() const { return static_cast<Index>(pieces_.size()); }
  Vec3 shift(Index piece) const { return pieces_[piece].shift; }
  /// Shifts are kept on the grid of the exact crossing test (2⁻²⁰ m).
  void set_shift(Index piece, Vec3 shift);

  Vec3 centre(Index piece) const { return pieces_[piece].centre + pieces_[piece].shift; }
  Vec3 half_size(Index piece) const { return pieces_[piece].half_size; }
  double area(Index piece) const { return pieces_[piece].area; }  ///< m²
  Vec3 normal(Index piece) const { return pieces_[piece].normal; }

  /// The gap of `piece`, moved by `extra` from where it stands, to another `opponent`. Looks no farther than
  /// `reach` (m) and stops at the first crossing, or gap under `enough`. What is sewn together counts as one
  /// vertex there and has no gap to itself; so do the two features next to it.
  Nearness nearness(Index piece, Vec3 extra, const Opponent& opponent, double reach, double enough) const;

  /// The gap of `piece` to itself, which is looked for once: it stays the same wherever the piece stands.
  Nearness to_itself(Index piece);

  /// All whose boxes come within `reach` (m) of the piece moved by `extra`: bodies first.
  std::vector<Opponent> neighbours(Index piece, Vec3 extra, double reach) const;

 private:
  struct Piece {
    std::vector<Index> triangles;  ///< of the garment
    geometry::Bvh tree;
    geometry::Box3 box;
    Vec3 shift, centre, half_size, normal;
    double area = 0;
    Index inner_vertex = kNone;         ///< one of its vertices
    std::optional<Nearness> to_itself;  ///< where it was placed
  };

  void add_piece(Index piece);
  Nearness to_body(const Piece& p, Vec3 at, const BodyProbe& probe, double reach, double enough) const;
  Nearness to_piece(const Piece& p, Vec3 at, const Piece& q, double reach, double enough) const;
  Nearness look_at_itself(const Piece& p) const;
  Vec3 position(Index vertex, Vec3 at) const { return assembly_.positions[vertex] + at; }
  Index class_of(Index vertex) const { return assembly_.garment.weld[vertex]; }
  double cloth_gap(Index s, Vec3 at_s, Index t, Vec3 at_t, bool& crosses) const;

  const sewing::Assembly& assembly_;
  std::span<const BodyProbe> probes_;
  std::vector<Piece> pieces_;
};

}  // namespace toile::preflight
