#include "server/documents/views.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/check.h"
#include "core/project/bodies.h"
#include "core/project/project.h"

namespace toile::documents {
namespace {

constexpr double kFlatness = 0.2;  // mm

/// To a hundredth of a millimetre: finer than any screen.
json::JsonValue point_json(Vec2 p) {
  return std::vector<json::JsonValue>{std::round(p.x * 100) / 100, std::round(p.y * 100) / 100};
}

json::JsonValue points_json(const std::vector<Vec2>& points) {
  std::vector<json::JsonValue> out;
  out.reserve(points.size());
  for (const Vec2 p : points) out.push_back(point_json(p));
  return out;
}

/// Thousandths: figures that an edit may be made of.
double fine(double value) { return std::round(value * 1000) / 1000 + 0.0; }

json::JsonValue fine_point(Vec2 p) { return std::vector<json::JsonValue>{fine(p.x), fine(p.y)}; }

json::JsonValue edge_json(const pattern::PanelEdge& edge, std::size_t loop) {
  std::vector<json::JsonValue> curves;
  for (const pattern::CubicBezier& c : edge.curves) {
    curves.push_back(
        std::vector<json::JsonValue>{fine_point(c.p0), fine_point(c.p1), fine_point(c.p2), fine_point(c.p3)});
  }
  return std::vector<json::JsonMember>{{"id", edge.id},
                                       {"points", points_json(pattern::flatten(edge, kFlatness))},
                                       {"curves", std::move(curves)},
                                       {"length_mm", fine(pattern::arc_length(edge))},
                                       {"loop", static_cast<double>(loop)}};
}

json::JsonValue notch_json(const pattern::Notch& notch) {
  const bool turned = !(notch.inwards == Vec2{});
  return std::vector<json::JsonMember>{{"at", fine_point(notch.at)},
                                       {"depth_mm", fine(notch.depth)},
                                       {"inwards", turned ? fine_point(notch.inwards) : json::JsonValue()}};
}

json::JsonValue piece_json(const pattern::Panel& panel, const project::ProjectPiece& told,
                           const material::Fabric& fabric) {
  std::vector<json::JsonValue> holes, edges, colour, notches, lines;
  for (const pattern::PanelEdge& edge : panel.outline.edges) edges.push_back(edge_json(edge, 0));
  for (std::size_t k = 0; k < panel.holes.size(); ++k) {
    holes.push_back(points_json(pattern::flatten(panel.holes[k], kFlatness)));
    for (const pattern::PanelEdge& edge : panel.holes[k].edges) edges.push_back(edge_json(edge, k + 1));
  }
  for (const double channel : fabric.colour) colour.push_back(channel);
  for (const pattern::Notch& notch : panel.notches) notches.push_back(notch_json(notch));
  for (const pattern::InnerLine& line : panel.lines) {
    lines.push_back(std::vector<json::JsonMember>{
        {"id", line.id}, {"points", points_json(line.points)}, {"drawn", line.drawn}});
  }
  return std::vector<json::JsonMember>{{"id", panel.id},
                                       {"fabric", fabric.id},
                                       {"colour", std::move(colour)},
                                       {"grain", std::vector<json::JsonValue>{panel.grain.x, panel.grain.y}},
                                       {"outline", points_json(pattern::flatten(panel.outline, kFlatness))},
                                       {"holes", std::move(holes)},
                                       {"edges", std::move(edges)},
                                       {"notches", std::move(notches)},
                                       {"texture", texture_json(told.texture)},
                                       {"lines", std::move(lines)}};
}

json::JsonValue series_json(const std::vector<project::ProjectSeamEdge>& series) {
  std::vector<json::JsonValue> out;
  out.reserve(series.size());
  for (const project::ProjectSeamEdge& edge : series) {
    out.push_back(std::vector<json::JsonMember>{{"piece", edge.piece},
                                                {"edge", edge.edge},
                                                {"reversed", edge.reversed},
                                                {"from", edge.from},
                                                {"to", edge.to}});
  }
  return out;
}

/// What is said of one seam.
json::JsonValue issues_json(const std::vector<seams::SeamIssue>& issues, Index seam) {
  std::vector<json::JsonValue> out;
  for (const seams::SeamIssue& issue : issues) {
    if (issue.seam != seam) continue;
    out.push_back(std::vector<json::JsonMember>{{"code", std::string(seams::code_of(issue.kind))},
                                                {"error", seams::is_error(issue.kind)},
                                                {"message", issue.message},
                                                {"where", issue.where}});
  }
  return out;
}

json::JsonValue seam_json(const pattern::Pattern& pattern, const pattern::Seam& seam,
                          const project::ProjectSeam& told, const std::vector<seams::SeamIssue>& issues) {
  return std::vector<json::JsonMember>{
      {"id", told.id},
      {"a", series_json(told.a)},
      {"b", series_json(told.b)},
      {"same_direction", told.same_direction},
      {"length_a_mm", fine(seams::series_length(pattern, seam.a))},
      {"length_b_mm", fine(seams::series_length(pattern, seam.b))},
      {"issues", issues_json(issues, static_cast<Index>(&seam - pattern.seams.data()))}};
}

void put(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((word >> shift) & 0xff);
}

void put(std::string& out, double value) {
  put(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace

json::JsonValue texture_json(const std::optional<project::ProjectTexture>& texture) {
  if (!texture) return json::JsonValue();
  return std::vector<json::JsonMember>{
      {"image", texture->image},
      {"scale_mm", texture->scale_mm},
      {"offset", std::vector<json::JsonValue>{texture->offset.x, texture->offset.y}},
      {"angle", texture->angle}};
}

std::string pieces_json(const ReadCloth& read) {
  const drape::DrapeInput& input = read.cloth;
  std::vector<json::JsonValue> pieces, seams;
  for (std::size_t i = 0; i < input.pattern.panels.size(); ++i) {
    const auto fabric = static_cast<std::size_t>(input.fabric_of_panel[i]);
    pieces.push_back(piece_json(input.pattern.panels[i], read.project.pieces[i], input.fabrics[fabric]));
  }
  const std::vector<seams::SeamIssue> issues = seams::check_seams(input.pattern);
  for (std::size_t i = 0; i < input.pattern.seams.size(); ++i) {
    seams.push_back(seam_json(input.pattern, input.pattern.seams[i], read.project.seams[i], issues));
  }
  return json::write_json_line(
             std::vector<json::JsonMember>{{"pieces", std::move(pieces)},
                                           {"seams", std::move(seams)},
                                           {"solver", read.project.settings.solver},
                                           {"max_time_s", read.project.settings.max_time_s}}) +
         "\n";
}

bool has_moving_bodies(const std::string& document) {
  const Result<project::Project> project = project::parse_project(document);
  return project && std::any_of(project->bodies.begin(), project->bodies.end(),
                                [](const project::ProjectBody& body) { return !body.motion.empty(); });
}

Result<std::string> body_bytes(const std::string& document, const resolve::ProjectFiles& files) {
  const project::Project project = TRY(project::parse_project(document));
  drape::DrapeInput input = TRY(resolve::resolve_project(project, files));
  std::vector<geometry::TriangleMesh> meshes;
  for (body::Body& body : input.bodies) meshes.push_back(std::move(body.mesh));
  return mesh_bytes(meshes);
}

std::string mesh_bytes(std::span<const geometry::TriangleMesh> meshes) {
  std::size_t vertices = 0, triangles = 0;
  for (const geometry::TriangleMesh& mesh : meshes) {
    vertices += mesh.vertices.size();
    triangles += mesh.triangles.size();
  }
  std::string out;
  out.reserve(8 + 12 * (vertices + triangles));
  put(out, static_cast<std::uint32_t>(vertices));
  put(out, static_cast<std::uint32_t>(triangles));
  for (const geometry::TriangleMesh& mesh : meshes) {
    for (const Vec3 p : mesh.vertices) {
      put(out, p.x);
      put(out, p.y);
      put(out, p.z);
    }
  }
  std::uint32_t first = 0;
  for (const geometry::TriangleMesh& mesh : meshes) {
    for (const Tri& triangle : mesh.triangles) {
      for (const Index corner : triangle) put(out, first + static_cast<std::uint32_t>(corner));
    }
    first += static_cast<std::uint32_t>(mesh.vertices.size());
  }
  return out;
}

}  // namespace toile::documents
