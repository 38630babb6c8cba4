#pragma once
// A skirt of four straight pieces for a small mannequin: the least that can be arranged.

#include <string>

namespace toile::test {

/// A rectangle or trapezium with edges e0 (below), e1, e2, e3, counter-clockwise.
inline std::string skirt_piece(const std::string& id, const std::string& below, const std::string& above,
                               const std::string& height) {
  const std::string a = "[-" + below + ", 0]", b = "[" + below + ", 0]",
                    c = "[" + above + ", " + height + "]", d = "[-" + above + ", " + height + "]";
  return R"({"id": ")" + id + R"(", "outline": [{"id": "e0", "points": [)" + a + ", " + b +
         R"(]}, {"id": "e1", "points": [)" + b + ", " + c + R"(]}, {"id": "e2", "points": [)" + c + ", " + d +
         R"(]}, {"id": "e3", "points": [)" + d + ", " + a + R"(]}], "fabric": "cotton",
      "placement": {"rigid": {}}})";
}

inline std::string skirt_seam(const std::string& id, const std::string& a, const std::string& ea,
                              const std::string& b, const std::string& eb) {
  return R"({"id": ")" + id + R"(", "a": [{"piece": ")" + a + R"(", "edge": ")" + ea +
         R"("}], "b": [{"piece": ")" + b + R"(", "edge": ")" + eb + R"("}]})";
}

/// A request's body; all pieces lie at the origin. `post` is an asset that the project may use later, `start`
/// how the drape is to begin.
inline std::string dressed_pair(const std::string& post, const std::string& start = "auto") {
  return R"({"document": {"toile": 1, "name": "Skirt", "pieces": [)" +
         skirt_piece("front", "280", "250", "500") + ", " + skirt_piece("back", "280", "250", "500") + ", " +
         skirt_piece("band_front", "187", "187", "40") + ", " + skirt_piece("band_back", "187", "187", "40") +
         R"(], "fabrics": [{"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000,
      "stretch_weft_n_m": 1500, "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8,
      "bend_bias_un_m": 7, "thickness_mm": 0.4, "colour": [0.6, 0.1, 0.1]}], "seams": [)" +
         skirt_seam("left", "front", "e1", "back", "e3") + ", " +
         skirt_seam("right", "front", "e3", "back", "e1") + ", " +
         skirt_seam("band_left", "band_front", "e1", "band_back", "e3") + ", " +
         skirt_seam("band_right", "band_front", "e3", "band_back", "e1") + ", " +
         skirt_seam("waist_front", "band_front", "e0", "front", "e2") + ", " +
         skirt_seam("waist_back", "band_back", "e0", "back", "e2") +
         R"(], "bodies": [{"id": "anna", "mannequin": {"triangles": 1000}}],
      "settings": {"particle_distance_mm": 40, "start": ")" +
         start + R"("}}, "files": {"post.obj": ")" + post + R"("}})";
}

}  // namespace toile::test
