#pragma once
// What strips are where no name tells, by what they are as long as: bands, cuffs and collars, and what hangs
// below a waistband. Parts of make_seam_model(); each REQUIRES what stands before it there.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Lengths that strips may go around, mm; 0 where there is no such place.
struct StripPlaces {
  double waist = 0;  ///< of trousers
  double wrist = 0;
  double neck = 0;
  double hem = 0;  ///< of a top
};

/// Strips that fit a waist, wrists, a neck, a hem.
void name_strips(SeamModel& m, const StripPlaces& around);

/// Of a top without collar or hood, the one strip that fits its neck (mm), whatever it is called: "Blende".
void name_lone_neckband(SeamModel& m, double neck);

/// Where nothing is known but bands: a strip that is as long as the upper ends of two pieces that mirror each
/// other is a skirt's waistband, and such pairs are its tiers.
void name_waistband(SeamModel& m);

}  // namespace toile::seams
