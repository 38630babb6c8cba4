#pragma once
// The fitted bodice block: where its points lie, for what is drafted from it.

#include "core/draft/outline.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m; what a garment wants of the block.
struct BodiceStyle {
  double bust_ease = 60;
  double waist_ease = 30;
  double armhole_ease = 15;  ///< the armhole's depth below the armpit
  double neck_wider = 8;     ///< of each side, beyond a fifth of the neck
  double front_neck = 75;    ///< depth of the neckline at the middle
  double back_neck = 20;
  double shoulder_shift = 0;  ///< the shoulder ends so far outside its point; negative: inside
};

/// A half of the front or the back: x from the middle, y from the waist, mm.
struct HalfBodice {
  double bust = 0;       ///< width under the arm
  double waist = 0;      ///< finished width at the waist
  double underarm = 0;   ///< height, dart and all
  Vec2 neck;             ///< where the shoulder meets the neckline
  double middle = 0;     ///< height of the neckline at the middle
  Vec2 shoulder;         ///< its outer end
  double chest = 0;      ///< half the width between the armholes where they are hollowest
  double bust_dart = 0;  ///< intake at the side; the front's only
  Vec2 bust_point;       ///< of the front
};

struct Bodice {
  HalfBodice front, back;
};

/// The widths are Müller & Sohn's ("Schnittkonstruktionen für Kleider und Blusen", from memory): back width
/// Bu/8 + 5.5 cm, armhole width Bu/8 - 1.5 cm, bust width Bu/4 - 4 cm, half the bust together; the side seam
/// parts the armhole's. Depth and lengths are the wearer's own from nape to armpit and waist. The bust dart's
/// intake is a quarter of what bust and underbust differ by; the front is longer by it. Eases and curves are
/// the project's.
Bodice bodice_of(const Wearer& wearer, const BodiceStyle& style);

/// Takes into the bust dart what the front's side is longer by than the back's; both are straight from these
/// lower ends up to the underarm. Too little for a dart shortens the front instead.
void match_sides(Bodice& bodice, Vec2 front_low, Vec2 back_low);

/// From the underarm's end of the side up around the armhole, along the shoulder and down the neckline to the
/// middle, or to `aside` mm from it: edges armhole, shoulder, neck. REQUIRES that the outline stands at
/// (bust, underarm).
void add_armhole_and_neck(Outline& outline, const HalfBodice& half, double aside = 0);

/// The side from where the outline stands, on the waist or below, up to the underarm, with the bust dart in
/// it: edges side_low, dart_low, dart_high, side_high. Without an intake: side alone.
void add_side_with_dart(Outline& outline, const HalfBodice& half);

}  // namespace toile::draft
