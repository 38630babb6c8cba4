#pragma once
// The drapes of a sweep as one drawing: small stills in rows of bodies and columns of fabrics.

#include <string>
#include <vector>

#include "core/sweep/table.h"

namespace toile::sweep {

/// Pixels of a still on the sheet.
inline constexpr int kStillWidth = 240, kStillHeight = 300;

struct ContactSheet {
  std::string svg;
  int width = 0, height = 0;  ///< pixels
};

/// `stills` are PNG files (any size of that shape), one for each cell in the table's order; an empty one
/// leaves its place to the cell's state in words. REQUIRES as many as there are cells.
ContactSheet contact_sheet(const Table& table, const std::vector<std::string>& stills);

}  // namespace toile::sweep
