#include "server/documents/views.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pattern/curve.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/project.h"

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

JsonValue piece_json(const Panel& panel, const Fabric& fabric) {
  std::vector<JsonValue> holes, edges, colour;
  for (const Loop& hole : panel.holes) holes.push_back(points_json(flatten(hole, kFlatness_mm)));
  for (const PanelEdge* edge : edges_of(panel)) {
    edges.push_back(
        std::vector<JsonMember>{{"id", edge->id}, {"points", points_json(flatten(*edge, kFlatness_mm))}});
  }
  for (const double channel : fabric.colour) colour.push_back(channel);
  return std::vector<JsonMember>{{"id", panel.id},
                                 {"fabric", fabric.id},
                                 {"colour", std::move(colour)},
                                 {"grain", std::vector<JsonValue>{panel.grain.x, panel.grain.y}},
                                 {"outline", points_json(flatten(panel.outline, kFlatness_mm))},
                                 {"holes", std::move(holes)},
                                 {"edges", std::move(edges)}};
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

JsonValue seam_json(const ProjectSeam& seam) {
  return std::vector<JsonMember>{{"id", seam.id},
                                 {"a", series_json(seam.a)},
                                 {"b", series_json(seam.b)},
                                 {"same_direction", seam.same_direction}};
}

struct Read {
  Project project;
  DrapeInput input;
};

Result<Read> read(const std::string& document, const ProjectFiles& files) {
  Result<Project> project = parse_project(document);
  if (!project) return project.error();
  Result<DrapeInput> input = resolve_project(*project, files);
  if (!input) return input.error();
  return Read{std::move(*project), std::move(*input)};
}

void put(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((word >> shift) & 0xff);
}

void put(std::string& out, double value) {
  put(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace

Result<std::string> pieces_json(const std::string& document, const ProjectFiles& files) {
  const Result<Read> read_in = read(document, files);
  if (!read_in) return read_in.error();
  const DrapeInput& input = read_in->input;
  std::vector<JsonValue> pieces, seams;
  for (std::size_t i = 0; i < input.pattern.panels.size(); ++i) {
    const auto fabric = static_cast<std::size_t>(input.fabric_of_panel[i]);
    pieces.push_back(piece_json(input.pattern.panels[i], input.fabrics[fabric]));
  }
  for (const ProjectSeam& seam : read_in->project.seams) seams.push_back(seam_json(seam));
  return write_json_line(
             std::vector<JsonMember>{{"pieces", std::move(pieces)}, {"seams", std::move(seams)}}) +
         "\n";
}

Result<std::string> body_bytes(const std::string& document, const ProjectFiles& files) {
  const Result<Read> read_in = read(document, files);
  if (!read_in) return read_in.error();
  std::size_t vertices = 0, triangles = 0;
  for (const Body& body : read_in->input.bodies) {
    vertices += body.mesh.vertices.size();
    triangles += body.mesh.triangles.size();
  }
  std::string out;
  out.reserve(8 + 12 * (vertices + triangles));
  put(out, static_cast<std::uint32_t>(vertices));
  put(out, static_cast<std::uint32_t>(triangles));
  for (const Body& body : read_in->input.bodies) {
    for (const Vec3 p : body.mesh.vertices) put(out, p.x), put(out, p.y), put(out, p.z);
  }
  std::uint32_t first = 0;
  for (const Body& body : read_in->input.bodies) {
    for (const Tri& triangle : body.mesh.triangles) {
      for (const Index corner : triangle) put(out, first + static_cast<std::uint32_t>(corner));
    }
    first += static_cast<std::uint32_t>(body.mesh.vertices.size());
  }
  return out;
}

}  // namespace toile
