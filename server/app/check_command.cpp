#include <cmath>
#include <cstdio>
#include <span>

#include "core/base/aabb.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/drape/fit_start.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/project/resolve/resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/findings_text.h"
#include "server/app/mesh_fit.h"
#include "server/app/mesh_reader.h"

namespace toile::app {
namespace {

/// Breadth and height, mm.
Vec2 size_of(const pattern::Panel& panel) {
  constexpr double kTolerance = 0.1;  // mm
  return bounding_box(pattern::flatten(panel.outline, kTolerance)).size();
}

double area_cm2(const pattern::Panel& panel) {
  double area = pattern::signed_area(panel.outline);
  for (const pattern::Loop& hole : panel.holes) area -= std::abs(pattern::signed_area(hole));
  return area * 1e-2;
}

double series_length(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& series) {
  double sum = 0;
  for (const pattern::SeamEdge& edge : series) {
    const pattern::Panel& panel = pattern.panels[static_cast<std::size_t>(edge.panel)];
    sum += (edge.to - edge.from) *
           pattern::arc_length(*pattern::edges_of(panel)[static_cast<std::size_t>(edge.edge)]);
  }
  return sum;
}

double body_height(const body::Body& body) { return bounding_box(body.mesh.vertices).size().y; }

json::JsonValue piece_json(const pattern::Panel& panel) {
  std::vector<json::JsonValue> edges;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) {
    edges.push_back(std::vector<json::JsonMember>{{"id", edge->id},
                                                  {"length_mm", rounded(pattern::arc_length(*edge), 2)}});
  }
  const Vec2 size = size_of(panel);
  return std::vector<json::JsonMember>{{"id", panel.id},
                                       {"width_mm", rounded(size.x, 2)},
                                       {"height_mm", rounded(size.y, 2)},
                                       {"area_cm2", rounded(area_cm2(panel), 2)},
                                       {"edges", edges}};
}

json::JsonValue project_json(const drape::DrapeInput& input, const preflight::Findings& findings) {
  std::vector<json::JsonValue> pieces, seams, bodies, found;
  for (const preflight::Finding& f : findings) found.push_back(documents::finding_json(f));
  for (const pattern::Panel& panel : input.pattern.panels) pieces.push_back(piece_json(panel));
  for (const pattern::Seam& seam : input.pattern.seams) {
    seams.push_back(
        std::vector<json::JsonMember>{{"id", seam.id},
                                      {"length_a_mm", rounded(series_length(input.pattern, seam.a), 2)},
                                      {"length_b_mm", rounded(series_length(input.pattern, seam.b), 2)}});
  }
  for (const body::Body& body : input.bodies) {
    const std::vector<json::JsonValue> notes(body.notes.begin(), body.notes.end());
    bodies.push_back(
        std::vector<json::JsonMember>{{"id", body.id},
                                      {"triangles", static_cast<double>(body.mesh.triangles.size())},
                                      {"height_m", rounded(body_height(body), 2)},
                                      {"notes", notes}});
  }
  return std::vector<json::JsonMember>{{"name", input.name},
                                       {"pieces", pieces},
                                       {"seams", seams},
                                       {"bodies", bodies},
                                       {"mesh", mesh_fit_json(mesh_fit(input))},
                                       {"findings", found}};
}

void print_piece(const pattern::Panel& panel, const std::string& fabric) {
  const Vec2 size = size_of(panel);
  std::printf("piece %s: %s x %s mm, %s cm2, %s\n", panel.id.c_str(), fixed_text(size.x, 1).c_str(),
              fixed_text(size.y, 1).c_str(), fixed_text(area_cm2(panel), 0).c_str(), fabric.c_str());
  std::string edges;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) {
    edges += (edges.empty() ? "" : ", ") + edge->id + " " + fixed_text(pattern::arc_length(*edge), 1);
  }
  std::printf("  edges (mm): %s\n", edges.c_str());
}

void print_seam(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const double a = series_length(pattern, seam.a), b = series_length(pattern, seam.b);
  std::printf("seam %s: %s mm to %s mm", seam.id.c_str(), fixed_text(a, 1).c_str(), fixed_text(b, 1).c_str());
  if (std::abs(a - b) >= 0.05) std::printf(", %s mm eased in", fixed_text(std::abs(a - b), 1).c_str());
  std::printf("\n");
}

void print_project(const drape::DrapeInput& input) {
  if (!input.name.empty()) std::printf("%s\n", input.name.c_str());
  for (std::size_t i = 0; i < input.pattern.panels.size(); ++i) {
    const material::Fabric& fabric = input.fabrics[static_cast<std::size_t>(input.fabric_of_panel[i])];
    print_piece(input.pattern.panels[i], fabric.name.empty() ? fabric.id : fabric.name);
  }
  for (const pattern::Seam& seam : input.pattern.seams) print_seam(input.pattern, seam);
  for (const body::Body& body : input.bodies) {
    std::printf("body %s: %zu triangles, %s m high\n", body.id.c_str(), body.mesh.triangles.size(),
                fixed_text(body_height(body), 2).c_str());
    for (const std::string& note : body.notes) std::printf("body %s: %s\n", body.id.c_str(), note.c_str());
  }
  const std::string finer = mesh_fit_text(mesh_fit(input));
  if (!finer.empty()) std::printf("mesh: %s\n", finer.c_str());
}

}  // namespace

ExitCode check_command(const CheckOptions& options) {
  const Result<resolve::ResolvedProject> read = resolve::read_project(options.project, own_mesh_importer());
  if (!read) return fail(read.error(), options.json);
  const drape::DrapeInput& input = read->input;
  const Result<image::Textures> textures = resolve::read_textures(*read);
  if (!textures) return fail(textures.error(), options.json);
  const drape::DrapeInput worn = drape::worn_part(input);
  Result<drape::DrapeStart> start = drape::prepare_start(worn, {});
  if (!start) return fail(start.error(), options.json);
  if (preflight::first_error(start->findings)) drape::fit_start(worn, *start, {});
  if (options.json) {
    std::printf("%s", json::write_json(project_json(input, start->findings)).c_str());
  } else {
    print_project(input);
    print_findings(start->findings);
  }
  const std::optional<Error> refused = preflight::first_error(start->findings);
  return refused ? fail(*refused, options.json) : kDone;
}

}  // namespace toile::app
