#pragma once
// Tries the ways to put a garment on until one is certified.

#include <compare>
#include <optional>
#include <vector>

#include "core/base/run_context.h"
#include "core/dressing/dress.h"

namespace toile::dressing {

/// How far a try was from its certificate: rings first, since no untangling puts them right.
struct Shortfall {
  int rings = 0, crossings = 0;
  friend auto operator<=>(const Shortfall&, const Shortfall&) = default;
};

/// What became of the tries.
struct TriedOn {
  std::optional<Dressed> on;    ///< certified
  std::size_t nearest = 0;      ///< where none was: number of the way that came nearest
  Shortfall shortfall;          ///< by how much it did not
  std::vector<Index> at_fault;  ///< and the panels that kept it from being certified, rising
  Effort effort;                ///< what is left of it
  bool gave_up = false;         ///< there were more ways, but the effort was spent
  std::size_t next = 0;         ///< the first of these
};

/// Tries each way on `coarse`, and carries the first that is certified there, bares no shoulder and is not
/// badly squeezed, else the one with the fewest bared, and of those the least squeezed, that twice as much
/// work finds, over to `fine`, where it must be certified again: `positions` are those of `fine`. Where all
/// that are on are strained (Certificate::holds_strained), the least strained is taken. Both are
/// of one pattern, placed and sewn alike; they may be the same. The ways before `first`, an index into
/// dressing_ways(), are passed over; so are those for which no effort is left, but for one. Nothing is on
/// where no way leads there, or where the context was cancelled. Progress phase: "dress".
TriedOn put_on(const sewing::Assembly& fine, const sewing::Assembly& coarse, const Wearer& wearer,
               const RunContext& context, std::size_t first = 0, Effort effort = Effort());

/// The shape of `coarse` at the vertices of another mesh of the same pattern, by where they lie in the flat
/// pieces; sewn vertices together. m.
std::vector<Vec3> carried_over(const sewing::GarmentMesh& fine, const sewing::GarmentMesh& coarse,
                               std::span<const Vec3> shape);

}  // namespace toile::dressing
