#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Shares of the wearer's girths, and millimetres.
struct TshirtStyle {
  double bust_ease = 0.13;     ///< of the bust
  double least_hip_ease = 40;  ///< of the hem over the hips
  double waist_in = 50;  ///< the waist is narrower than the bust by so much, unless the waist forbids it
  double least_waist_ease = 80;
  double below_hip = 55;     ///< length beyond the hips, of a person of 1.68 m
  double band = 20;          ///< height of the neckband
  double band_share = 0.84;  ///< of the neckline: a rib stretches and so lies flat
};

/// A T-shirt of jersey: "front", "back", "left sleeve", "right sleeve", "neckband".
///
/// A flat block as in W. Aldrich, "Metric Pattern Cutting for Women's Wear" (its easy-fitting blocks for
/// knit: front and back of one width, a quarter of bust and ease; a shallow cap without ease; the armhole
/// deepened from the armpit); the armhole's depth is the wearer's own from nape to armpit. Eases and the form
/// of the curves are the project's.
Garment draft_tshirt(const Wearer& wearer, const TshirtStyle& style = {});

}  // namespace toile::draft
