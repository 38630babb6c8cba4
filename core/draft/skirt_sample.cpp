#include "core/draft/skirt_sample.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/body/measure/tape.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/dxf/write.h"

namespace toile::draft {
namespace {

constexpr double kSameEdge = 0.5;  // mm between the middles of an edge as drafted and as read

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// An edge as the DXF reader names it, and as the pattern does.
struct NamedEdge {
  std::string read, drafted;
};

Vec2 middle_of(const pattern::PanelEdge& edge) {
  return pattern::point_at_length(edge, pattern::arc_length(edge) / 2);
}

Result<std::vector<NamedEdge>> edge_names(const pattern::Panel& drafted, const dxf::DxfDrawing& drawing) {
  for (const dxf::DxfPiece& piece : drawing.pieces) {
    if (piece.name != drafted.id) continue;
    pattern::Panel read = TRY(dxf::panel_from_piece(piece));
    std::vector<NamedEdge> names;
    for (const pattern::PanelEdge& r : read.outline.edges) {
      for (const pattern::PanelEdge& d : drafted.outline.edges) {
        if (length(middle_of(r) - middle_of(d)) < kSameEdge) names.push_back({r.id, d.id});
      }
    }
    if (names.size() == drafted.outline.edges.size()) return names;
  }
  return Error{"draft.sample", "The DXF file does not give the piece's edges back.", "piece " + drafted.id};
}

/// A piece rolled around the body.
struct Wrap {
  double axis_z, radius, angle, height;  ///< m, degrees
  Vec2 anchor;                           ///< mm
  double slope;
};

std::string piece_json(const pattern::Panel& panel, const std::vector<NamedEdge>& names, const Wrap& w) {
  std::string edges;
  for (const NamedEdge& n : names)
    edges += (edges.empty() ? "" : ", ") + quoted(n.read) + ": " + quoted(n.drafted);
  return "    {\n      \"id\": " + quoted(panel.id) +
         ",\n      \"from\": {\"dxf\": \"skirt.dxf\", \"piece\": " + quoted(panel.id) +
         "},\n      \"edge_names\": {" + edges +
         "},\n      \"grain\": [0, 1],\n      \"fabric\": \"cotton\",\n      \"placement\": {\"wrapped\": "
         "{\"axis\": [0, " +
         fixed_text(w.axis_z, 4) + "], \"radius\": " + fixed_text(w.radius, 4) +
         ", \"angle\": " + fixed_text(w.angle, 0) + ", \"height\": " + fixed_text(w.height, 4) +
         ", \"anchor\": [" + fixed_text(w.anchor.x, 2) + ", " + fixed_text(w.anchor.y, 2) +
         "], \"slope\": " + fixed_text(w.slope, 6) + "}}\n    }";
}

std::string seam_json(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const auto side = [&](const pattern::SeamEdge& e) {
    const pattern::Panel& panel = pattern.panels[e.panel];
    return "[{\"piece\": " + quoted(panel.id) + ", \"edge\": " + quoted(panel.outline.edges[e.edge].id) +
           "}]";
  };
  return "    {\"id\": " + quoted(seam.id) + ", \"a\": " + side(seam.a[0]) + ", \"b\": " + side(seam.b[0]) +
         "}";
}

std::string joined(const std::vector<std::string>& items) {
  std::string out;
  for (size_t i = 0; i < items.size(); ++i) out += items[i] + (i + 1 < items.size() ? ",\n" : "\n");
  return out;
}

// A plain-woven cotton of middle weight; the project's own round figures.
constexpr const char* kFabric =
    R"(    {"id": "cotton", "name": "Plain-woven cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2500,
     "stretch_weft_n_m": 1800, "stretch_coupling_n_m": 400, "stretch_shear_n_m": 500, "bend_warp_un_m": 10,
     "bend_weft_un_m": 8, "bend_bias_un_m": 7, "thickness_mm": 0.4, "friction": 0.35,
     "colour": [0.62, 0.16, 0.14]}
)";

// Both bands keep their height until the skirt hangs from them.
constexpr const char* kAttachments =
    R"(    {"id": "hold_front", "piece": "band_front", "hold": "height", "release_after_s": 1},
    {"id": "hold_back", "piece": "band_back", "hold": "height", "release_after_s": 1}
)";

std::string project_json(const pattern::Pattern& pattern, const std::vector<std::string>& pieces,
                         const SkirtSampleSettings& settings) {
  std::vector<std::string> seams;
  for (const pattern::Seam& s : pattern.seams) seams.push_back(seam_json(pattern, s));
  return "{\n  \"toile\": 1,\n  \"name\": \"A-line skirt\",\n  \"pieces\": [\n" + joined(pieces) +
         "  ],\n  \"fabrics\": [\n" + kFabric + "  ],\n  \"seams\": [\n" + joined(seams) +
         "  ],\n  \"bodies\": [\n    {\"id\": \"body\", \"file\": \"body.obj\", \"unit\": \"m\"}\n  ],\n"
         "  \"attachments\": [\n" +
         kAttachments +
         "  ],\n  \"settings\": {\"particle_distance_mm\": " + fixed_text(settings.particle_distance_mm, 2) +
         "}\n}\n";
}

// Middle of the body's depth at a height, m.
double middle_z(const geometry::TriangleMesh& body, double height) {
  const double half = measure::half_breadth_at(body, height);  // leaves the arms out
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : body.vertices) {
    if (std::abs(p.y - height) > 0.03 || std::abs(p.x) > half) continue;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return (low + high) / 2;
}

std::vector<Wrap> wraps(const geometry::TriangleMesh& body, const SkirtSampleSettings& s) {
  const double waist = measure::trunk_girths(body).waist.height, z = middle_z(body, waist);
  const double band = waist - s.skirt.band_height / 2000, skirt = band - s.gap;
  // The cone whose apex is the pieces' own: their waist line then stands level.
  const double slope = 1000 * s.wrap_radius / skirt_waist_radius(s.skirt);
  const double front = skirt_middle(s.skirt, false), back = skirt_middle(s.skirt, true);
  const double low = skirt_band_bottom(s.skirt);
  return {{z, s.wrap_radius, 0, skirt, {front, 0}, slope},
          {z, s.wrap_radius, 180, skirt, {back, 0}, slope},
          {z, s.wrap_radius, 0, band, {front, low}, 0},
          {z, s.wrap_radius, 180, band, {back, low}, 0}};
}

}  // namespace

Result<std::vector<SampleFile>> make_skirt_sample(const geometry::TriangleMesh& body,
                                                  const SkirtSampleSettings& settings) {
  pattern::Pattern pattern = TRY(draft_skirt(settings.skirt));
  std::string dxf = TRY(dxf::write_dxf(pattern));
  dxf::DxfDrawing drawing = TRY(dxf::read_dxf(dxf));
  const std::vector<Wrap> placed = wraps(body, settings);
  std::vector<std::string> pieces;
  for (size_t i = 0; i < pattern.panels.size(); ++i) {
    std::vector<NamedEdge> names = TRY(edge_names(pattern.panels[i], drawing));
    pieces.push_back(piece_json(pattern.panels[i], names, placed[i]));
  }
  return std::vector<SampleFile>{{"skirt.dxf", dxf},
                                 {"project.json", project_json(pattern, pieces, settings)}};
}

}  // namespace toile::draft
