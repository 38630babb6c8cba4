#pragma once
// Ends of waistbands that lie under the other end where they are closed.

#include <optional>
#include <span>
#include <vector>

#include "core/pattern/pattern.h"

namespace toile::create {

struct Underlap {
  Index panel = kNone;
  double long_as = 0;  ///< mm
  Vec2 away;           ///< unit vector along the band, out at the end that lies under
};

/// Of straight bands for the left and the right: the end of the longer one, where a notch tells which it is;
/// of bands that look alike at both ends either. Of one that goes all around: the end that a notch marks.
std::vector<Underlap> underlaps(std::span<const pattern::Panel> panels);

/// Both ends of bands that go all around, beyond the notches nearest to them, where these are as far from
/// both ends, 60 to 260 mm: where fronts lie over each other, so does their band.
std::vector<Underlap> wrapped_ends(std::span<const pattern::Panel> panels);

/// The band without it. Its edges keep their names. Nothing where its end slants by more than it laps over.
std::optional<pattern::Panel> without_underlap(const pattern::Panel& band, const Underlap& underlap);

}  // namespace toile::create
