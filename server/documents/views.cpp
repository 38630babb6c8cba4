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

namespace toile {
namespace {

constexpr double kFlatness_mm = 0.2;

/// To a hundredth of a millimetre: finer than any screen.
JsonValue point_json(Vec2 p) {
  return std::vector<JsonValue>{std::round(p.x * 100) / 100, std::round(p.y * 100) / 100};
}

JsonValue points_json(const std::vector<Vec2>& points) {
  std::vector<JsonValue> out;
  for (const Vec2 p : points) out.push_back(point_json(p));
  return out;
}

/// Thousandths: figures that an edit may be made of.
double fine(double value) { return std::round(value * 1000) / 1000 + 0.0; }

JsonValue fine_point(Vec2 p) { return std::vector<JsonValue>{fine(p.x), fine(p.y)}; }

JsonValue edge_json(const PanelEdge& edge, std::size_t loop) {
  std::vector<JsonValue> curves;
  for (const CubicBezier& c : edge.curves) {
    curves.push_back(
        std::vector<JsonValue>{fine_point(c.p0), fine_point(c.p1), fine_point(c.p2), fine_point(c.p3)});
  }
  return std::vector<JsonMember>{{"id", edge.id},
                                 {"points", points_json(flatten(edge, kFlatness_mm))},
                                 {"curves", std::move(curves)},
                                 {"length_mm", fine(arc_length(edge))},
                                 {"loop", static_cast<double>(loop)}};
}

JsonValue notch_json(const Notch& notch) {
  const bool turned = !(notch.inwards == Vec2{});
  return std::vector<JsonMember>{{"at", fine_point(notch.at)},
                                 {"depth_mm", fine(notch.depth)},
                                 {"inwards", turned ? fine_point(notch.inwards) : JsonValue()}};
}

JsonValue texture_json(const std::optional<ProjectTexture>& texture) {
  if (!texture) return JsonValue();
  return std::vector<JsonMember>{{"image", texture->image},
                                 {"scale_mm", texture->scale_mm},
                                 {"offset", std::vector<JsonValue>{texture->offset.x, texture->offset.y}},
                                 {"angle", texture->angle}};
}

JsonValue piece_json(const Panel& panel, const ProjectPiece& told, const Fabric& fabric) {
  std::vector<JsonValue> holes, edges, colour, notches, lines;
  for (const PanelEdge& edge : panel.outline.edges) edges.push_back(edge_json(edge, 0));
  for (std::size_t k = 0; k < panel.holes.size(); ++k) {
    holes.push_back(points_json(flatten(panel.holes[k], kFlatness_mm)));
    for (const PanelEdge& edge : panel.holes[k].edges) edges.push_back(edge_json(edge, k + 1));
  }
  for (const double channel : fabric.colour) colour.push_back(channel);
  for (const Notch& notch : panel.notches) notches.push_back(notch_json(notch));
  for (const InnerLine& line : panel.lines) {
    lines.push_back(std::vector<JsonMember>{
        {"id", line.id}, {"points", points_json(line.points)}, {"drawn", line.drawn}});
  }
  return std::vector<JsonMember>{{"id", panel.id},
                                 {"fabric", fabric.id},
                                 {"colour", std::move(colour)},
                                 {"grain", std::vector<JsonValue>{panel.grain.x, panel.grain.y}},
                                 {"outline", points_json(flatten(panel.outline, kFlatness_mm))},
                                 {"holes", std::move(holes)},
                                 {"edges", std::move(edges)},
                                 {"notches", std::move(notches)},
                                 {"texture", texture_json(told.texture)},
                                 {"lines", std::move(lines)}};
}

JsonValue series_json(const std::vector<ProjectSeamEdge>& series) {
  std::vector<JsonValue> out;
  for (const ProjectSeamEdge& edge : series) {
    out.push_back(std::vector<JsonMember>{{"piece", edge.piece},
                                          {"edge", edge.edge},
                                          {"reversed", edge.reversed},
                                          {"from", edge.from},
                                          {"to", edge.to}});
  }
  return out;
}

/// What is said of one seam.
JsonValue issues_json(const std::vector<SeamIssue>& issues, Index seam) {
  std::vector<JsonValue> out;
  for (const SeamIssue& issue : issues) {
    if (issue.seam != seam) continue;
    out.push_back(std::vector<JsonMember>{{"code", std::string(code_of(issue.kind))},
                                          {"error", is_error(issue.kind)},
                                          {"message", issue.message},
                                          {"where", issue.where}});
  }
  return out;
}

JsonValue seam_json(const Pattern& pattern, const Seam& seam, const ProjectSeam& told,
                    const std::vector<SeamIssue>& issues) {
  return std::vector<JsonMember>{
      {"id", told.id},
      {"a", series_json(told.a)},
      {"b", series_json(told.b)},
      {"same_direction", told.same_direction},
      {"length_a_mm", fine(series_length(pattern, seam.a))},
      {"length_b_mm", fine(series_length(pattern, seam.b))},
      {"issues", issues_json(issues, static_cast<Index>(&seam - pattern.seams.data()))}};
}

struct Read {
  Project project;
  DrapeInput input;
};

/// Bodies take long to make; a drawing of the pieces does without.
Result<Read> read(const std::string& document, const ProjectFiles& files, bool with_bodies) {
  Project project = TRY(parse_project(document));
  if (!with_bodies) project = without_bodies(std::move(project));
  DrapeInput input = TRY(resolve_project(project, files));
  return Read{std::move(project), std::move(input)};
}

void put(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((word >> shift) & 0xff);
}

void put(std::string& out, double value) {
  put(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace

Result<std::string> pieces_json(const std::string& document, const ProjectFiles& files) {
  const Read read_in = TRY(read(document, files, false));
  const DrapeInput& input = read_in.input;
  std::vector<JsonValue> pieces, seams;
  for (std::size_t i = 0; i < input.pattern.panels.size(); ++i) {
    const auto fabric = static_cast<std::size_t>(input.fabric_of_panel[i]);
    pieces.push_back(piece_json(input.pattern.panels[i], read_in.project.pieces[i], input.fabrics[fabric]));
  }
  const std::vector<SeamIssue> issues = check_seams(input.pattern);
  for (std::size_t i = 0; i < input.pattern.seams.size(); ++i) {
    seams.push_back(seam_json(input.pattern, input.pattern.seams[i], read_in.project.seams[i], issues));
  }
  return write_json_line(
             std::vector<JsonMember>{{"pieces", std::move(pieces)}, {"seams", std::move(seams)}}) +
         "\n";
}

Result<std::string> body_bytes(const std::string& document, const ProjectFiles& files) {
  const Read read_in = TRY(read(document, files, true));
  std::size_t vertices = 0, triangles = 0;
  for (const Body& body : read_in.input.bodies) {
    vertices += body.mesh.vertices.size();
    triangles += body.mesh.triangles.size();
  }
  std::string out;
  out.reserve(8 + 12 * (vertices + triangles));
  put(out, static_cast<std::uint32_t>(vertices));
  put(out, static_cast<std::uint32_t>(triangles));
  for (const Body& body : read_in.input.bodies) {
    for (const Vec3 p : body.mesh.vertices) {
      put(out, p.x);
      put(out, p.y);
      put(out, p.z);
    }
  }
  std::uint32_t first = 0;
  for (const Body& body : read_in.input.bodies) {
    for (const Tri& triangle : body.mesh.triangles) {
      for (const Index corner : triangle) put(out, first + static_cast<std::uint32_t>(corner));
    }
    first += static_cast<std::uint32_t>(body.mesh.vertices.size());
  }
  return out;
}

}  // namespace toile
