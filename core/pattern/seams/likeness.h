#pragma once
// Which pieces of a pattern mirror each other, are drawn alike, or have one role. The parts of
// make_seam_model() that fill in what SeamModel says of it; each REQUIRES what stands before it there.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether two lengths (mm) are one but for the rounding of a drawing.
bool equally_long(double a, double b);

/// The panel's runs.
std::vector<Index> runs_of(const SeamModel& m, Index panel);

/// Whether one piece is the other, or its mirror image, by the lengths of its edges.
bool same_edges(const SeamModel& m, Index p, Index q);

/// Whether the piece turned over across its length, of a trunk across its grain and of a collar either way,
/// is the piece itself, but for a button stand; grain lines may be drawn a little aslant. REQUIRES the
/// model's runs and `up`.
bool mirrors_itself(const SeamModel& m, Index panel);

/// Two pieces alike that are all of a skirt and each its own mirror image are its front and its back, which
/// no name tells apart, and no left and right. It comes before twins are found.
void tell_front_and_back(SeamModel& m);

/// `twin`, and `mirror_panel` and `mirror_edge` of runs: pieces whose names say left and right go first, then
/// any two, then those that mirror themselves.
void find_twins(SeamModel& m);

/// `mirror`: the run that mirrors each, as the edges do.
void match_mirrors(SeamModel& m);

/// `rival`.
void find_rivals(SeamModel& m);

/// `counterparts` and `same`.
void find_alike(SeamModel& m);

}  // namespace toile::seams
