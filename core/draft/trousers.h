#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct SlacksStyle {
  double waist_ease = 10;  ///< of the band
  double hip_ease = 60;
  double rise_ease = 10;                   ///< the crotch hangs so far below the body's
  double front_hem = 200, back_hem = 220;  ///< widths of the legs' pieces
  double crease_angle = 40;                ///< degrees, as pressed
  double above_floor = 70;                 ///< where the hem ends
  double band_height = 38;
};

/// Slacks of cloth: "right front", "left front", "right back", "left back", each with a dart at the waist,
/// and a "waistband", a strip that closes at the middle of the front. The front's middle seam has the fly's
/// stitching drawn on it.
///
/// The trouser block of Müller & Sohn (as their "Schnittkonstruktionen" print it, from memory): front width a
/// quarter of the hips less 1 cm, back width a quarter of the hips and 1 cm; front crotch 1/20, back crotch
/// 1/10 of the hips and 1 to 2 cm; the crease halfway between side and crotch point; the back's middle seam
/// leans and rises at the waist. Eases, hems and curves are the project's.
Garment draft_slacks(const Wearer& wearer, const SlacksStyle& style = {});

}  // namespace toile::draft
