#pragma once

#include "core/base/result.h"
#include "core/pattern/pattern.h"

namespace toile::draft {

/// Millimetres. Girths are full, around the body.
struct SkirtMeasures {
  double waist = 720;         ///< body, where the band sits
  double hip = 960;           ///< body, widest
  double waist_to_hip = 200;  ///< down the side
  double length = 560;        ///< of the skirt below the band
  double hem = 1600;          ///< girth of the hem: the flare
  double waist_ease = 15;     ///< the band's finished girth over the waist's: it cannot slide over the hips
  double hip_ease = 40;
  double band_height = 35;
};

/// An A-line skirt of four pieces: "front" and "back" (edges hem, side_left, waist, side_right), "band_front"
/// and "band_back" (edges skirt, end_left, top, end_right; straight strips). Left and right are the wearer's.
/// All pieces are seen from their right side, grain along the length, y up, laid out side by side; each
/// piece's middle is at x = skirt_middle().
///
/// The pieces are sectors of a flat ring, which roll up to a cone without strain: the flare shapes the waist,
/// so there are no darts. Where the cone is narrower at the hip than hip + hip_ease, the side seams swell to
/// a hip curve. Seams: side_left, side_right, band_left, band_right, waist_front, waist_back. Error:
/// "draft.measure" with the measure's name.
Result<pattern::Pattern> draft_skirt(const SkirtMeasures& measures);

/// x of the middle of the front's pieces (`back` false) or the back's, mm; the skirt's waist passes y = 0
/// there.
double skirt_middle(const SkirtMeasures& measures, bool back);

/// mm, from the apex of the cone that the front or the back is a piece of to its waist line; infinite for a
/// skirt without flare.
double skirt_waist_radius(const SkirtMeasures& measures);

/// mm: y of the band pieces' lower edge.
double skirt_band_bottom(const SkirtMeasures& measures);

}  // namespace toile::draft
