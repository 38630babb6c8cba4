#include "core/pattern/seams/gluing.h"

namespace toile::seams {

SeamGluing nothing_sewn(const SeamModel& model) {
  return {std::vector<Index>(model.runs.size(), kNone), std::vector<std::array<double, 2>>(model.runs.size()),
          std::vector<char>(model.words.size(), 0)};
}

}  // namespace toile::seams
