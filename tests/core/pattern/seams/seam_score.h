#pragma once
// How well proposed seams agree with a garment's true ones, point by point: edges of a drawing need not end
// where those of its designer did.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/pattern.h"
#include "core/pattern/seams/propose.h"

namespace toile::test {

/// A point of an outline.
struct SeamPoint {
  Index panel = kNone, edge = kNone;
  double along = 0;  ///< fraction of the edge's length
};

/// Points that are sewn to each other, evenly along one seam.
struct SewnPoints {
  std::string name;
  double length = 0;  ///< mm, of the longer side
  std::vector<std::array<SeamPoint, 2>> pairs;
};

struct SeamScore {
  int proposed = 0, right = 0;  ///< proposals, and those of which four in five points are truly sewn so
  int known = 0, found = 0;     ///< true seams, and those of which four in five points are proposed so
  std::vector<std::string> wrong, missed;

  double precision() const { return proposed == 0 ? 1 : static_cast<double>(right) / proposed; }
  double recall() const { return known == 0 ? 1 : static_cast<double>(found) / known; }
  void add(const SeamScore& other);
};

/// Points of the seam, side b stretched to side a.
SewnPoints points_of(const pattern::Pattern& pattern, const pattern::Seam& seam);

/// Compares proposals of at least `confidence` with the true seams.
SeamScore score_of(const pattern::Pattern& pattern, std::span<const seams::SeamProposal> proposals,
                   std::span<const SewnPoints> truth, double confidence = 0.8);

/// Which proposals are right: of each that four in five points are truly sewn so.
std::vector<bool> right_of(const pattern::Pattern& pattern, std::span<const seams::SeamProposal> proposals,
                           std::span<const SewnPoints> truth);

/// A drawing as the product reads it, and its true seams from the *.seams.json beside it.
struct TrueGarment {
  pattern::Pattern pattern;     ///< without seams
  std::vector<char> clockwise;  ///< one per piece, as the file draws it
  std::vector<SewnPoints> truth;
};
Result<TrueGarment> read_true_garment(const std::filesystem::path& dxf);

/// The true seams from a file of edges with their ends, as data/garmentcode/random has them: pieces
/// {name: {edges: [{length_mm, from, to}]}} as drawn (mm), seams [piece, edge, piece, edge, "opposite" or
/// "same"]. An edge is the way along the drawn outline between its ends that has its length.
Result<std::vector<SewnPoints>> read_seams_by_ends(const std::filesystem::path& file,
                                                   const pattern::Pattern& pattern);

}  // namespace toile::test
