#pragma once
// Which end of a piece's grain line is worn upwards. A line has two ends, and pieces are laid out as the
// cloth is cut, often along its length: head first, feet first, or both by turns.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::seams {

/// The grain of each piece, as unit vectors, turned so that it points to the end that is worn upwards, where
/// shapes tell: necks, armholes and crotches are hollow and lie high, hems bulge, skirts widen downwards.
/// Where a shape tells nothing it goes with those drawn alike, if these agree; else as it is.
std::vector<Vec2> grains_upwards(const std::vector<pattern::Panel>& panels);

}  // namespace toile::seams
