#include "core/exports/write_obj.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <string_view>
#include <system_error>

#include "core/base/write_file.h"

namespace toile {
namespace {

constexpr int kSignificantDecimals = 9;
constexpr double kPieceGap = 0.05;  // m between the pieces of rest.obj

void append_number(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value + 0.0,  // -0.0 + 0.0 is 0.0
                                 std::chars_format::general, kSignificantDecimals);
  text.append(digits, end.ptr);
}

/// A line of numbers after its keyword.
void append_line(std::string& text, std::string_view keyword, std::initializer_list<double> numbers) {
  text += keyword;
  for (const double number : numbers) {
    text += ' ';
    append_number(text, number);
  }
  text += '\n';
}

void append_vertex(std::string& text, Vec3 p) { append_line(text, "v", {p.x, p.y, p.z}); }
void append_flat(std::string& text, Vec2 p) { append_line(text, "vt", {p.x, p.y}); }

void append_face(std::string& text, const Tri& t, bool flat = false) {
  text += 'f';
  for (const Index corner : t) {
    const std::string number = std::to_string(corner + 1);
    text += ' ' + number;
    if (flat) text += '/' + number;
  }
  text += '\n';
}

/// OBJ names end at a blank and cannot hold control characters.
std::string obj_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == 127) c = '_';
  }
  return name.empty() ? "_" : name;
}

Status check_mesh(std::span<const Vec3> positions, std::span<const Tri> triangles) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!is_finite(positions[v])) {
      return Error{"export.not_finite", "a vertex has no finite position; nothing was written",
                   "vertex " + std::to_string(v)};
    }
  }
  const auto count = static_cast<Index>(positions.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner < 0 || corner >= count) {
        return Error{"export.bad_index", "a triangle names a vertex that is not there",
                     "triangle " + std::to_string(t)};
      }
    }
  }
  return {};
}

Status check_panels(std::size_t position_count, std::size_t triangle_count, const ObjPanels& panels) {
  if (panels.names.empty()) return {};
  if (!panels.rest.empty() && panels.rest.size() != position_count) {
    return Error{"export.bad_index", "not every vertex has a flat place", ""};
  }
  if (panels.panel_of_triangle.size() != triangle_count) {
    return Error{"export.bad_index", "panels are named, but not every triangle has one", ""};
  }
  const auto count = static_cast<Index>(panels.names.size());
  for (std::size_t t = 0; t < triangle_count; ++t) {
    const Index panel = panels.panel_of_triangle[t];
    if (panel < 0 || panel >= count) {
      return Error{"export.bad_index", "a triangle names a panel that is not there",
                   "triangle " + std::to_string(t)};
    }
  }
  return {};
}

std::string obj_text(std::span<const Vec3> positions, std::span<const Tri> triangles,
                     const ObjPanels& panels) {
  std::string text;
  text.reserve(positions.size() * 40 + triangles.size() * 20);
  for (const Vec3& p : positions) append_vertex(text, p);
  if (panels.names.empty()) {
    for (const Tri& t : triangles) append_face(text, t);
    return text;
  }
  const bool flat = !panels.rest.empty();
  for (const Vec2& p : panels.rest) append_flat(text, p);
  std::vector<std::vector<Index>> of_panel(panels.names.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    of_panel[panels.panel_of_triangle[t]].push_back(static_cast<Index>(t));
  }
  for (std::size_t panel = 0; panel < of_panel.size(); ++panel) {
    if (of_panel[panel].empty()) continue;
    text += "o " + obj_name(panels.names[panel]) + '\n';
    for (const Index t : of_panel[panel]) append_face(text, triangles[t], flat);
  }
  return text;
}

Status check_garment(const GarmentMesh& garment, std::size_t position_count) {
  const std::size_t count = garment.rest.size();
  if (position_count != count || garment.panel_of_vertex.size() != count) {
    return Error{"export.bad_garment", "rest shape, panels and positions differ in their count of vertices",
                 ""};
  }
  const auto panel_count = static_cast<Index>(garment.first_vertex.size()) - 1;
  for (std::size_t v = 0; v < count; ++v) {
    if (garment.panel_of_vertex[v] < 0 || garment.panel_of_vertex[v] >= panel_count) {
      return Error{"export.bad_garment", "a vertex belongs to no panel", "vertex " + std::to_string(v)};
    }
  }
  const auto in_range = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < count; };
  for (std::size_t s = 0; s < garment.sewn.size(); ++s) {
    if (!in_range(garment.sewn[s][0]) || !in_range(garment.sewn[s][1])) {
      return Error{"export.bad_index", "a sewn pair names a vertex that is not there",
                   "pair " + std::to_string(s)};
    }
  }
  return {};
}

struct Extent {
  double low = 0, high = 0;
  bool used = false;
};

/// The flat pieces with z = 0, moved along x only: each starts a gap after the one before.
std::vector<Vec3> laid_out(const GarmentMesh& garment) {
  const std::size_t panel_count = garment.first_vertex.empty() ? 0 : garment.first_vertex.size() - 1;
  std::vector<Extent> extent(panel_count);
  for (std::size_t v = 0; v < garment.rest.size(); ++v) {
    Extent& e = extent[garment.panel_of_vertex[v]];
    const double x = garment.rest[v].x;
    e = e.used ? Extent{std::min(e.low, x), std::max(e.high, x), true} : Extent{x, x, true};
  }
  std::vector<double> shift(panel_count);
  double next = 0;
  for (std::size_t panel = 0; panel < panel_count; ++panel) {
    if (!extent[panel].used) continue;
    shift[panel] = next - extent[panel].low;
    next += extent[panel].high - extent[panel].low + kPieceGap;
  }
  std::vector<Vec3> flat(garment.rest.size());
  for (std::size_t v = 0; v < flat.size(); ++v) {
    flat[v] = {garment.rest[v].x + shift[garment.panel_of_vertex[v]], garment.rest[v].y, 0};
  }
  return flat;
}

Status write_bodies(const std::filesystem::path& path, std::span<const Body> bodies) {
  TriangleMesh all;
  for (const Body& body : bodies) {
    const auto first = static_cast<Index>(all.vertices.size());
    TRY(check_mesh(body.mesh.vertices, body.mesh.triangles));
    all.vertices.insert(all.vertices.end(), body.mesh.vertices.begin(), body.mesh.vertices.end());
    for (const Tri& t : body.mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return write_obj(path, all.vertices, all.triangles);
}

std::string sewn_text(const std::vector<std::array<Index, 2>>& sewn) {
  std::string text = "[";
  for (std::size_t s = 0; s < sewn.size(); ++s) {
    text += (s == 0 ? "[" : ",\n [") + std::to_string(sewn[s][0]) + ", " + std::to_string(sewn[s][1]) + "]";
  }
  return text + "]\n";
}

}  // namespace

Status write_obj(const std::filesystem::path& path, std::span<const Vec3> positions,
                 std::span<const Tri> triangles, const ObjPanels& panels) {
  TRY(check_mesh(positions, triangles));
  TRY(check_panels(positions.size(), triangles.size(), panels));
  return write_file(path, obj_text(positions, triangles, panels));
}

Status write_check_data(const std::filesystem::path& directory, const GarmentMesh& garment,
                        std::span<const Vec3> positions, std::span<const Body> bodies,
                        const ObjPanels& panels) {
  TRY(check_garment(garment, positions.size()));
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  if (failed)
    return Error{"export.write", "cannot make the directory: " + failed.message(), directory.string()};

  TRY(write_obj(directory / "rest.obj", laid_out(garment), garment.triangles));
  TRY(write_obj(directory / "final.obj", positions, garment.triangles, panels));
  TRY(write_bodies(directory / "body.obj", bodies));
  return write_file(directory / "sewn.json", sewn_text(garment.sewn));
}

}  // namespace toile
