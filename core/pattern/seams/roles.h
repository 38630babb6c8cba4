#pragma once
// What single edges of a piece are by their shape and place: sleeves' caps, sides of wide skirts, the edges
// of fronts that open; and what kinds of pieces the others' names and such edges tell. The parts of
// make_seam_model() that fill in what SeamModel says of it; each REQUIRES what stands before it there.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether the run is the hollow edge of a leg, between its inner edge and its waist.
bool is_leg_crotch(const SeamModel& model, const SeamRun& run);

/// Whether the piece has a hollow edge between an inner leg and the waist, with a side that goes from there
/// to the hem.
bool has_leg_crotch(const SeamModel& m, Index panel);

/// What is only called front, back or side is of the trunk where it has shoulders; or where sleeves, collars,
/// hoods, straps or others with shoulders say that it is a top, and nothing else says what covers the trunk.
/// Below a waistband half a circle is no cape.
void name_trunk(SeamModel& m);

/// The bands that end a top hang from it, as waistbands do.
void name_hem_bands(SeamModel& m);

/// Without arms a garment with legs has its cuffs there, whether their names say so or not.
void name_leg_cuffs(SeamModel& m);

/// `words`: fronts and backs in halves, of a garment that names no kind but a waistband, are legs where they
/// have a crotch. REQUIRES twins.
void name_legs(SeamModel& m);

/// `words`: fronts, backs and sides of a garment that names no kind but a waistband are a skirt where none of
/// them has a crotch. REQUIRES twins, and the names of legs.
void name_skirts(SeamModel& m);

/// `cap`, `tailored`, and `upright` of sleeves: their edges that bulge most, and their mirror images. A
/// sleeve whose cap is above stands, also where no grain line says so; then the others do, too.
void find_caps(SeamModel& m);

/// `upright` of sleeves whose two longest edges along the grain are as long as each other and face apart:
/// they are sewn under the arm, so that the sleeve stands; or of those with a straight hem that faces down
/// between two edges that are alike. A sleeve that lies has its ends there.
void find_standing_sleeves(SeamModel& m);

/// `raglan`, and `raglan_top` of runs: a sleeve's upper end that is short, level and no cap, or of one that
/// is cut in front and back the short edge beside the one along the arm. REQUIRES caps and standing sleeves.
void find_raglan_sleeves(SeamModel& m);

/// `crotch_side`: of pieces that are legs, by name or by name_legs(), and have a crotch on one side alone.
void find_crotch_sides(SeamModel& m);

/// `side`.
void find_sides(SeamModel& m);

/// `open_front` and `opens`: fronts that close with buttons are often rounded into the hem, and no seam goes
/// there. The run's lower end is level, the upper one upright.
void find_open_fronts(SeamModel& m);

/// `opens`: fronts in halves whose edges from hem to shoulder and the neck of the back are together as long
/// as a strip are bound by it, as those of robes and cardigans, and not sewn to each other.
void find_banded_fronts(SeamModel& m);

}  // namespace toile::seams
