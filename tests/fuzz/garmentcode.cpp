// GarmentCode specifications.

#include "core/pattern/garmentcode/read.h"

#include "core/pattern/validate.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  const std::string plain =
      R"({"pattern": {"panels": {"front": {"translation": [1, 2, 3], "rotation": [0, 0, 90],
"vertices": [[0, 0], [10, 0], [10, 10], [0, 10]],
"edges": [{"endpoints": [0, 1], "label": "hem"}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}}},
"properties": {"units_in_meter": 100}})";
  const std::string curved = R"({"pattern": {"panels": {
"a": {"label": "arm", "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]], "edges": [
{"endpoints": [0, 1], "curvature": {"type": "cubic", "params": [[0.3, -0.2], [0.7, -0.2]]}},
{"endpoints": [1, 2], "curvature": {"type": "quadratic", "params": [[0.5, 0.1]]}},
{"endpoints": [2, 3], "curvature": {"type": "circle", "params": [20, 0, 1]}},
{"endpoints": [3, 0], "curvature": [0.5, 0.2]}]},
"b": {"vertices": [[0, 10], [10, 10], [10, 0], [0, 0]],
"edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
"stitches": [[{"panel": "a", "edge": 0}, {"panel": "b", "edge": 2}]], "panel_order": ["b", "a"]},
"properties": {"curvature_coords": "relative", "units_in_meter": 100}})";
  return {plain, curved};
}

void try_input(std::string_view bytes) {
  const auto read = garmentcode::read_garmentcode(bytes);
  if (!read) return;
  expect(read->panels.size() == read->pattern.panels.size(), "every panel has its place");
  expect(pattern::validate(read->pattern).ok(), "what is read can be cut and sewn");
}

}  // namespace toile::fuzz
