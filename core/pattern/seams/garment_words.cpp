#include "core/pattern/seams/garment_words.h"

#include "core/pattern/seams/lines.h"
#include "core/pattern/seams/model.h"

namespace toile::seams {

std::vector<PieceWords> garment_words(const pattern::Pattern& pattern) {
  return make_seam_model(lines_of(pattern).pattern).words;  // darts closed, as seams are looked for
}

}  // namespace toile::seams
