#pragma once
// A sheet cut into pages that are glued together.

#include <string>
#include <vector>

#include "core/print/paper.h"
#include "core/print/sheet.h"

namespace toile::print {

struct Page {
  std::string name;  ///< "B3": second column from the left, third row from above
  int column = 0, row = 0;
  Vec2 corner;  ///< mm, of the sheet: the lower left one of what it shows
};

struct Pages {
  int columns = 0, rows = 0;
  std::vector<Page>
      shown;  ///< row by row from above; those that show nothing of a piece or a line are left out
};

/// Windows lie edge to edge from the sheet's upper left corner.
Pages cut_up(const Sheet& sheet, const Paper& paper);

}  // namespace toile::print
