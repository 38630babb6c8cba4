#pragma once
// Halves of which a text says that they are cut on the fold, and no line where it lies: "cut 1 on fold",
// "im Stoffbruch".

#include <optional>
#include <string_view>
#include <vector>

#include "core/pattern/dxf/fold.h"
#include "core/pattern/dxf/names.h"

namespace toile::dxf {

/// Whether the text says that a piece is cut on the fold, in one of a dozen languages.
bool tells_fold(std::string_view text);

/// Whether that is all that it says, and not how often: it stands at the fold, and is no piece's name. So may
/// a single word ("BRUCH"), which says no more than that there is a fold.
bool tells_only_fold(std::string_view text);

/// The edge of the half that is its fold: of the straight ones with the whole piece on one side the one that
/// such a text stands at (`labels`, mm), that runs along the grain, ends in right angles, is the longest; of
/// a strip an end. Nothing where there is none, or the piece is its own mirror image along the grain, and so
/// drawn whole.
std::optional<FoldAxis> likely_fold(const DxfPiece& half, const std::vector<Vec2>& labels = {});

/// The pieces, whole where texts tell that they are halves, and what is not sure of it.
DxfNamed unfolded_where_told(std::vector<DxfFound> pieces);

}  // namespace toile::dxf
