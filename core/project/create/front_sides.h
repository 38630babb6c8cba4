#pragma once
// Sides of trousers' fronts and backs, from the hem up to the waist, and where a front's would be whole.

#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::create {

constexpr double kSideUp = 0.15;   ///< how much a side faces up at most, and a mouth at least …
constexpr double kWaistUp = 0.95;  ///< … which faces up less than a waist
constexpr double kLeastCut = 20, kMostCut = 320;  ///< mm, of side or waist that a pocket takes

/// The run of its piece after or before it.
const seams::SeamRun& beside(const seams::SeamModel& model, const seams::SeamRun& run, bool after);

/// Whether the run goes up from a hem as a side does.
bool begins_side(const seams::SeamModel& model, const seams::SeamRun& run);

/// The edges that go up from a hem to the waist, the lowest first; none where no waist is above them.
std::vector<const seams::SeamRun*> side_from(const seams::SeamModel& model, const seams::SeamRun& lowest,
                                             bool after);

/// mm.
double length_of(const std::vector<const seams::SeamRun*>& side);

/// The way on beyond an end of the edge, a unit vector.
Vec2 way_on(const pattern::PanelEdge& edge, bool at_end);

/// Lengths of backs' sides, and of these with a yoke's end, mm.
std::vector<double> sides_behind(const seams::SeamModel& model);

/// Whether one of the lengths is near enough for a side to be sewn to.
bool agrees(const std::vector<double>& lengths, double length);

}  // namespace toile::create
