#pragma once
// Where a piece stands, in the words of a request to place it.

#include <array>
#include <optional>
#include <vector>

#include "core/body/measure/landmarks.h"
#include "core/body/measure/segments.h"
#include "core/drape/drape_input.h"
#include "server/documents/arrangement.h"

namespace toile::documents {

/// What a hand said; nothing where none did.
std::optional<PieceWish> wish_of_hand(const project::ProjectPiece& piece);

/// Finds what somebody would have said for a piece to stand about where it does: a sheet by the side of a box
/// that it faces and is nearest to, a rolled piece by the part that its axis runs through. A sheet that is
/// askew, and a cone, come out as the nearest that can be said.
class PieceStands {
 public:
  /// By the first body of `input` that stands; `input` must outlive the object.
  explicit PieceStands(const drape::DrapeInput& input);

  /// `piece` is its place in the pattern. Nothing where no body stands, or no box has a side that way.
  std::optional<PieceWish> of(Index piece) const;

 private:
  std::optional<PieceWish> of_sheet(const sewing::RigidPlacement& rigid, Vec2 middle) const;
  std::optional<PieceWish> of_roll(const sewing::WrappedPlacement& roll, Vec2 middle, double height) const;

  const drape::DrapeInput& input_;
  const geometry::TriangleMesh* mesh_ = nullptr;
  std::optional<measure::BodyFigure> figure_;
  std::vector<measure::PartBox> boxes_;
};

}  // namespace toile::documents
