#include "server/render/surface_vertices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/mesh/vertex_normals.h"

namespace toile::render {
namespace {

constexpr float kSeamStrength = 0.62f;
constexpr float kHemStrength = 0.30f;
constexpr float kOpenStrength = -0.95f;  // below 0: in red
constexpr double kOpen = 2e-3;           // m that the sides of a seam are apart that did not close
constexpr float kFarFromLine = 1.0f;     // m: a line that the triangle does not have

using Edge = std::pair<Index, Index>;
Edge edge_key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// Of each vertex: whether it is sewn to one that it did not come to.
std::vector<char> open_vertices(const ClothView& cloth) {
  std::vector<char> open(cloth.positions.size(), 0);
  for (std::size_t v = 0; v < cloth.weld.size(); ++v)
    if (length(cloth.positions[v] - cloth.positions[cloth.weld[v]]) > kOpen)
      open[cloth.weld[v]] = open[v] = 1;
  return open;
}

/// Edges of one triangle only, with how dark their line is.
std::map<Edge, float> border_edges(const ClothView& cloth) {
  std::map<Edge, int> uses, joint_uses;
  for (const Tri& t : cloth.triangles) {
    for (int i = 0; i < 3; ++i) ++uses[edge_key(t[i], t[(i + 1) % 3])];
  }
  const auto joint = [&](const Edge& e) {
    return cloth.weld.empty() ? e : edge_key(cloth.weld[e.first], cloth.weld[e.second]);
  };
  for (const auto& [edge, count] : uses) {
    if (count == 1) ++joint_uses[joint(edge)];
  }
  const std::vector<char> open = open_vertices(cloth);
  std::map<Edge, float> border;
  for (const auto& [edge, count] : uses) {
    if (count != 1) continue;
    const bool sewn = joint_uses[joint(edge)] > 1;
    const bool apart = sewn && open[edge.first] && open[edge.second];
    border[edge] = apart ? kOpenStrength : sewn ? kSeamStrength : kHemStrength;
  }
  return border;
}

/// The border around a vertex: the strongest line that meets it, and where the line runs.
struct BorderVertex {
  float strength = 0;
  Vec3 along;
};

std::vector<BorderVertex> border_vertices(const ClothView& cloth, const std::map<Edge, float>& border) {
  std::vector<BorderVertex> vertices(cloth.positions.size());
  for (const auto& [edge, strength] : border) {
    const Vec3 along = normalized(cloth.positions[edge.second] - cloth.positions[edge.first]);
    for (const Index v : {edge.first, edge.second}) {
      BorderVertex& at = vertices[v];
      if (std::abs(strength) < std::abs(at.strength)) continue;
      if (std::abs(strength) > std::abs(at.strength)) at = {strength, {}};
      at.along += dot(at.along, along) < 0 ? -along : along;
    }
  }
  return vertices;
}

/// Distance of `p` from the line through `origin` along `direction`.
double distance_from_line(Vec3 p, Vec3 origin, Vec3 direction) {
  return length(cross(p - origin, normalized(direction)));
}

class LineMarker {
 public:
  explicit LineMarker(const ClothView& cloth)
      : cloth_(cloth), border_(border_edges(cloth)), vertices_(border_vertices(cloth, border_)) {}

  /// Line i of a triangle belongs to the edge opposite corner i, or to the border that passes corner i.
  void mark(const Tri& t, ClothVertex (&corners)[3]) const {
    for (ClothVertex& c : corners) {
      std::fill_n(c.line_distance, 3, kFarFromLine);
      std::fill_n(c.line_strength, 3, 0.0f);
    }
    bool on_edge = false;
    for (int i = 0; i < 3; ++i) on_edge |= mark_edge(t, i, corners);
    for (int i = 0; !on_edge && i < 3; ++i) mark_corner(t, i, corners);
  }

 private:
  bool mark_edge(const Tri& t, int i, ClothVertex (&corners)[3]) const {
    const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
    const auto found = border_.find(edge_key(a, b));
    if (found == border_.end()) return false;
    const Vec3 pa = cloth_.positions[a], pb = cloth_.positions[b];
    for (int k = 0; k < 3; ++k) {
      corners[k].line_distance[i] =
          k == i ? static_cast<float>(distance_from_line(cloth_.positions[t[i]], pa, pb - pa)) : 0;
      corners[k].line_strength[i] = found->second;
    }
    return true;
  }

  void mark_corner(const Tri& t, int i, ClothVertex (&corners)[3]) const {
    const BorderVertex& at = vertices_[t[i]];
    if (at.strength == 0) return;
    for (int k = 0; k < 3; ++k) {
      corners[k].line_distance[i] =
          static_cast<float>(distance_from_line(cloth_.positions[t[k]], cloth_.positions[t[i]], at.along));
      corners[k].line_strength[i] = at.strength;
    }
  }

  const ClothView& cloth_;
  std::map<Edge, float> border_;
  std::vector<BorderVertex> vertices_;
};

void set(float (&out)[3], Vec3 v) {
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}

Index panel_of(const ClothView& cloth, std::size_t triangle) {
  return cloth.panel_of_triangle.empty() ? 0 : cloth.panel_of_triangle[triangle];
}

/// The picture on a triangle's panel, or null.
const image::PanelTexture* texture_on(const ClothView& cloth, std::size_t triangle) {
  if (cloth.textures == nullptr || cloth.rest.empty()) return nullptr;
  return image::texture_of(*cloth.textures, panel_of(cloth, triangle));
}

Index image_on(const ClothView& cloth, std::size_t triangle) {
  const image::PanelTexture* const texture = texture_on(cloth, triangle);
  return texture == nullptr ? kNone : texture->image;
}

std::vector<std::size_t> drawing_order(const ClothView& cloth) {
  std::vector<std::size_t> order(cloth.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return image_on(cloth, a) < image_on(cloth, b); });
  return order;
}

LinearRgb colour_of(const ClothView& cloth, std::size_t triangle) {
  const Index panel = panel_of(cloth, triangle);
  const bool known = panel >= 0 && static_cast<std::size_t>(panel) < cloth.colour_of_panel.size();
  return known ? cloth.colour_of_panel[panel] : kClothColour;
}

}  // namespace

std::vector<ClothVertex> cloth_vertices(const ClothView& cloth) {
  const std::vector<Vec3> normals = mesh::vertex_normals(cloth.positions, cloth.triangles, cloth.weld);
  const LineMarker lines(cloth);
  std::vector<ClothVertex> out;
  out.reserve(cloth.triangles.size() * 3);
  for (const std::size_t t : drawing_order(cloth)) {
    const LinearRgb colour = colour_of(cloth, t);
    const image::PanelTexture* const texture = texture_on(cloth, t);
    ClothVertex corners[3];
    for (int i = 0; i < 3; ++i) {
      const Index v = cloth.triangles[t][i];
      set(corners[i].position, cloth.positions[v]);
      set(corners[i].normal, normals[v]);
      set(corners[i].colour, {colour[0], colour[1], colour[2]});
      const Vec2 rest = cloth.rest.empty() ? Vec2{} : cloth.rest[v];
      corners[i].rest[0] = static_cast<float>(rest.x);
      corners[i].rest[1] = static_cast<float>(rest.y);
      const Vec2 repeats = texture == nullptr ? Vec2{} : image::texture_at(*texture, rest);
      corners[i].picture_at[0] = static_cast<float>(repeats.x);
      corners[i].picture_at[1] = static_cast<float>(1 - repeats.y);
    }
    lines.mark(cloth.triangles[t], corners);
    out.insert(out.end(), corners, corners + 3);
  }
  return out;
}

std::vector<ClothRun> cloth_runs(const ClothView& cloth) {
  std::vector<ClothRun> runs;
  for (const std::size_t t : drawing_order(cloth)) {
    const Index image = image_on(cloth, t);
    if (runs.empty() || runs.back().image != image)
      runs.push_back({image, runs.empty() ? 0 : runs.back().first + runs.back().count, 0});
    runs.back().count += 3;
  }
  return runs;
}

std::vector<BodyVertex> body_vertices(const geometry::TriangleMesh& mesh) {
  const std::vector<Vec3> normals = mesh::vertex_normals(mesh.vertices, mesh.triangles);
  std::vector<BodyVertex> out(mesh.vertices.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    set(out[v].position, mesh.vertices[v]);
    set(out[v].normal, normals[v]);
  }
  return out;
}

}  // namespace toile::render
