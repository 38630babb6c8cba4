#pragma once
// One-piece sleeves whose cap fits an armhole.

#include "core/draft/outline.h"
#include "core/pattern/pattern.h"

namespace toile::draft {

/// Lengths in millimetres.
struct SleeveDraft {
  double front_armhole = 210, back_armhole = 220;  ///< lengths that the cap is sewn to
  double cap_ease = 0;  ///< of those together, by which the cap is longer: 0.01 for knit, 0.03 for cloth
  double cap_height = 120;
  double length = 230;     ///< from the top of the cap to the hem
  double hem = 320;        ///< girth
  double elbow_shift = 0;  ///< the hem's middle lies so far to the front: sleeves of cloth follow the arm
};

/// The left arm's sleeve, seen from its right side, cap up: edges hem, underarm_back, cap_back, cap_front,
/// underarm_front, counter-clockwise; the top of the cap at x = 0, the underarm's level at y = 0; front at
/// x < 0. The width of the upper arm is found so that the cap has the armholes' length and its ease: Müller &
/// Sohn draw the cap over a given width, Aldrich through given thirds of the height; its curve here is two
/// S-shaped cubics with the front's hollow deeper, as both have it. Notches: the shoulder's, one at a third
/// of the front's, two at a third of the back's cap.
pattern::Panel left_sleeve(const std::string& id, const SleeveDraft& draft);

/// mm around the upper arm at the underarm's level.
double upper_arm_of(const pattern::Panel& sleeve);

}  // namespace toile::draft
