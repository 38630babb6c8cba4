#pragma once
// A document that edits are tried on: a piece from a file, one of its own, and everything that hangs on them.

#include <string>

#include "core/project/resolve/resolve.h"

namespace toile::test {

/// A square of 100 mm with its lower left corner at the origin, as a DXF polyline on layer FRONT, with a line
/// drawn within.
inline std::string square_dxf() {
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nFRONT\n90\n4\n70\n1\n";
  for (const char* corner : {"0\n20\n0", "100\n20\n0", "100\n20\n100", "0\n20\n100"}) {
    text += std::string("10\n") + corner + "\n";
  }
  text += "0\nLINE\n8\nMARK\n10\n30\n20\n30\n11\n70\n21\n30\n";
  return text + "0\nTEXT\n8\nFRONT\n10\n50\n20\n50\n40\n5\n1\nFRONT\n0\nENDSEC\n0\nEOF\n";
}

inline resolve::ProjectFiles square_files() {
  return {.dxf_text = [](const std::string&) -> Result<std::string> { return square_dxf(); },
          .body_mesh = [](const std::string&,
                          const mesh_import::MeshSettings&) -> Result<mesh_import::RepairedMesh> {
            return Error{"test.body", "an edit has no need of bodies", ""};
          }};
}

inline const char* const kEditedDocument = R"({
  "toile": 1, "name": "Edited",
  "pieces": [
    {"id": "front", "from": {"dxf": "cut.dxf", "piece": "FRONT", "units": "mm"},
     "edge_names": {"e0": "hem", "e1": "right", "e2": "waist", "e3": "left"}, "fabric": "wool",
     "lines": [{"id": "pleat", "points": [[10, 10], [10, 90]]}],
     "placement": {"wrapped": {"radius": 0.25, "angle": 90, "height": 1.1, "anchor": [50, 100]}}},
    {"id": "back", "outline": [
      {"id": "hem", "points": [[0, 0], [100, 0]]},
      {"id": "right", "curves": [[[100, 0], [110, 30], [110, 60], [100, 100]]]},
      {"id": "waist", "points": [[100, 100], [50, 105], [0, 100]]},
      {"id": "left", "points": [[0, 100], [0, 0]]}],
     "holes": [[{"id": "eye", "points": [[40, 40], [60, 40], [60, 60], [40, 60], [40, 40]]}]],
     "notches": [{"at": [100, 0], "depth_mm": 5, "inwards": [-1, 0]}],
     "grain": [3, 4], "fabric": "wool",
     "placement": {"rigid": {"translation": [0, 1, -0.3], "rotation": [10, 180, 0], "flipped": true}}},
    {"id": "band", "outline": [
      {"id": "low", "points": [[0, 0], [200, 0]]}, {"id": "end", "points": [[200, 0], [200, 30]]},
      {"id": "high", "points": [[200, 30], [0, 30]]}, {"id": "start", "points": [[0, 30], [0, 0]]}],
     "fabric": "silk", "placement": {"rigid": {"translation": [0, 1.2, 0.3]}}}
  ],
  "fabrics": [{"id": "silk", "areal_mass_g_m2": 60, "stretch_warp_n_m": 500, "stretch_weft_n_m": 500,
      "stretch_coupling_n_m": 100, "stretch_shear_n_m": 50, "bend_warp_un_m": 1, "bend_weft_un_m": 1,
      "bend_bias_un_m": 1, "thickness_mm": 0.1},
    {"id": "wool", "areal_mass_g_m2": 210, "stretch_warp_n_m": 1500, "stretch_weft_n_m": 900,
      "stretch_coupling_n_m": 200, "stretch_shear_n_m": 120, "bend_warp_un_m": 14.5, "bend_weft_un_m": 9,
      "bend_bias_un_m": 7, "thickness_mm": 0.6}],
  "seams": [
    {"id": "side", "a": [{"piece": "front", "edge": "right"}], "b": [{"piece": "back", "edge": "left"}]},
    {"id": "waist", "a": [{"piece": "front", "edge": "waist"}, {"piece": "back", "edge": "waist"}],
     "b": [{"piece": "band", "edge": "low", "reversed": true}], "same_direction": true}],
  "bodies": [{"id": "ann", "file": "ann.obj"}],
  "attachments": [{"id": "hold", "piece": "front", "edges": ["waist"]}, {"id": "all", "piece": "band"}],
  "buttons": [{"id": "b1", "a": {"piece": "band", "at": [10, 15]}, "b": {"piece": "band", "at": [190, 15]}}],
  "elastics": [{"id": "gum", "piece": "band", "lines": ["high"], "factor": 0.8}],
  "folds": [{"id": "f1", "piece": "front", "lines": ["pleat"], "angle": 90}],
  "cushions": [{"id": "pad", "pieces": ["front", "back"]}]
})";

}  // namespace toile::test
