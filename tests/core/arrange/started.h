#pragma once
// Garments arranged around a mannequin, and what the tests ask of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/arrange/arrange.h"
#include "core/body/measure/landmarks.h"
#include "core/body/mesh_import/load.h"
#include "core/collision/crossings.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/preflight/preflight.h"
#include "core/sewing/assembly.h"

namespace toile::test {

inline const body::Body& mannequin() {
  static const body::Body body{"mannequin",
                               mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value()};
  return body;
}

inline const measure::BodyFigure& figure() {
  static const measure::BodyFigure f = measure::find_figure(mannequin().mesh).value();
  return f;
}

/// A garment arranged and put together, nothing repaired.
struct Start {
  pattern::Pattern pattern;
  mesh::PanelMeshes meshes;
  arrange::Arrangement made;
  sewing::Assembly assembly;
};

inline Start started(pattern::Pattern pattern) {
  Start s;
  s.pattern = std::move(pattern);
  s.meshes = mesh::make_panel_meshes(s.pattern, 0.02, {}).value();
  const std::span<const body::Body> bodies(&mannequin(), 1);
  auto made = arrange::arrange({s.pattern, s.meshes, bodies});
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  if (!made.ok()) return s;
  s.made = std::move(*made);
  s.assembly = sewing::assemble(s.meshes, s.made.placements, s.made.attachments).value();
  return s;
}

inline std::string text_of(const preflight::Findings& findings) {
  std::string text;
  for (const preflight::Finding& f : findings) {
    text +=
        std::string(preflight::code_of(f.kind)) + " " + preflight::where_text(f) + ": " + f.message + "\n";
  }
  return text;
}

/// No error, nothing to repair, and the exact count finds no crossing.
inline void expect_clean(const Start& s) {
  for (const preflight::Finding& f : s.made.findings) {
    EXPECT_NE(f.severity, preflight::Severity::kError) << text_of(s.made.findings);
    EXPECT_FALSE(f.repaired) << text_of(s.made.findings);
    EXPECT_NE(f.kind, preflight::FindingKind::kRingAroundNothing) << preflight::where_text(f);
  }
  const sewing::GarmentMesh& g = s.assembly.garment;
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  const collision::CrossingBody body =
      collision::make_crossing_body(mannequin().mesh.vertices, mannequin().mesh.triangles);
  EXPECT_TRUE(collision::body_crossings(surface, s.assembly.positions, body).empty());
  EXPECT_TRUE(collision::self_crossings(surface, s.assembly.positions).empty());
}

inline Vec3 centre_of(const Start& s, Index panel) {
  const sewing::GarmentMesh& g = s.assembly.garment;
  Vec3 sum;
  for (Index v = g.first_vertex[panel]; v < g.first_vertex[panel + 1]; ++v) sum += s.assembly.positions[v];
  return sum * (1.0 / (g.first_vertex[panel + 1] - g.first_vertex[panel]));
}

/// The closed borders of the sewn garment, as classes of vertices in order.
inline std::vector<std::vector<Index>> rings(const sewing::GarmentMesh& g) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Tri& t : g.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index i = g.weld[t[k]], j = g.weld[t[(k + 1) % 3]];
      ++count[{std::min(i, j), std::max(i, j)}];
    }
  }
  std::map<Index, std::vector<Index>> next;
  for (const auto& [edge, times] : count) {
    if (times == 1) {
      next[edge.first].push_back(edge.second);
      next[edge.second].push_back(edge.first);
    }
  }
  std::vector<std::vector<Index>> found;
  std::set<Index> seen;
  for (const auto& [start, unused] : next) {
    if (seen.contains(start)) continue;
    std::vector<Index> ring;
    for (Index at = start, before = kNone; seen.insert(at).second;) {
      ring.push_back(at);
      const auto& ways = next[at];
      const Index to = ways[0] != before ? ways[0] : ways[1];
      before = at;
      at = to;
    }
    found.push_back(std::move(ring));
  }
  return found;
}

/// How often the ring goes around the line, counter-clockwise seen against `along`.
inline int winding(const Start& s, const std::vector<Index>& ring, Vec3 origin, Vec3 along) {
  const Vec3 y = normalized(along), z = normalized(Vec3{0, 0, 1} - y * y.z), x = cross(y, z);
  double sum = 0;
  const auto angle = [&](Index v) {
    const Vec3 d = s.assembly.positions[v] - origin;
    return std::atan2(dot(d, x), dot(d, z));
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += std::remainder(angle(ring[(i + 1) % ring.size()]) - angle(ring[i]), 2 * std::numbers::pi);
  }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

inline bool has_panel(const Start& s, const std::vector<Index>& ring, Index panel) {
  return std::any_of(ring.begin(), ring.end(),
                     [&](Index v) { return s.assembly.garment.panel_of_vertex[v] == panel; });
}

inline double longest_thread(const Start& s) {
  double most = 0;
  for (const auto& [a, b] : s.assembly.garment.sewn) {
    most = std::max(most, length(s.assembly.positions[a] - s.assembly.positions[b]));
  }
  return most;
}

}  // namespace toile::test
