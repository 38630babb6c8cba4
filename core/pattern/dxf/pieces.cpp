#include "core/pattern/dxf/pieces.h"

#include <utility>

#include "core/pattern/dxf/lines.h"
#include "core/pattern/dxf/marks.h"
#include "core/pattern/dxf/outlines.h"
#include "core/pattern/dxf/roles.h"
#include "core/pattern/dxf/sew_ends.h"
#include "core/pattern/dxf/unfold.h"

namespace toile::dxf {

Result<DxfPlacePieces> pieces_of(const DxfPlace& place, const DxfReading& reading, std::size_t drawn,
                                 int first_id) {
  DxfChains drawing = TRY(chains_of(place.parts, reading, drawn));
  const DxfRoles roles = roles_of(drawing.chains, reading.settings.layers);
  const std::vector<DxfFold> folds = folds_of(drawing.chains, roles);
  DxfClosed closed = closed_at_gaps(std::move(drawing.chains), roles, folds);
  DxfClosed whole = closed_at_cut_lines(std::move(closed.chains), roles);
  const std::vector<DxfChain>& chains = whole.chains;
  const DxfLoops loops = TRY(loops_of(chains, roles, reading.settings.max_loops));
  const DxfSeamLines seams = seam_lines_of(loops, {roles.by_aama, reading.has_sew_layer});
  DxfPieces pieces = outlined(chains, loops, seams, roles.by_aama, first_id);
  pieces.is_block = place.is_block;
  pieces = with_holes(std::move(pieces), chains, roles, loops, seams);
  pieces = with_lines(std::move(pieces), chains, roles);
  pieces = with_marks(std::move(pieces), place.parts, chains, roles, reading);
  pieces = unfolded(std::move(pieces), chains, folds);

  DxfPlacePieces made{{}, drawing.drawn, std::move(drawing.notes)};
  made.notes.add(std::move(closed.notes));
  made.notes.add(std::move(whole.notes));
  made.notes.add(std::move(pieces.notes));
  for (DxfPlaced& placed : pieces.placed) made.pieces.push_back(std::move(placed.found));
  return made;
}

}  // namespace toile::dxf
