#pragma once
// What a garment is to become on a body before any height or distance is chosen: which piece does what, and
// how they lie on the sheets. Each pass takes the values of those before it and hands its own on.

#include <array>
#include <vector>

#include "core/arrange/arrange.h"
#include "core/arrange/body_stand.h"
#include "core/arrange/flat_layout.h"
#include "core/arrange/gore_ring.h"
#include "core/arrange/leg_piece.h"

namespace toile::arrange {

inline constexpr double kSheetGap = 0.012;  ///< m, between pieces of a sheet

/// Pieces by what is done with them, as indices of GarmentGraph::pieces.
struct PieceRoles {
  std::vector<Index> trunk;    ///< on the two sheets before and behind the body
  std::vector<Index> on_arms;  ///< sleeves and what is sewn to them
  std::vector<Index> hoods;
  std::vector<Index> bands;  ///< they close in themselves around trunk or neck, or are collars all around it
  std::vector<Gore> gores;   ///< around the body in a ring
};
PieceRoles roles_of(const GarmentGraph& graph, const std::vector<LegPiece>& legs);

/// What goes on each arm, by BodySide.
struct ArmPieces {
  std::array<std::vector<Index>, 2> limb;  ///< flat, before and behind the arm
  std::array<std::vector<Index>, 2> tube;  ///< rolled around it
};

/// The side of the body that a piece belongs to: by its name, by where on the trunk it is sewn, or as what it
/// is sewn to. Where nothing tells, the side that has fewer of `arms` yet.
measure::BodySide side_of(const GarmentGraph& graph, const FlatLayout& layout, const ArmPieces& arms,
                          Index piece);

struct ArrangePlan {
  GarmentGraph graph;
  std::vector<LegPiece> legs;  ///< of one piece each
  PieceRoles roles;
  FlatLayout layout;  ///< of the trunk's pieces
  ArmPieces arms;
  double top = 0;  ///< m, highest y of the trunk's pieces on the sheet
};

/// Error: arrange.no_seams, with the piece that none leads to.
Result<ArrangePlan> plan_arrangement(const ArrangeInput& input, const BodyStand& stand);

}  // namespace toile::arrange
