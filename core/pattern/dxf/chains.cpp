#include "core/pattern/dxf/chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/branches.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/pen.h"
#include "core/pattern/outline.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kMostRuns = 64;  // more entities than that are strokes, not edges

/// The link's stroke in the direction in which it is run.
std::vector<Vec2> points_along(const std::vector<DxfStroke>& strokes, const DxfLink& link) {
  std::vector<Vec2> points = strokes[link.stroke].points;
  if (link.reversed) std::reverse(points.begin(), points.end());
  return points;
}

/// Whether the line turns where one row of points goes on as the other.
bool turns_between(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
  const Vec2 in = normalized(before.back() - before[before.size() - 2]),
             out = normalized(after[1] - after[0]);
  return dot(in, out) < std::cos(pattern::OutlineSettings{}.told_angle);
}

/// Where curved strokes meet others at an angle.
std::vector<Vec2> turns_at_curves(const std::vector<DxfStroke>& strokes, const std::vector<DxfLink>& links,
                                  bool closed) {
  std::vector<Vec2> turns;
  if (links.size() > kMostRuns) return turns;
  for (std::size_t i = closed ? 0 : 1; i < links.size(); ++i) {
    const DxfLink &mine = links[i], &before = links[(i + links.size() - 1) % links.size()];
    if (!strokes[mine.stroke].curved && !strokes[before.stroke].curved) continue;
    const std::vector<Vec2> points = points_along(strokes, mine);
    if (turns_between(points_along(strokes, before), points)) turns.push_back(points.front());
  }
  return turns;
}

/// The links' strokes as one line.
DxfChain joined(const std::vector<DxfStroke>& strokes, const std::vector<DxfLink>& links, bool closed,
                const std::string& layer) {
  DxfChain chain;
  std::size_t runs = 0;
  bool strokes_only = true;
  chain.closed = closed;
  chain.layer = layer;
  chain.line = strokes[links[0].stroke].line;
  for (const DxfLink& link : links) {
    const std::vector<Vec2> points = points_along(strokes, link);
    const DxfStroke& stroke = strokes[link.stroke];
    chain.line = std::min(chain.line, stroke.line);
    chain.entities.push_back(stroke.entity);
    chain.curved = chain.curved || stroke.curved;
    runs += stroke.is_run ? 1 : 0;
    strokes_only = strokes_only && !stroke.curved;
    const bool first = chain.points.empty();
    if (links.size() > 1 && (closed || !first))
      chain.breaks.push_back(first ? points[0] : chain.points.back());
    chain.points.insert(chain.points.end(), points.begin() + (first ? 0 : 1), points.end());
  }
  if (closed) chain.points.pop_back();
  chain.turns = turns_at_curves(strokes, links, closed);
  chain.breaks_are_edges =
      strokes_only && links.size() > 1 && links.size() <= kMostRuns && 2 * runs >= links.size();
  return chain;
}

/// The open curves of one layer, joined at their ends.
class Chainer {
 public:
  Chainer(std::vector<DxfStroke> strokes, double tolerance)
      : strokes_(std::move(strokes)), tolerance_(std::max(tolerance, 1e-6)) {
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      ends_.insert(entry(i, false));
      ends_.insert(entry(i, true));
    }
  }

  std::vector<DxfChain> run(const std::string& layer) {
    std::vector<DxfChain> chains;
    for (std::size_t i = 0; i < strokes_.size(); ++i)
      if (ends_.contains(entry(i, false))) chains.push_back(chain_from(i, layer));
    return chains;
  }

 private:
  using Entry = std::tuple<std::int64_t, std::int64_t, std::size_t, bool>;  // cell, stroke, which end

  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / tolerance_)); }
  Entry entry(std::size_t i, bool last) const {
    const Vec2 p = strokes_[i].end(last);
    return {cell(p.x), cell(p.y), i, last};
  }

  void use(std::size_t i) {
    ends_.erase(entry(i, false));
    ends_.erase(entry(i, true));
  }

  /// The nearest unused end within tolerance, as the stroke to append there.
  std::optional<DxfLink> next_at(Vec2 p) const {
    std::optional<DxfLink> best;
    double nearest = tolerance_;
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const std::int64_t cx = cell(p.x) + dx, cy = cell(p.y) + dy;
        int seen = 0;
        for (auto it = ends_.lower_bound(Entry{cx, cy, 0, false});
             it != ends_.end() && seen < kMostAtOnePlace; ++it, ++seen) {
          const auto& [x, y, i, last] = *it;
          if (x != cx || y != cy) break;
          const double d = length(strokes_[i].end(last) - p);
          if (d < nearest || (d == nearest && (!best || i < best->stroke))) {
            nearest = d;
            best = DxfLink{i, last};
          }
        }
      }
    }
    return best;
  }

  Vec2 end_of(const DxfLink& link) const { return strokes_[link.stroke].end(!link.reversed); }
  Vec2 start_of(const DxfLink& link) const { return strokes_[link.stroke].end(link.reversed); }

  DxfChain chain_from(std::size_t first, const std::string& layer) {
    std::vector<DxfLink> links{{first, false}};
    use(first);
    double total = geometry::polyline_length(strokes_[first].points);
    const auto closed = [&] {
      return total > 2 * tolerance_ && length(end_of(links.back()) - start_of(links.front())) <= tolerance_;
    };
    const auto extend = [&](Vec2 at, std::vector<DxfLink>& to) {
      const std::optional<DxfLink> next = next_at(at);
      if (!next) return false;
      to.push_back(*next);
      use(next->stroke);
      total += geometry::polyline_length(strokes_[next->stroke].points);
      return true;
    };
    while (!closed() && extend(end_of(links.back()), links)) {
    }
    if (!closed()) {  // the other way from the start; those links run backwards
      std::vector<DxfLink> before;
      while (extend(before.empty() ? start_of(links.front()) : end_of(before.back()), before)) {
      }
      for (DxfLink& link : before) link.reversed = !link.reversed;
      links.insert(links.begin(), before.rbegin(), before.rend());
    }
    return joined(strokes_, links, closed(), layer);
  }

  std::vector<DxfStroke> strokes_;
  double tolerance_;
  std::set<Entry> ends_;  // of unused strokes
};

bool within(Vec2 p, double limit) { return std::abs(p.x) <= limit && std::abs(p.y) <= limit; }

/// Whether the points lie in the plane that patterns are drawn in.
bool in_range(const std::vector<Vec2>& points, double limit) {
  return std::all_of(points.begin(), points.end(), [&](Vec2 p) { return is_finite(p) && within(p, limit); });
}

/// Tells of a line that leads out of that plane.
void tell_out_of_range(const DxfCurve& curve, DxfNotes& notes) {
  notes.fail({"dxf.coordinate_range", "The line leads beyond any pattern.", line_text(curve.line)});
  notes.mark(curve.entity, DxfFate::kDropped, "it leads beyond any pattern");
  notes.warn(curve.line, "a line leads beyond any pattern and is left out");
}

/// Points that the joint tolerance makes one.
bool is_dot(const std::vector<Vec2>& points) {
  return points.size() < 2 || geometry::polyline_length(points) <= 0;
}

/// The open curves of one layer as chains: those that branch by their outer lines, the others end to end.
void chain_layer(const std::string& layer, const std::vector<DxfStroke>& strokes, double tolerance,
                 DxfChains& out) {
  const DxfBranches parts = part_branches(strokes, tolerance);
  for (const std::size_t i : parts.repeated)
    out.notes.mark(strokes[i].entity, DxfFate::kDropped, "drawn a second time");
  for (const std::size_t i : parts.parted)
    out.notes.warn(strokes[i].line,
                   "lines on layer " + layer + " part an outline: it is taken around the outside", -1,
                   strokes[i].end(false));
  for (const DxfBranchLoop& loop : parts.loops) {
    out.chains.push_back(joined(strokes, loop.links, true, layer));
    out.chains.back().inner = loop.inner;
  }
  for (const std::vector<std::size_t>* list : {&parts.plain, &parts.inner}) {
    std::vector<DxfStroke> some;
    for (const std::size_t i : *list) some.push_back(strokes[i]);
    for (DxfChain& chain : Chainer(std::move(some), tolerance).run(layer)) {
      chain.inner = list == &parts.inner;
      out.chains.push_back(std::move(chain));
    }
  }
}

/// The curve's points in the drawing, mm.
std::vector<Vec2> placed(std::vector<Vec2> points, const DxfCurve& curve, const DxfTransform& to_mm) {
  for (Vec2& p : points) {
    if (curve.mirrored) p.x = -p.x;
    p = to_mm(p);
  }
  return points;
}

}  // namespace

DxfTransform transform_of(const DxfInsert& insert, const DxfBlock& block) {
  const double angle = radians_from_degrees(std::fmod(insert.rotation, 360.0));
  // A quarter turn is exact, as pieces are often laid out so.
  const double c = std::fmod(insert.rotation, 180.0) == 90 || std::fmod(insert.rotation, 180.0) == -90
                       ? 0
                       : std::cos(angle);
  const double s = std::fmod(insert.rotation, 180.0) == 0 ? 0 : std::sin(angle);
  DxfTransform t{Vec2{c, s} * insert.scale.x, Vec2{-s, c} * insert.scale.y, insert.at};
  t.origin = insert.at - (block.base.x * t.x + block.base.y * t.y);
  // The plane seen from behind: x counts the other way.
  if (insert.mirrored) {
    t.x.x = -t.x.x;
    t.y.x = -t.y.x;
    t.origin.x = -t.origin.x;
  }
  return t;
}

Result<DxfChains> chains_of(const std::vector<DxfPart>& parts, const DxfReading& reading, std::size_t drawn) {
  const DxfSettings& settings = reading.settings;
  DxfChains out;
  out.drawn = drawn;
  std::map<std::string, std::vector<DxfStroke>> open;  // by layer
  for (const DxfPart& part : parts) {
    DxfTransform to_mm = part.transform;  // of points that the pen gives in millimetres
    to_mm.origin = to_mm.origin * reading.mm_per_unit;
    for (const DxfCurve& curve : part.block->curves) {
      const std::size_t room = settings.max_drawn_points - std::min(settings.max_drawn_points, out.drawn);
      DxfDrawn line = TRY(drawn_out(curve, reading.mm_per_unit, settings, room));
      out.drawn += line.cost;
      std::vector<Vec2> points = placed(std::move(line.points), curve, to_mm);
      if (!in_range(points, settings.max_coordinate_mm)) {
        tell_out_of_range(curve, out.notes);
        continue;
      }
      if (points.empty()) continue;
      const bool curved = !curve.is_straight();
      if (is_dot(points)) {
        out.notes.mark(curve.entity, DxfFate::kDropped, "it has no length");
      } else if (curve.closed) {
        out.chains.push_back(
            {std::move(points), true, curve.layer, curve.line, {}, false, {curve.entity}, curved});
      } else {
        open[curve.layer].push_back({std::move(points), curve.line, curve.entity, curved, curve.is_run});
      }
    }
  }
  for (const auto& [layer, strokes] : open) chain_layer(layer, strokes, settings.chain_tolerance_mm, out);
  std::stable_sort(out.chains.begin(), out.chains.end(),
                   [](const DxfChain& a, const DxfChain& b) { return a.line < b.line; });
  return out;
}

}  // namespace toile::dxf
