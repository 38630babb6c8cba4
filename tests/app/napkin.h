#pragma once
// The least garment: a square of cloth over a post. It drapes in a second or two.

#include <filesystem>
#include <string>

#include "tests/app/program.h"

namespace toile {

inline constexpr const char* kNapkin = R"({
  "toile": 1,
  "name": "Napkin",
  "pieces": [
    {"id": "napkin",
     "outline": [
       {"id": "south", "points": [[0, 0], [300, 0]]},
       {"id": "east", "points": [[300, 0], [300, 300]]},
       {"id": "north", "points": [[300, 300], [0, 300]]},
       {"id": "west", "points": [[0, 300], [0, 0]]}],
     "fabric": "cotton",
     "placement": {"rigid": {"translation": [-0.15, 0.52, 0.15], "rotation": [-90, 0, 0]}}}
  ],
  "fabrics": [
    {"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
     "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7, "thickness_mm": 0.4}
  ],
  "seams": [],
  "bodies": [{"id": "post", "file": "post.obj", "unit": "m"}],
  "settings": {"particle_distance_mm": 25, "sew_time_s": 0, "max_time_s": 8}
})";

inline constexpr const char* kPost =
    "v -0.1 0 -0.1\nv 0.1 0 -0.1\nv 0.1 0 0.1\nv -0.1 0 0.1\n"
    "v -0.1 0.5 -0.1\nv 0.1 0.5 -0.1\nv 0.1 0.5 0.1\nv -0.1 0.5 0.1\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

/// A folder with the napkin's project, in which the first place of `from` is changed to `to`.
inline std::filesystem::path napkin_folder(const std::string& name, const std::string& from = "",
                                           const std::string& to = "") {
  const std::filesystem::path folder = fresh_folder(name);
  std::string text = kNapkin;
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
  write_text(folder / "project.json", text);
  write_text(folder / "post.obj", kPost);
  return folder;
}

}  // namespace toile
