#pragma once
// How many folds a hem hangs in, as one sees it from below.

#include <span>

#include "core/base/types.h"

namespace toile::garments {

/// Folds of the lowest border of cloth that hangs around a vertical axis: stretches of the hem's outline,
/// seen from above, that turn inwards. A tube has none, whatever its cross-section's breadth and depth: a
/// count of ups and downs of the radius would take an ellipse for two folds. `positions` in metres, y up; the
/// outline is sampled every 4°, so folds narrower than some 12° are not told apart.
int hem_folds(std::span<const Vec3> positions);

}  // namespace toile::garments
