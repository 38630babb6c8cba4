#pragma once
// Bodices cut by seams that run from the armhole over bust or shoulder blade to the hem.

#include <string>

#include "core/draft/bodice.h"
#include "core/draft/outline.h"
#include "core/pattern/curve.h"

namespace toile::draft {

/// A half of the front or the back with its seam: x from the middle, y from the waist, mm; the wearer's side
/// that lies at x > 0.
struct PrincessHalf {
  HalfBodice block;
  double waist = 0, hip = 0, hem = 0;  ///< finished widths there; the middle's seam is taken off
  double hips = 0, low = 0;            ///< heights of hips and hem, below 0
  double middle_in = 0;                ///< the middle's seam leans so far in at the waist; 0: no seam there
  double angle = 0;                    ///< radians, by which the bust dart is closed into the seam
  bool back = false;                   ///< over the blade, not the bust
};

/// How wide and how deep; mm.
struct PrincessLevels {
  double waist, hip, hem;  ///< quarters' finished widths
  double hips, low;        ///< heights below 0
  double back_middle_in;
};

struct PrincessBodice {
  PrincessHalf front, back;
};

/// The block with seams from the armholes: what is taken in at the waist goes for a third to the side, and
/// otherwise to the seam over bust or blade; the bust dart is closed at the side and opened into the seam,
/// about the bust point, by as much as makes both sides of one length (the pivot of every flat pattern
/// course; Aldrich calls it the panel line from the armhole). Proportions of the seam are the project's.
PrincessBodice princess_of(const Bodice& block, const PrincessLevels& levels);

/// Goes on from the hem's end of the middle panel: edges princess and armhole, to the shoulder's outer end.
void add_middle_panel(Outline& outline, const PrincessHalf& half);
/// Where the middle panel's hem ends.
Vec2 middle_panel_hem(const PrincessHalf& half);

/// The panel at the side: edges hem, side, armhole, princess.
pattern::Panel side_panel(const std::string& id, const PrincessHalf& half);

/// The back's middle seam, from the neck down to the hem: edge middle. Without a seam a straight line.
void add_back_middle(Outline& outline, const PrincessHalf& half);
/// Where it ends.
Vec2 back_middle_hem(const PrincessHalf& half);

}  // namespace toile::draft
