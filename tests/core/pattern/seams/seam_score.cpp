#include "tests/core/pattern/seams/seam_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"

namespace toile::test {
namespace {

constexpr int kPoints = 40;        // of a seam
constexpr double kMostOfIt = 0.8;  // of a seam's points

const pattern::PanelEdge& edge_at(const pattern::Pattern& pattern, const SeamPoint& p) {
  return *pattern::edges_of(pattern.panels[p.panel])[p.edge];
}

Vec2 place_of(const pattern::Pattern& pattern, const SeamPoint& p) {
  const pattern::PanelEdge& edge = edge_at(pattern, p);
  return pattern::point_at_length(edge, p.along * pattern::arc_length(edge));
}

double length_of(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side) {
  double sum = 0;
  for (const pattern::SeamEdge& e : side)
    sum += (e.to - e.from) * pattern::arc_length(*pattern::edges_of(pattern.panels[e.panel])[e.edge]);
  return sum;
}

SeamPoint point_on(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side,
                   double distance) {
  for (const pattern::SeamEdge& e : side) {
    const double whole = pattern::arc_length(*pattern::edges_of(pattern.panels[e.panel])[e.edge]);
    const double length = (e.to - e.from) * whole;
    if (distance <= length || &e == &side.back()) {
      const double f = std::min(1.0, distance / length) * (e.to - e.from);
      return {e.panel, e.edge, e.reversed ? e.to - f : e.from + f};
    }
    distance -= length;
  }
  return {};
}

/// Whether the two pairs say the same: both ends on the same pieces, as near as `near` (mm).
bool agree(const pattern::Pattern& pattern, const std::array<SeamPoint, 2>& x,
           const std::array<SeamPoint, 2>& y, double near) {
  for (const bool swapped : {false, true}) {
    bool same = true;
    for (int k = 0; k < 2 && same; ++k) {
      const SeamPoint &p = x[k], &q = y[swapped ? 1 - k : k];
      same = p.panel == q.panel && length(place_of(pattern, p) - place_of(pattern, q)) <= near;
    }
    if (same) return true;
  }
  return false;
}

/// Share of the seam's points that some seam of the others has as well.
double share_of(const pattern::Pattern& pattern, const SewnPoints& seam, std::span<const SewnPoints> others) {
  int found = 0;
  for (const auto& pair : seam.pairs) {
    found += std::any_of(others.begin(), others.end(), [&](const SewnPoints& other) {
      // Lengths that differ shift the points between a seam's ends; half a step lies between two points.
      const double near = 4 + 0.04 * std::max(seam.length, other.length);
      return std::any_of(other.pairs.begin(), other.pairs.end(),
                         [&](const auto& p) { return agree(pattern, pair, p, near); });
    });
  }
  return static_cast<double>(found) / static_cast<double>(seam.pairs.size());
}

Vec2 point_in(const json::JsonValue& p, Vec2 offset) {
  return Vec2{*(*p.array())[0].number(), *(*p.array())[1].number()} + offset;
}

/// The place on the piece's outline that is nearest.
SeamPoint nearest_on(const pattern::Panel& panel, Index index, Vec2 at) {
  SeamPoint best{index, 0, 0};
  double least = 1e30;
  for (std::size_t e = 0; e < panel.outline.edges.size(); ++e) {
    const pattern::PanelEdge& edge = panel.outline.edges[e];
    const double whole = pattern::arc_length(edge);
    const int steps = static_cast<int>(whole) + 8;
    for (int k = 0; k <= steps; ++k) {
      const double d = length(pattern::point_at_length(edge, whole * k / steps) - at);
      if (d < least) {
        least = d;
        best = {index, static_cast<Index>(e), static_cast<double>(k) / steps};
      }
    }
  }
  return best;
}

/// Point of a polyline at a fraction of its length.
Vec2 along(const std::vector<json::JsonValue>& points, Vec2 offset, double fraction) {
  double whole = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    whole += length(point_in(points[i], {}) - point_in(points[i - 1], {}));
  double left = fraction * whole;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 p = point_in(points[i - 1], offset), q = point_in(points[i], offset);
    const double step = length(q - p);
    if (left <= step || i + 1 == points.size()) return p + (q - p) * (left / step);
    left -= step;
  }
  return point_in(points.front(), offset);
}

struct TrueSide {
  const json::JsonValue* panel;
  const json::JsonValue* edge;
  Index index;
  std::string name;
};

Result<TrueSide> side_in(const json::JsonValue& file, const json::JsonValue& side,
                         const pattern::Pattern& pattern) {
  const std::string& id = *side.find("panel")->text();
  const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                  [&](const pattern::Panel& p) { return p.id == id; });
  if (found == pattern.panels.end()) return Error{"test.panel", "the drawing has no such piece", id};
  const json::JsonValue* panel = file.find("panels")->find(id);
  const int edge = static_cast<int>(*side.find("edge")->number());
  return TrueSide{panel, &(*panel->find("edges")->array())[edge],
                  static_cast<Index>(found - pattern.panels.begin()), id + "." + std::to_string(edge)};
}

SeamPoint point_of(const TrueSide& side, const pattern::Pattern& pattern, double fraction) {
  const Vec2 offset = point_in(*side.panel->find("dxf_offset"), {});
  return nearest_on(pattern.panels[side.index], side.index,
                    along(*side.edge->find("pts")->array(), offset, fraction));
}

/// Stitched edges run against each other.
Result<SewnPoints> true_seam(const json::JsonValue& file, const json::JsonValue& stitch,
                             const pattern::Pattern& pattern) {
  const TrueSide a = TRY(side_in(file, *stitch.find("a"), pattern));
  const TrueSide b = TRY(side_in(file, *stitch.find("b"), pattern));
  SewnPoints seam{a.name + " to " + b.name,
                  std::max(*stitch.find("len_a")->number(), *stitch.find("len_b")->number()),
                  {}};
  for (int k = 0; k < kPoints; ++k) {
    const double f = (k + 0.5) / kPoints;
    seam.pairs.push_back({point_of(a, pattern, f), point_of(b, pattern, 1 - f)});
  }
  return seam;
}

/// The outline as one line: distances from its start are found by place, and places by distance.
class OutlineWalk {
 public:
  OutlineWalk(const pattern::Panel& panel, Index index) : panel_(panel), index_(index) {
    starts_.push_back(0);
    for (const pattern::PanelEdge& edge : panel.outline.edges)
      starts_.push_back(starts_.back() + pattern::arc_length(edge));
  }
  double girth() const { return starts_.back(); }
  double distance_of(Vec2 at) const {
    const SeamPoint p = nearest_on(panel_, index_, at);
    return starts_[p.edge] + p.along * (starts_[p.edge + 1] - starts_[p.edge]);
  }
  SeamPoint point_at(double distance) const {
    distance -= girth() * std::floor(distance / girth());
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, distance);
    const auto e = static_cast<std::size_t>(after - starts_.begin()) - 1;
    return {index_, static_cast<Index>(e),
            std::clamp((distance - starts_[e]) / (starts_[e + 1] - starts_[e]), 0.0, 1.0)};
  }

 private:
  const pattern::Panel& panel_;
  Index index_;
  std::vector<double> starts_;
};

/// Points along an edge that is told by its ends and its length.
struct DrawnEdge {
  std::string name;
  double length = 0;              ///< mm
  std::vector<SeamPoint> points;  ///< evenly along it, from its start
};

Result<DrawnEdge> drawn_edge(const json::JsonValue& file, const std::string& piece, int number,
                             const pattern::Pattern& pattern) {
  const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                  [&](const pattern::Panel& p) { return p.id == piece; });
  if (found == pattern.panels.end()) return Error{"test.panel", "the drawing has no such piece", piece};
  const json::JsonValue& edge = (*file.find("pieces")->find(piece)->find("edges")->array())[number];
  DrawnEdge drawn{piece + "." + std::to_string(number), *edge.find("length_mm")->number(), {}};
  const OutlineWalk walk(*found, static_cast<Index>(found - pattern.panels.begin()));
  const double from = walk.distance_of(point_in(*edge.find("from"), {}));
  const double to = walk.distance_of(point_in(*edge.find("to"), {}));
  const double ahead = to > from ? to - from : to - from + walk.girth();
  const double back = ahead - walk.girth();
  const double way = std::abs(ahead - drawn.length) < std::abs(-back - drawn.length) ? ahead : back;
  for (int k = 0; k < kPoints; ++k) drawn.points.push_back(walk.point_at(from + way * (k + 0.5) / kPoints));
  return drawn;
}

Result<std::string> bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{"test.file", "cannot be read", path.string()};
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void SeamScore::add(const SeamScore& other) {
  proposed += other.proposed;
  right += other.right;
  known += other.known;
  found += other.found;
}

SewnPoints points_of(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const double a = length_of(pattern, seam.a), b = length_of(pattern, seam.b);
  const auto names = [&](const std::vector<pattern::SeamEdge>& side) {
    std::string text;
    for (const pattern::SeamEdge& e : side) {
      text += (text.empty() ? "" : " + ") + pattern.panels[e.panel].id + "." +
              pattern::edges_of(pattern.panels[e.panel])[e.edge]->id;
      if (e.from > 0 || e.to < 1)
        text += "[" + std::to_string(e.from).substr(0, 5) + ".." + std::to_string(e.to).substr(0, 5) + "]";
    }
    return text;
  };
  SewnPoints points{names(seam.a) + " to " + names(seam.b), std::max(a, b), {}};
  for (int k = 0; k < kPoints; ++k) {
    const double f = (k + 0.5) / kPoints;
    points.pairs.push_back(
        {point_on(pattern, seam.a, f * a), point_on(pattern, seam.b, (seam.same_direction ? f : 1 - f) * b)});
  }
  return points;
}

SeamScore score_of(const pattern::Pattern& pattern, std::span<const seams::SeamProposal> proposals,
                   std::span<const SewnPoints> truth, double confidence) {
  SeamScore score;
  std::vector<SewnPoints> proposed;
  for (const seams::SeamProposal& p : proposals)
    if (p.confidence >= confidence) proposed.push_back(points_of(pattern, p.seam));
  for (const SewnPoints& seam : proposed) {
    ++score.proposed;
    const bool right = share_of(pattern, seam, truth) >= kMostOfIt;
    score.right += right;
    if (!right) score.wrong.push_back(seam.name);
  }
  for (const SewnPoints& seam : truth) {
    ++score.known;
    const bool found = share_of(pattern, seam, proposed) >= kMostOfIt;
    score.found += found;
    if (!found) score.missed.push_back(seam.name);
  }
  return score;
}

std::vector<bool> right_of(const pattern::Pattern& pattern, std::span<const seams::SeamProposal> proposals,
                           std::span<const SewnPoints> truth) {
  std::vector<bool> right;
  for (const seams::SeamProposal& p : proposals)
    right.push_back(share_of(pattern, points_of(pattern, p.seam), truth) >= kMostOfIt);
  return right;
}

Result<std::vector<SewnPoints>> read_seams_by_ends(const std::filesystem::path& path,
                                                   const pattern::Pattern& pattern) {
  const std::string text = TRY(bytes_of(path));
  const json::JsonValue file = TRY(json::parse_json(text));
  std::vector<SewnPoints> truth;
  for (const json::JsonValue& seam : *file.find("seams")->array()) {
    const std::vector<json::JsonValue>& s = *seam.array();
    const DrawnEdge a = TRY(drawn_edge(file, *s[0].text(), static_cast<int>(*s[1].number()), pattern));
    const DrawnEdge b = TRY(drawn_edge(file, *s[2].text(), static_cast<int>(*s[3].number()), pattern));
    const bool same = *s[4].text() == "same";
    SewnPoints& points = truth.emplace_back(a.name + " to " + b.name, std::max(a.length, b.length));
    for (int k = 0; k < kPoints; ++k)
      points.pairs.push_back({a.points[k], b.points[same ? k : kPoints - 1 - k]});
  }
  return truth;
}

Result<TrueGarment> read_true_garment(const std::filesystem::path& dxf) {
  std::ifstream in(dxf, std::ios::binary);
  const dxf::DxfDrawing drawing = TRY(dxf::read_dxf(in));
  TrueGarment garment;
  for (const dxf::DxfPiece& piece : drawing.pieces) {
    pattern::Panel panel = TRY(dxf::panel_from_piece(piece));
    garment.pattern.panels.push_back(std::move(panel));
    garment.clockwise.push_back(seams::runs_clockwise(piece.outline));
  }
  std::filesystem::path seams = dxf;
  const std::string text = TRY(bytes_of(seams.replace_extension(".seams.json")));
  const json::JsonValue file = TRY(json::parse_json(text));
  for (const json::JsonValue& stitch : *file.find("stitches")->array()) {
    SewnPoints seam = TRY(true_seam(file, stitch, garment.pattern));
    garment.truth.push_back(std::move(seam));
  }
  return garment;
}

}  // namespace toile::test
