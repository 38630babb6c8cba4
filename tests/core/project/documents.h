#pragma once
// Documents that the tests of this folder read.

#include <string>

#include "core/project/project.h"

namespace toile {

/// Every key of the format at least once, with values that no default has.
inline const char* const kFullDocument = R"({
  "toile": 1,
  "name": "All of it",
  "pieces": [
    {
      "id": "front",
      "from": {"dxf": "cut/skirt.dxf", "piece": "FRONT", "corners": [[0, 0], [10.5, 20]], "units": "inch", "size": "42", "layers": {"3": "sew"}},
      "edge_names": {"e0": "waist", "e1": "side"},
      "fabric": "wool",
      "placement": {"wrapped": {"axis": [0.1, -0.2], "radius": 0.25, "angle": -45, "height": 1.1,
                                "anchor": [100, 600], "slope": 0.2, "axis_height": 0.2, "up": [0, 0.8, 0.6],
        "turn": 30, "flipped": false}}
    },
    {
      "id": "back",
      "outline": [
        {"id": "hem", "points": [[0, 0], [50, -5], [100, 0]]},
        {"id": "right", "curves": [[[100, 0], [110, 30], [110, 60], [100, 100]]]},
        {"id": "top", "points": [[100, 100], [0, 100]]},
        {"id": "left", "points": [[0, 100], [0, 0]]}
      ],
      "holes": [[{"id": "eye", "points": [[40, 40], [40, 60], [60, 60], [60, 40], [40, 40]]}],
        [{"id": "slit", "curves": [[[20, 20], [20, 23], [20, 27], [20, 30]], [[20, 30], [27, 27], [27, 23], [20, 20]]]}]],
      "grain": [1, 2],
      "lines": [{"id": "crease", "points": [[5, 80], [95, 80.5]], "drawn": true}],
      "layer": 2,
      "notches": [{"at": [100, 100], "depth_mm": 4, "inwards": [-1, -1]}],
      "texture": {"image": "cloth/tartan.png", "scale_mm": 240, "offset": [3, -4], "angle": 45},
      "physical": {"interlining": "interlining", "areal_mass_g_m2": 300, "stretch_warp_n_m": 2500, "stretch_weft_n_m": 1800,
                   "stretch_coupling_n_m": 400, "stretch_shear_n_m": 220, "bend_warp_un_m": 30,
                   "bend_weft_un_m": 28, "bend_bias_un_m": 20, "thickness_mm": 0.9, "friction": 0.4, "particle_distance_mm": 8},
      "fabric": "wool",
      "placement": {"rigid": {"translation": [0, 1, -0.3], "rotation": [0, 180, 5], "flipped": true}}
    },
    {
      "id": "pocket", "outline": [{"id": "rim", "points": [[0, 0], [50, 0], [25, 60], [0, 0]]}], "fabric": "wool",
      "placement": {"on_box": {"body": "form", "part": "hips", "side": "left", "at": [0.01, -0.02], "away": 0.04,
                               "turn": 15, "anchor": [20, 10], "flipped": true}}
    },
    {
      "id": "cuff", "outline": [{"id": "rim", "points": [[0, 0], [50, 0], [25, 60], [0, 0]]}], "fabric": "wool",
      "placement": {"around": {"body": "form", "part": "left_arm", "side": "back", "at": [0, 0.05], "away": 0.01,
                               "turn": 90, "slope": -0.1, "anchor": [25, 20], "flipped": true}}
    }
  ],
  "fabric": "poplin",
  "fabrics": [
    {"id": "wool", "name": "Worsted", "like": "wool-suiting",
     "coefficients": {"elasticity_warp": 0.1, "elasticity_weft": 0.2, "bending_warp": 0.3, "bending_weft": 0.25}, "areal_mass_g_m2": 210, "stretch_warp_n_m": 1500, "stretch_weft_n_m": 900,
     "stretch_coupling_n_m": 210.5, "stretch_shear_n_m": 120, "limit_warp_percent": 12.5,
     "limit_weft_percent": 20, "limit_shear_rad": 0.4, "bend_warp_un_m": 14.5, "bend_weft_un_m": 9,
     "bend_bias_un_m": 7, "thickness_mm": 0.61, "friction": 0.25, "colour": [0.2, 0.3, 0.9]}
  ],
  "seams": [
    {"id": "s1", "a": [{"piece": "back", "edge": "right", "reversed": false, "from": 0.1, "to": 0.9}],
     "b": [{"piece": "back", "edge": "left", "reversed": true, "from": 0.25, "to": 0.75}],
     "same_direction": true}
  ],
  "bodies": [
    {"id": "person", "file": "people/ann.obj", "unit": "cm", "up": "z", "friction": 0.5, "skin_offset_mm": 2, "restitution": 0.2,
     "translation": [0, 0.1, 0], "rotation": [0, 90, 0], "scale": 1.1,
     "landmarks": [{"name": "mole", "triangle": 7, "share": [0.5, 0.25, 0.25]},
                   {"name": "pocket", "near": "mole", "offset_mm": [-20, 0, 5], "body_height_mm": 1700}]},
    {"id": "form", "mannequin": {"preset": "eu38", "sex": "female", "pose": "a", "arm_angle": 50, "height_cm": 171,
     "bust_cm": 91, "underbust_cm": 77, "waist_cm": 73, "hip_cm": 98, "neck_cm": 34, "shoulder_width_cm": 38,
     "upper_arm_cm": 28, "wrist_cm": 16, "arm_length_cm": 57, "thigh_cm": 56, "calf_cm": 36, "inseam_cm": 78,
     "back_length_cm": 40, "triangles": 3000},
     "motion": [{"after_s": 0.5, "file": "people/form.obj"},
                {"after_s": 1.5, "mannequin": {"preset": "eu40", "sex": "female", "pose": "t", "arm_angle": 45,
                 "height_cm": 171, "bust_cm": 95, "underbust_cm": 80, "waist_cm": 77, "hip_cm": 102, "neck_cm": 35,
                 "shoulder_width_cm": 38, "upper_arm_cm": 29, "wrist_cm": 16, "arm_length_cm": 57, "thigh_cm": 58,
                 "calf_cm": 37, "inseam_cm": 78, "back_length_cm": 40, "triangles": 3000}}]}
  ],
  "attachments": [
    {"id": "hold", "piece": "back", "edges": ["top"], "hold": "place", "release_after_s": 0.5},
    {"id": "pin", "piece": "back", "points": [[50, 50]],
     "to": {"body": "person", "line": "waist", "up_mm": -30}, "release_after_s": -1},
    {"id": "nape", "piece": "back", "edges": ["top"], "to": {"landmark": "neck_back"}},
    {"id": "hook", "piece": "back", "edges": ["hem"], "to": {"place": [0, 1, 0.2]}}
  ],
  "buttons": [
    {"id": "b1", "a": {"piece": "back", "at": [10, 90]}, "b": {"piece": "back", "at": [80, 15]}, "distance_mm": 3}
  ],
  "elastics": [
    {"id": "band", "piece": "back", "lines": ["top", "crease"], "factor": 0.8, "stiffness_n": 12}
  ],
  "folds": [
    {"id": "pleat", "piece": "back", "lines": ["crease"], "angle": -90, "stiffness_mn": 5}
  ],
  "cushions": [
    {"id": "pad", "pieces": ["back"], "pressure_pa": 250, "volume_l": 1.5}
  ],
  "settings": {"particle_distance_mm": 20, "solver": "paper", "paper": {"time_step_s": 0.004, "damping": 0.2, "passes": 9,
               "reflection": 0.1, "load_n_m": 5, "clearance_mm": 3}, "time_step_s": 0.0005, "gravity": 9.8, "sew_time_s": 0.7,
               "settle_speed_mm_s": 3, "max_time_s": 6, "frame_interval_steps": 25, "start": "sewn", "ground": false,
               "mode": "dynamic", "end": "settled",
               "air": {"density_kg_m3": 1.1, "drag_across": 1.3, "drag_along": 0.1, "wind_m_s": [1, 0, -2]}}
})";

/// `text` with the one place where `from` stands changed to `to`.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "nothing to change: " + from : text.replace(at, from.size(), to);
}

}  // namespace toile
