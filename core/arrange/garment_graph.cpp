#include "core/arrange/garment_graph.h"

#include <algorithm>
#include <functional>

#include "core/arrange/piece_cover.h"
#include "core/geometry/polygon2.h"
#include "core/mesh/sewn_part.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::arrange {

namespace {

constexpr double kAlike = 0.01;      ///< relative
constexpr double kDartPoint = 2e-3;  ///< m; a dart's sides end that near to each other
constexpr double kLeastLimb = 0.12;  ///< m; nothing is worn around less
constexpr std::size_t kSamples = 96;

/// Number of each vertex along its panel's outline, kNone inside.
std::vector<Index> outline_numbers(const pattern::Panel& panel, const mesh::PanelMesh& mesh,
                                   GarmentPiece& piece) {
  std::vector<Index> number(mesh.rest.size(), kNone);
  Index next = 0;
  for (std::size_t e = 0; e < panel.outline.edges.size(); ++e) {
    const std::vector<Index>& line = mesh.edge_vertices[e];
    piece.corners.push_back(mesh.rest[line.front()]);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      number[line[i]] = next++;
      piece.outline.push_back(mesh.rest[line[i]]);
      piece.edge_of.push_back(static_cast<Index>(e));
    }
  }
  return number;
}

void measure(GarmentPiece& piece) {
  double area = 0;
  Vec2 sum;
  for (std::size_t i = 0; i < piece.outline.size(); ++i) {
    const Vec2 p = piece.outline[i], q = piece.outline[(i + 1) % piece.outline.size()];
    area += cross(p, q);
    sum = sum + (p + q) * cross(p, q);
  }
  piece.area = area / 2;
  piece.centroid = area != 0 ? sum * (1 / (3 * area)) : piece.outline.front();
}

/// A run of stitches between the same two pieces.
struct TieRun {
  std::vector<mesh::SewnPair> pairs;
  Index seam = kNone;
};

std::vector<TieRun> runs_of(const mesh::PanelMeshes& meshes) {
  std::vector<TieRun> runs;
  for (const mesh::MatchedSeam& seam : meshes.seams) {
    const mesh::SewnPair* before = nullptr;
    for (const mesh::SewnPair& pair : seam.pairs) {
      const bool goes_on =
          before != nullptr && before->a.panel == pair.a.panel && before->b.panel == pair.b.panel;
      if (!goes_on) runs.push_back({{}, seam.seam});
      runs.back().pairs.push_back(pair);
      before = &pair;
    }
  }
  return runs;
}

/// Between the sides of a dart there is no cloth; between those of a leg's inner seam, which narrows as much
/// towards the hem, there is.
bool is_dart(const TieRun& run, const mesh::PanelMeshes& meshes, const std::vector<GarmentPiece>& pieces) {
  const auto gap = [&](const mesh::SewnPair& p) {
    const std::vector<Vec2>& rest = meshes.panels[p.a.panel].rest;
    return length(rest[p.a.vertex] - rest[p.b.vertex]);
  };
  const mesh::SewnPair &first = run.pairs.front(), &last = run.pairs.back();
  if (first.a.panel != first.b.panel) return false;
  const std::vector<Vec2>& rest = meshes.panels[first.a.panel].rest;
  const double long_side = length(rest[first.a.vertex] - rest[last.a.vertex]);
  // The stitch in a dart's point joins a vertex to itself and is left out, so the last one has some width.
  const double narrow = std::min(gap(first), gap(last));
  if (narrow >= std::max(kDartPoint, 0.35 * long_side)) return false;
  if (narrow < kLeastLimb) return true;
  const mesh::SewnPair& wide = gap(first) > gap(last) ? first : last;
  const Vec2 between = (rest[wide.a.vertex] + rest[wide.b.vertex]) * 0.5;
  return !geometry::contains(pieces[first.a.panel].outline, between);
}

/// 1 where the run's sides go against each other along the outlines, so that both right sides are outside or
/// both inside; -1 where one is turned; 0 when it is too short to tell.
int parity_of(const TieRun& run, const std::vector<std::vector<Index>>& numbers,
              const std::vector<GarmentPiece>& pieces) {
  const auto step = [&](mesh::PanelVertex from, mesh::PanelVertex to) {
    const Index i = numbers[from.panel][from.vertex], j = numbers[to.panel][to.vertex];
    const Index count = static_cast<Index>(pieces[from.panel].outline.size());
    if (i == kNone || j == kNone || i == j) return 0;
    return (j - i + count) % count < count / 2 ? 1 : -1;
  };
  int votes = 0;
  for (std::size_t k = 1; k < run.pairs.size(); ++k) {
    votes -= step(run.pairs[k - 1].a, run.pairs[k].a) * step(run.pairs[k - 1].b, run.pairs[k].b);
  }
  return votes > 0 ? 1 : votes < 0 ? -1 : 0;
}

/// Spreads the first piece's side over all that hang together by seams.
void find_outsides(const std::vector<std::array<Index, 3>>& parities, std::vector<GarmentPiece>& pieces) {
  std::vector<bool> known(pieces.size(), false);
  for (std::size_t root = 0; root < pieces.size(); ++root) {
    if (known[root]) continue;
    known[root] = true;
    std::vector<Index> open{static_cast<Index>(root)}, group;
    while (!open.empty()) {
      const Index p = open.back();
      open.pop_back();
      group.push_back(p);
      for (const auto& [a, b, sign] : parities) {
        const Index other = a == p ? b : b == p ? a : kNone;
        if (other == kNone || known[other] || sign == 0) continue;
        known[other] = true;
        pieces[other].outside = pieces[p].outside * sign;
        open.push_back(other);
      }
    }
    // Patterns are drawn with the right side up: the majority is, and of halves the fronts.
    double votes = 0;
    for (const Index p : group) votes += pieces[p].outside * (1 + 0.1 * pieces[p].face) * pieces[p].area;
    if (votes < 0) {
      for (const Index p : group) pieces[p].outside = -pieces[p].outside;
    }
  }
}

/// Points evenly along the outline, from corner `start` on, the way the outline runs or backwards.
std::vector<Vec2> around(const GarmentPiece& piece, Vec2 start, bool backwards) {
  std::vector<Vec2> line = piece.outline;
  if (backwards) std::reverse(line.begin(), line.end());
  const auto first = std::find(line.begin(), line.end(), start);
  std::rotate(line.begin(), first == line.end() ? line.begin() : first, line.end());
  line.push_back(line.front());
  const double step = geometry::polyline_length(line) / kSamples;
  std::vector<Vec2> out;
  double at = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double l = length(line[i + 1] - line[i]);
    for (; out.size() < kSamples && static_cast<double>(out.size()) * step <= at + l && l > 0;) {
      out.push_back(line[i] + (line[i + 1] - line[i]) * ((static_cast<double>(out.size()) * step - at) / l));
    }
    at += l;
  }
  while (out.size() < kSamples) out.push_back(line.back());
  return out;
}

double size_of(const GarmentPiece& piece) {
  const Vec2 s = bounding_box(piece.outline).size();
  return std::max(s.x, s.y);
}

/// The move from `points` to the run of `to` that begins at `start`, when it fits.
std::optional<FlatFit> fit_at(const std::vector<Vec2>& points, const GarmentPiece& to, Vec2 start,
                              bool mirrored) {
  const FlatFit fit = fit_move(points, around(to, start, mirrored), mirrored);
  return fit.rms < kAlike * size_of(to) ? std::optional(fit) : std::nullopt;
}

/// Yokes are of the shoulders by their name; where nothing else covers trunk, arms or neck, and legs or a
/// skirt are there, they are of these, and where nothing else tells what it covers, their name does not
/// either.
void lower_yokes(const std::vector<seams::PieceWords>& words, std::vector<GarmentPiece>& pieces) {
  bool upper = false, lower = false;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Cover c = pieces[p].cover;
    upper = upper || c == Cover::kSleeve || c == Cover::kCollar || c == Cover::kHood ||
            (c == Cover::kTorso && !words[p].yoke);
    lower = lower || c == Cover::kLeg || c == Cover::kSkirt;
  }
  if (upper) return;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (words[p].yoke && pieces[p].cover == Cover::kTorso)
      pieces[p].cover = lower ? Cover::kSkirt : Cover::kUnknown;
}

}  // namespace

GarmentGraph make_garment_graph(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes) {
  GarmentGraph graph;
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  std::vector<std::vector<Index>> numbers;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    GarmentPiece piece;
    piece.id = pattern.panels[p].id;
    numbers.push_back(outline_numbers(pattern.panels[p], meshes.panels[p], piece));
    measure(piece);
    piece.sewn.assign(piece.outline.size(), false);
    piece.grain = meshes.panels[p].warp;
    piece.strap = words[p].kind == seams::PieceKind::kStrap;
    piece.cover = words[p].guessed ? cover_of_kind(words[p].kind) : cover_of_name(piece.id);
    piece.face = words[p].guessed ? words[p].face : face_of_name(piece.id);
    piece.hand = -words[p].side;
    graph.pieces.push_back(std::move(piece));
  }
  lower_yokes(words, graph.pieces);
  for (const mesh::MatchedSeam& seam : meshes.seams) {
    for (const mesh::SewnPair& pair : seam.pairs) {
      for (const mesh::PanelVertex& v : {pair.a, pair.b}) {
        if (const Index i = numbers[v.panel][v.vertex]; i != kNone) graph.pieces[v.panel].sewn[i] = true;
      }
    }
  }
  std::vector<std::array<Index, 3>> parities;
  for (const TieRun& run : runs_of(meshes)) {
    const Index a = run.pairs.front().a.panel, b = run.pairs.front().b.panel;
    if (is_dart(run, meshes, graph.pieces)) continue;
    if (a == b) graph.pieces[a].tube = true;
    parities.push_back({a, b, a == b ? 0 : parity_of(run, numbers, graph.pieces)});
    for (const mesh::SewnPair& pair : run.pairs) {
      graph.ties.push_back(
          {a, b, meshes.panels[a].rest[pair.a.vertex], meshes.panels[b].rest[pair.b.vertex], run.seam});
    }
  }
  find_outsides(parities, graph.pieces);
  const std::vector<mesh::SewnPart> parts = mesh::sewn_parts(meshes);
  const auto largest =
      std::max_element(parts.begin(), parts.end(),
                       [](const mesh::SewnPart& a, const mesh::SewnPart& b) { return a.area < b.area; });
  if (largest != parts.end()) graph.borders = largest->borders;
  return graph;
}

std::vector<FlatMove> ways_to_lay_on(const GarmentPiece& from, const GarmentPiece& to, bool mirrored) {
  if (std::abs(from.area - to.area) > 2 * kAlike * to.area) return {};
  const std::vector<Vec2> points = around(from, from.corners.front(), false);
  std::vector<FlatFit> fits;
  for (const Vec2 start : to.corners)
    if (const auto fit = fit_at(points, to, start, mirrored)) fits.push_back(*fit);
  std::stable_sort(fits.begin(), fits.end(),
                   [](const FlatFit& a, const FlatFit& b) { return a.rms < b.rms; });
  std::vector<FlatMove> ways;
  ways.reserve(fits.size());
  for (const FlatFit& fit : fits) ways.push_back(fit.move);
  return ways;
}

std::optional<FlatMove> lay_on(const GarmentPiece& from, const GarmentPiece& to, bool mirrored) {
  const std::vector<FlatMove> ways = ways_to_lay_on(from, to, mirrored);
  return ways.empty() ? std::nullopt : std::optional(ways.front());
}

bool sewn_around(const GarmentGraph& graph, Index piece, Index other) {
  constexpr double kOneSided = 0.4;
  const GarmentPiece& own = graph.pieces[static_cast<size_t>(piece)];
  // In parts of its extent along its grain and across: of a strip, too, one long edge lies on one side.
  const auto along_grain = [&](Vec2 p) { return Vec2{cross(p, own.grain), dot(p, own.grain)}; };
  std::vector<Vec2> outline;
  for (const Vec2 p : own.outline) outline.push_back(along_grain(p));
  const Vec2 size = bounding_box(outline).size();
  Vec2 sum;
  int count = 0;
  for (const GarmentTie& t : graph.ties) {
    if (std::minmax(t.a, t.b) != std::minmax(piece, other)) continue;
    const Vec2 off = along_grain((t.a == piece ? t.at_a : t.at_b) - own.centroid);
    const Vec2 d{off.x / size.x, off.y / size.y};
    if (const double l = std::sqrt(d.x * d.x + d.y * d.y); l > 0) {
      sum = sum + d * (1 / l);
      ++count;
    }
  }
  return count > 0 && std::sqrt(sum.x * sum.x + sum.y * sum.y) < kOneSided * count;
}

Index mirror_partner(const GarmentGraph& graph, Index piece) {
  const GarmentPiece& own = graph.pieces[static_cast<size_t>(piece)];
  const auto rank = [&](const GarmentPiece& other) {  // how much speaks for it; negative: it cannot be
    if (own.hand != 0 && other.hand == own.hand) return -1;
    if (own.face * other.face < 0 || !lay_on(other, own, true)) return -1;
    const auto q = static_cast<Index>(&other - graph.pieces.data());
    if (own.hand * other.hand == 0 && sewn_around(graph, piece, q)) return -1;
    return 2 * (own.hand * other.hand < 0) + (own.cover == other.cover) + (own.face == other.face);
  };
  Index best = kNone;
  int most = -1;
  bool alone = false;
  for (Index q = 0; q < static_cast<Index>(graph.pieces.size()); ++q) {
    if (q == piece) continue;
    const int r = rank(graph.pieces[static_cast<size_t>(q)]);
    if (r < 0 || r < most) continue;
    alone = r > most;
    most = r;
    best = q;
  }
  return alone ? best : kNone;
}

std::vector<FlatMove> own_mirrors(const GarmentPiece& piece) {
  const std::vector<Vec2> points = around(piece, piece.corners.front(), false);
  std::vector<FlatMove> found;
  for (const Vec2 start : piece.corners) {
    if (const auto fit = fit_at(points, piece, start, true)) found.push_back(fit->move);
  }
  return found;
}

}  // namespace toile::arrange
