#pragma once
// A list of edits that tests read.

namespace toile {

/// Every edit with every key of its own, as edits_json writes it.
inline constexpr const char* kEveryEdit = R"([
  {"edit": "move_point", "piece": "front", "edge": "hem", "point": 2, "to": [1.5, -2.0]},
  {"edit": "move_handle", "piece": "front", "edge": "hem", "curve": 1, "handle": 2, "to": [1.0, 2.0]},
  {"edit": "insert_point", "piece": "front", "edge": "hem", "at": 0.1},
  {"edit": "delete_point", "piece": "front", "edge": "hem", "point": 3},
  {"edit": "split_edge", "piece": "front", "edge": "hem", "at": 0.7, "id": "hem2"},
  {"edit": "join_edges", "piece": "front", "edge": "hem", "next": "hem2"},
  {"edit": "straighten_edge", "piece": "front", "edge": "hem", "curve": 4},
  {"edit": "bend_edge", "piece": "front", "edge": "hem", "curve": 4, "handle1": [0.1, 0.2], "handle2": [3.0, 4.0]},
  {"edit": "set_edge_length", "piece": "front", "edge": "hem", "length_mm": 123.4, "keep": "middle"},
  {"edit": "mirror_piece", "piece": "front"},
  {"edit": "rotate_grain", "piece": "front", "angle": -33.3},
  {"edit": "add_line", "piece": "front", "id": "l", "points": [[1.0, 2.0], [3.0, 4.0]], "drawn": true},
  {"edit": "add_notch", "piece": "front", "edge": "hem", "at": 0.25, "depth_mm": 6.0},
  {"edit": "move_notch", "piece": "front", "notch": 1, "edge": "hem", "at": 0.75, "depth_mm": 4.0},
  {"edit": "remove_notch", "piece": "front", "notch": 1},
  {"edit": "remove_line", "piece": "front", "line": "l"},
  {"edit": "add_dart", "piece": "front", "edge": "hem", "at": 0.5, "width_mm": 20.0, "depth_mm": 80.0, "id": "d"},
  {"edit": "add_inner_dart", "piece": "front", "from": [1.0, 2.0], "to": [3.0, 200.0], "width_mm": 20.0, "at": 0.4,
   "id": "d"},
  {"edit": "rename_edge", "piece": "front", "edge": "hem", "to": "bottom"},
  {"edit": "remove_dart", "seam": "d"},
  {"edit": "add_hole", "piece": "front", "edges": [{"id": "h1", "points": [[1.0, 2.0], [3.0, 4.0]]},
    {"id": "h2", "curves": [[[3.0, 4.0], [5.0, 6.0], [7.0, 8.0], [1.0, 2.0]]]}]},
  {"edit": "remove_hole", "piece": "front", "edge": "h1"},
  {"edit": "move_piece", "piece": "front", "by": [5.0, 6.0]},
  {"edit": "rename_piece", "piece": "front", "to": "fore"},
  {"edit": "duplicate_piece", "piece": "front", "id": "copy", "by": [7.0, 8.0], "mirrored": true},
  {"edit": "delete_piece", "piece": "front"},
  {"edit": "add_seam", "id": "s", "a": [{"piece": "p", "edge": "e", "reversed": true, "from": 0.1, "to": 0.9}],
   "b": [{"piece": "q", "edge": "f", "reversed": false, "from": 0.0, "to": 1.0}], "same_direction": true},
  {"edit": "remove_seam", "seam": "s"},
  {"edit": "reverse_seam", "seam": "s"},
  {"edit": "set_fabric", "piece": "front", "fabric": "wool"},
  {"edit": "set_texture", "piece": "front", "texture": {"image": "a.png", "scale_mm": 20.0, "offset": [1.0, 2.0],
   "angle": 3.0}},
  {"edit": "set_physical", "piece": "front", "physical": {"areal_mass_g_m2": 99.0, "friction": 0.1}},
  {"edit": "set_solver", "solver": "paper"},
  {"edit": "set_max_time", "max_time_s": 16.0},
  {"edit": "restore", "pieces": {"at": 3, "remove": 1}, "seams": {"at": 0, "remove": 1, "insert":
    [{"id": "s", "a": [{"piece": "p", "edge": "e", "reversed": false, "from": 0.0, "to": 1.0}],
      "b": [{"piece": "p", "edge": "f", "reversed": false, "from": 0.0, "to": 1.0}], "same_direction": false}]},
   "attachments": {"at": 1, "remove": 1}, "buttons": {"at": 1, "remove": 1}, "elastics": {"at": 1, "remove": 1},
   "folds": {"at": 1, "remove": 1}, "cushions": {"at": 1, "remove": 1}, "bodies": {"at": 0, "remove": 1}}
])";

}  // namespace toile
