#include "core/collision/contact_finder.h"

#include <algorithm>
#include <utility>

#include "core/base/crew.h"

namespace toile::collision {

namespace {

using geometry::BoxGroups;

/// Features that are not worth a part of their own.
constexpr std::size_t kFewFeatures = 64;

std::vector<std::span<const Index>> in_parts(std::span<const Index> features, std::size_t parts) {
  const std::size_t count = std::min(parts, features.size() / kFewFeatures + 1);
  std::vector<std::span<const Index>> split;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t begin = features.size() * k / count, end = features.size() * (k + 1) / count;
    if (begin < end) split.push_back(features.subspan(begin, end - begin));
  }
  return split;
}

}  // namespace

template <typename Feature>
ContactFinder::Around ContactFinder::around_vertices(std::span<const Feature> features, Index vertex_count) {
  Around around;
  around.first.assign(static_cast<std::size_t>(vertex_count) + 1, 0);
  for (const Feature& feature : features) {
    for (const Index v : feature) ++around.first[v + 1];
  }
  for (std::size_t v = 1; v < around.first.size(); ++v) around.first[v] += around.first[v - 1];
  around.item.resize(static_cast<std::size_t>(around.first.back()));
  std::vector<Index> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t f = 0; f < features.size(); ++f) {
    for (const Index v : features[f]) around.item[next[v]++] = static_cast<Index>(f);
  }
  return around;
}

ContactFinder::ContactFinder(Surface cloth, std::span<const Obstacle> obstacles, ContactSettings settings)
    : cloth_(std::move(cloth)),
      obstacles_(obstacles),
      settings_(std::move(settings)),
      edges_at_(around_vertices(std::span<const std::array<Index, 2>>(cloth_.edges), cloth_.vertex_count())),
      faces_at_(around_vertices(std::span<const Tri>(cloth_.triangles), cloth_.vertex_count())),
      edge_moved_(cloth_.edges.size()),
      face_moved_(cloth_.triangles.size()) {
  for (const auto& [a, b] : cloth_.edges) {
    edge_classes_.push_back({cloth_.vertex_class[a], cloth_.vertex_class[b]});
  }
}

void ContactFinder::detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out,
                           Crew& crew) {
  out.clear(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    out.centre[v] = positions[v];
    out.trust_radius[v] = trust_radius(speeds[v]);
  }
  lay_all(out);
  touched_.assign(positions.size(), 1);
  std::vector<Look> looks;
  look_at_obstacles(crew.parts(), looks);
  look_at_itself(crew.parts(), looks);
  do_all(looks, positions, out, crew);
  out.follow(touched_, crew);
}

void ContactFinder::detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out) {
  Crew alone;
  detect(positions, speeds, out, alone);
}

void ContactFinder::detect_again(std::span<const Index> moved, std::span<const Vec3> positions,
                                 std::span<const double> speeds, Contacts& out, Crew& crew) {
  moved_.assign(positions.size(), 0);
  for (const Index v : moved) {
    moved_[v] = 1;
    out.centre[v] = positions[v];
    out.trust_radius[v] = trust_radius(speeds[v]);
  }
  touched_ = moved_;
  out.forget(moved_, touched_);
  lay_moved(moved, out);
  std::vector<Look> looks;
  look_at_obstacles_from(moved, crew.parts(), looks);
  look_at_itself_from(moved, crew.parts(), looks);
  do_all(looks, positions, out, crew);
  out.follow(touched_, crew);
}

void ContactFinder::detect_again(std::span<const Index> moved, std::span<const Vec3> positions,
                                 std::span<const double> speeds, Contacts& out) {
  Crew alone;
  detect_again(moved, positions, speeds, out, alone);
}

/// Side by side; then what they found, in their order.
void ContactFinder::do_all(const std::vector<Look>& looks, std::span<const Vec3> positions, Contacts& out,
                           Crew& crew) {
  if (finds_.size() < looks.size()) finds_.resize(looks.size());
  crew.each(static_cast<int>(looks.size()), [&](int i) {
    Find& find = finds_[static_cast<std::size_t>(i)];
    find.found.clear();
    find.edge_pairs.clear();
    PairMeasure measure(settings_, positions, out, find.found);
    looks[static_cast<std::size_t>(i)](measure, find.edge_pairs);
  });
  for (std::size_t i = 0; i < looks.size(); ++i) out.take(finds_[i].found, touched_);
}

void ContactFinder::resume(const Contacts& contacts) { lay_all(contacts); }

/// Two vertices whose pair is not listed may both use their trust regions whole, and must not touch even
/// then: half a floor stays free.
double ContactFinder::trust_radius(double speed) const {
  return std::clamp(1.5 * speed * settings_.trust_radius_seconds, settings_.trust_radius_least,
                    settings_.trust_radius_most) -
         0.5 * kContactFloor;
}

void ContactFinder::lay_vertex_box(Index v, const Contacts& at) {
  const double radius = at.trust_radius[v] + 0.5 * kContactFloor;
  boxes_.vertices[v] = geometry::box_around({at.centre[v]}, std::max(radius, 0.5 * settings_.thickness));
}

void ContactFinder::lay_edge_line(Index e, const Contacts& at) {
  const auto [a, b] = cloth_.edges[e];
  edge_lines_[e] = edge_line(at.centre[a], at.centre[b],
                             std::max(at.trust_radius[a], at.trust_radius[b]) + 0.5 * kContactFloor);
}

void ContactFinder::lay_all(const Contacts& at) {
  boxes_.vertices.resize(at.centre.size());
  for (const Index v : cloth_.vertices) lay_vertex_box(v, at);
  boxes_.lay_around(cloth_);
  edge_lines_.resize(cloth_.edges.size());
  for (std::size_t e = 0; e < edge_lines_.size(); ++e) lay_edge_line(static_cast<Index>(e), at);
}

void ContactFinder::lay_moved(std::span<const Index> moved, const Contacts& at) {
  const auto collect = [](std::span<const Index> features, std::vector<char>& marks,
                          std::vector<Index>& list) {
    for (const Index f : features) {
      if (std::exchange(marks[f], char{1}) == 0) list.push_back(f);
    }
  };
  for (const Index e : moved_edges_) edge_moved_[e] = 0;
  for (const Index t : moved_faces_) face_moved_[t] = 0;
  moved_edges_.clear();
  moved_faces_.clear();
  for (const Index v : moved) {
    if (faces_at_.of(v).empty()) continue;  // no feature
    lay_vertex_box(v, at);
    collect(edges_at_.of(v), edge_moved_, moved_edges_);
    collect(faces_at_.of(v), face_moved_, moved_faces_);
  }
  boxes_.lay_around(cloth_, moved, moved_edges_, moved_faces_);
  for (const Index e : moved_edges_) lay_edge_line(e, at);
}

bool ContactFinder::neighbours(Index vertex, const Tri& triangle) const {
  const Index mine = cloth_.vertex_class[vertex];
  return std::any_of(triangle.begin(), triangle.end(),
                     [&](Index v) { return cloth_.vertex_class[v] == mine; });
}

bool ContactFinder::neighbouring_edges(Index e, Index f) const {
  const auto [a0, a1] = edge_classes_[e];
  const auto [b0, b1] = edge_classes_[f];
  return (a0 == b0) | (a0 == b1) | (a1 == b0) | (a1 == b1);
}

void ContactFinder::look_at_obstacles(std::size_t parts, std::vector<Look>& looks) const {
  for (const Obstacle& obstacle : obstacles_) {
    const FeatureBoxes& theirs = obstacle.boxes;
    for (const BoxGroups::Part& part : boxes_.vertex_groups.parts(theirs.face_groups, parts)) {
      looks.emplace_back([this, &obstacle, part](PairMeasure& measure, std::vector<EdgePair>&) {
        boxes_.vertex_groups.pairs_in(part, obstacle.boxes.face_groups,
                                      [&](Index v, Index t) { measure.vertex_on_obstacle(obstacle, v, t); });
      });
    }
    for (const BoxGroups::Part& part : boxes_.face_groups.parts(theirs.vertex_groups, parts)) {
      looks.emplace_back([this, &obstacle, part](PairMeasure& measure, std::vector<EdgePair>&) {
        boxes_.face_groups.pairs_in(part, obstacle.boxes.vertex_groups, [&](Index t, Index v) {
          measure.obstacle_vertex_on_cloth(obstacle, v, cloth_.triangles[t]);
        });
      });
    }
    for (const BoxGroups::Part& part : boxes_.edge_groups.parts(theirs.edge_groups, parts)) {
      looks.emplace_back([this, &obstacle, part](PairMeasure& measure, std::vector<EdgePair>& pairs) {
        boxes_.edge_groups.pairs_in(part, obstacle.boxes.edge_groups,
                                    [&](Index e, Index f) { pairs.emplace_back(e, f); });
        measure_edges_on(obstacle, pairs, measure);
      });
    }
  }
}

void ContactFinder::look_at_itself(std::size_t parts, std::vector<Look>& looks) const {
  for (const BoxGroups::Part& part : boxes_.vertex_groups.parts(boxes_.face_groups, parts)) {
    looks.emplace_back([this, part](PairMeasure& measure, std::vector<EdgePair>&) {
      boxes_.vertex_groups.pairs_in(part, boxes_.face_groups, [&](Index v, Index t) {
        if (!neighbours(v, cloth_.triangles[t])) measure.vertex_on_cloth(v, cloth_.triangles[t]);
      });
    });
  }
  for (const BoxGroups::Part& part : boxes_.edge_groups.self_parts(parts)) {
    looks.emplace_back([this, part](PairMeasure& measure, std::vector<EdgePair>& pairs) {
      boxes_.edge_groups.self_pairs_in(part, [&](Index e, Index f) {
        if (!neighbouring_edges(e, f)) pairs.emplace_back(e, f);
      });
      measure_edges(pairs, measure);
    });
  }
}

void ContactFinder::look_at_obstacles_from(std::span<const Index> moved, std::size_t parts,
                                           std::vector<Look>& looks) const {
  for (const Obstacle& obstacle : obstacles_) {
    for (const auto vertices : in_parts(moved, parts)) {
      looks.emplace_back([this, &obstacle, vertices](PairMeasure& measure, std::vector<EdgePair>&) {
        for (const Index v : vertices) {
          obstacle.boxes.face_groups.query(boxes_.vertices[v],
                                           [&](Index t) { measure.vertex_on_obstacle(obstacle, v, t); });
        }
      });
    }
    for (const auto faces : in_parts(moved_faces_, parts)) {
      looks.emplace_back([this, &obstacle, faces](PairMeasure& measure, std::vector<EdgePair>&) {
        for (const Index t : faces) {
          obstacle.boxes.vertex_groups.query(boxes_.faces[t], [&](Index v) {
            measure.obstacle_vertex_on_cloth(obstacle, v, cloth_.triangles[t]);
          });
        }
      });
    }
    for (const auto edges : in_parts(moved_edges_, parts)) {
      looks.emplace_back([this, &obstacle, edges](PairMeasure& measure, std::vector<EdgePair>& pairs) {
        for (const Index e : edges)
          obstacle.boxes.edge_groups.query(boxes_.edges[e], [&](Index f) { pairs.emplace_back(e, f); });
        measure_edges_on(obstacle, pairs, measure);
      });
    }
  }
}

/// Each pair once: what moved on both sides is found from both.
void ContactFinder::look_at_itself_from(std::span<const Index> moved, std::size_t parts,
                                        std::vector<Look>& looks) const {
  for (const auto vertices : in_parts(moved, parts)) {
    looks.emplace_back([this, vertices](PairMeasure& measure, std::vector<EdgePair>&) {
      for (const Index v : vertices) {
        boxes_.face_groups.query(boxes_.vertices[v], [&](Index t) {
          if (!neighbours(v, cloth_.triangles[t])) measure.vertex_on_cloth(v, cloth_.triangles[t]);
        });
      }
    });
  }
  for (const auto faces : in_parts(moved_faces_, parts)) {
    looks.emplace_back([this, faces](PairMeasure& measure, std::vector<EdgePair>&) {
      for (const Index t : faces) {
        const Tri& triangle = cloth_.triangles[t];
        boxes_.vertex_groups.query(boxes_.faces[t], [&](Index v) {
          if (!moved_[v] && !neighbours(v, triangle)) measure.vertex_on_cloth(v, triangle);
        });
      }
    });
  }
  for (const auto edges : in_parts(moved_edges_, parts)) {
    looks.emplace_back([this, edges](PairMeasure& measure, std::vector<EdgePair>& pairs) {
      for (const Index e : edges) {
        boxes_.edge_groups.query(boxes_.edges[e], [&](Index f) {
          if ((edge_moved_[f] && f <= e) || neighbouring_edges(e, f)) return;
          pairs.emplace_back(e, f);
        });
      }
      measure_edges(pairs, measure);
    });
  }
}

void ContactFinder::measure_edges_on(const Obstacle& obstacle, std::span<const EdgePair> pairs,
                                     PairMeasure& measure) const {
  visit_near(pairs, edge_lines_, obstacle.edge_lines,
             [&](Index e, Index f) { measure.edge_on_obstacle(obstacle, cloth_.edges[e], f); });
}

void ContactFinder::measure_edges(std::span<const EdgePair> pairs, PairMeasure& measure) const {
  visit_near(pairs, edge_lines_, edge_lines_,
             [&](Index e, Index f) { measure.edges_of_cloth(cloth_.edges[e], cloth_.edges[f]); });
}

}  // namespace toile::collision
