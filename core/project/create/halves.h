#pragma once
// Pieces of a drawing that are worn twice, once mirrored, although the file does not say so.

#include <span>
#include <vector>

#include "core/pattern/dxf/read.h"
#include "core/pattern/pattern.h"

namespace toile::create {

/// How wide the piece is across its grain, mm.
double width_of(const pattern::Panel& panel);

/// Why a piece is taken twice, once mirrored, which its file has once.
enum class Twice {
  kNo,
  kForgottenHalf,  ///< half a front or back among pieces that are told as pairs
  kDrawnHalf,      ///< all of the garment is drawn once for both sides, as on paper
  kLimb            ///< of an arm or a leg, and names no side: a person has two
};

/// Of each piece that the file has once, whether it takes its mirror image to wear it. A person is as broad
/// on the left as on the right:
/// - Where most pieces are told as mirrored pairs, a front or back that is neither a pair, nor its own mirror
///   image, nor any other piece's, is a half whose count was forgotten.
/// - Where nothing is counted and no name tells a side, a sleeve or cuff without a mirror image is there for
///   both arms; and where moreover no front or back is anything's mirror image, and all of them together
///   would go around no grown person, the garment is drawn by halves: so is whatever else is not symmetric.
/// `panels`: one per piece of the drawing, in its order.
std::vector<Twice> taken_twice(const dxf::DxfDrawing& drawing, std::span<const pattern::Panel> panels);

}  // namespace toile::create
