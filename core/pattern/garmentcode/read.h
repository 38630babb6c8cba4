#pragma once
// GarmentCode's specification files: JSON with panels, curved edges, stitches and 3D placement, as published
// with Korosteleva and Sorkine-Hornung, "GarmentCode: Programming Parametric Sewing Patterns" (2023), and the
// older datasets in the same format.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::garmentcode {

/// Where a panel stands in space: turned first, then shifted.
struct GarmentCodePlace {
  Vec3 translation;      ///< m
  Vec3 rotation;         ///< degrees about x, then y, then z
  bool flipped = false;  ///< mirrored in x before it is turned
};

/// What the file says of a panel beyond its outline.
struct GarmentCodePanel {
  GarmentCodePlace placement;
  std::string label;                     ///< e.g. "arm"; empty when there is none
  std::vector<std::string> edge_labels;  ///< one per edge, empty where there is none
};

struct GarmentCodeGarment {
  pattern::Pattern pattern;              ///< mm; edge i of a panel is "e<i>", stitch i is "seam<i>"
  std::vector<GarmentCodePanel> panels;  ///< one per panel of the pattern
  std::vector<std::string> notes;        ///< what was passed over, with its JSON pointer
};

/// Reads a specification, in the order of its panel_order, else of the file.
///
/// Curves: control points relative to the edge (unless properties.curvature_coords is "absolute"), one for
/// "quadratic" and for the old bare lists, two for "cubic"; "circle" is [radius in the file's unit, large
/// arc, counter-clockwise]. Lengths are in metres / properties.units_in_meter (100 when it is missing).
///
/// A panel's vertices run counter-clockwise as seen from its right side; a panel that the file draws
/// clockwise is therefore mirrored in x and placed `flipped`, so that it stands in space as the file says and
/// its right side faces as the file says. With that, stitched edges run against each other, but those of a
/// stitch with the flag "right_wrong" run the same way.
///
/// Errors, with a JSON pointer in `where`: json.*; garmentcode.missing, .type, .unit, .range, .reference (a
/// vertex, panel or edge that is not there), .open_outline, .edge_without_length, .curve, .no_panels;
/// pattern.* for outlines that cannot be cut. An edge that is stitched a second time keeps its first stitch,
/// which is noted.
Result<GarmentCodeGarment> read_garmentcode(std::string_view text);

}  // namespace toile::garmentcode
