#include "core/geometry/polygon2.h"

#include <algorithm>
#include <array>
#include <set>

namespace toile::geometry {

double distance(const Aabb2& box, Vec2 p) {
  return length(Vec2{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                     std::max({box.low.y - p.y, 0.0, p.y - box.high.y})});
}

double signed_area(std::span<const Vec2> loop) {
  // Relative to the first vertex: a small loop far from the origin keeps its digits.
  double twice = 0;
  for (std::size_t i = 2; i < loop.size(); ++i) twice += cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
  return twice / 2;
}

bool is_flat(std::span<const Vec2> points, double tolerance) {
  if (points.empty()) return true;
  Vec2 far = points[0];
  for (Vec2 p : points)
    if (length(p - points[0]) > length(far - points[0])) far = p;
  const Vec2 direction = normalized(far - points[0]);
  return std::all_of(points.begin(), points.end(),
                     [&](Vec2 p) { return std::abs(cross(direction, p - points[0])) <= tolerance; });
}

double polyline_length(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
  return sum;
}

bool contains(std::span<const Vec2> loop, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Vec2 a = loop[i], b = loop[j];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    // The ray from p to the right passes the segment when p lies left of it, taken upwards.
    const bool left = a.y < b.y ? orientation(a, b, p) > 0 : orientation(b, a, p) > 0;
    if (left) inside = !inside;
  }
  return inside;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double l2 = dot(d, d);
  const double t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0;
  return length(p - (a + t * d));
}

Vec2 nearest_on(std::span<const Vec2> loop, Vec2 p) {
  Vec2 best = loop[0];
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const Vec2 a = loop[i], d = loop[(i + 1) % n] - a;
    const double l2 = dot(d, d);
    const Vec2 at = a + d * (l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0);
    if (length(at - p) < length(best - p)) best = at;
  }
  return best;
}

double orientation(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

std::optional<Vec2> segment_intersection(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double oc = orientation(a, b, c), od = orientation(a, b, d);
  // Signs only decide: two ends on one side of the other segment, and the two are apart.
  const double oa = orientation(c, d, a), ob = orientation(c, d, b);
  const auto apart = [](double u, double v) { return (u > 0 && v > 0) || (u < 0 && v < 0); };
  if (apart(oc, od) || apart(oa, ob)) return std::nullopt;
  // An end that lies on the other segment is named exactly.
  const auto on = [](double o, Vec2 s, Vec2 t, Vec2 p) {
    return o == 0 && bounding_box(std::array{s, t}).contains(p);
  };
  if (on(oc, a, b, c)) return c;
  if (on(od, a, b, d)) return d;
  if (on(oa, c, d, a)) return a;
  if (on(ob, c, d, b)) return b;
  if (oc == od) return std::nullopt;  // on one line, apart
  return c + (oc / (oc - od)) * (d - c);
}

namespace {

bool before(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// A segment with its ends sorted from left to right (upwards when it is vertical).
struct SweepSegment {
  Vec2 left, right;
  std::size_t loop = 0, segment = 0;  // as Crossing counts
  std::size_t from = 0, to = 0;       // vertex numbers over all loops, repeated vertices left out
};

bool share_vertex(const SweepSegment& a, const SweepSegment& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

std::vector<SweepSegment> segments_of(std::span<const std::vector<Vec2>> loops) {
  std::vector<SweepSegment> segments;
  std::size_t vertex = 0;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      if (kept.empty() || loops[l][i] != loops[l][kept.back()]) kept.push_back(i);
    while (kept.size() > 1 && loops[l][kept.back()] == loops[l][kept.front()]) kept.pop_back();
    for (std::size_t k = 0; k < kept.size() && kept.size() > 1; ++k) {
      const std::size_t next = (k + 1) % kept.size();
      Vec2 a = loops[l][kept[k]], b = loops[l][kept[next]];
      if (before(b, a)) std::swap(a, b);
      segments.push_back({a, b, l, kept[k], vertex + k, vertex + next});
    }
    vertex += kept.size();
  }
  return segments;
}

/// Order of two segments, from below to above, where both meet the sweep line. Any two that are in the sweep
/// at one time and do not cross are ordered alike at every place, so no sweep position is needed.
struct Below {
  const std::vector<SweepSegment>* segments;
  std::size_t* compared;
  bool operator()(std::size_t i, std::size_t j) const {
    ++*compared;
    if (i == j) return false;
    const SweepSegment &a = (*segments)[i], &b = (*segments)[j];
    if (before(b.left, a.left)) return !above(b, a, j < i);
    return above(a, b, i < j);
  }
  // Whether `later`, which starts at or right of the start of `earlier`, lies above it.
  static bool above(const SweepSegment& earlier, const SweepSegment& later, bool tie) {
    const double start = orientation(earlier.left, earlier.right, later.left);
    if (start != 0) return start > 0;
    const double end = orientation(earlier.left, earlier.right, later.right);
    return end != 0 ? end > 0 : tie;
  }
};

/// The point where two segments meet although they are not neighbours, or fold back as neighbours.
std::optional<Vec2> meeting(const SweepSegment& a, const SweepSegment& b) {
  if (!share_vertex(a, b)) return segment_intersection(a.left, a.right, b.left, b.right);
  // Neighbours share one end. They overlap when they leave it in the same direction.
  if (orientation(a.left, a.right, b.left) != 0 || orientation(a.left, a.right, b.right) != 0)
    return std::nullopt;
  if (a.left == b.left) return before(a.right, b.right) ? a.right : b.right;
  if (a.right == b.right) return before(a.left, b.left) ? b.left : a.left;
  return std::nullopt;
}

struct Event {
  Vec2 at;
  bool starts = false;
  std::size_t segment = 0;
};

std::vector<Event> events_of(const std::vector<SweepSegment>& segments) {
  std::vector<Event> events;
  events.reserve(segments.size() * 2);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    events.push_back({segments[i].left, true, i});
    events.push_back({segments[i].right, false, i});
  }
  // At one point segments end before others start: neighbours are then never in the sweep together there.
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    if (a.at != b.at) return before(a.at, b.at);
    if (a.starts != b.starts) return !a.starts;
    return a.segment < b.segment;
  });
  return events;
}

Crossing crossing_of(const SweepSegment& a, const SweepSegment& b, Vec2 point) {
  const bool swap = b.loop < a.loop || (b.loop == a.loop && b.segment < a.segment);
  const SweepSegment &first = swap ? b : a, &second = swap ? a : b;
  return {first.loop, first.segment, second.loop, second.segment, point};
}

std::size_t vertex_at(const SweepSegment& s, const std::span<const std::vector<Vec2>> loops, Vec2 at) {
  return loops[s.loop][s.segment] == at ? s.from : s.to;
}

}  // namespace

std::optional<Crossing> find_crossing(std::span<const std::vector<Vec2>> loops, std::size_t* compared) {
  std::size_t uncounted = 0;
  if (compared == nullptr) compared = &uncounted;
  const std::vector<SweepSegment> segments = segments_of(loops);
  const std::vector<Event> events = events_of(segments);
  std::multiset<std::size_t, Below> sweep(Below{&segments, compared});
  std::vector<std::multiset<std::size_t, Below>::iterator> place(segments.size(), sweep.end());

  const auto check = [&](std::size_t i, std::size_t j) -> std::optional<Crossing> {
    ++*compared;
    const std::optional<Vec2> p = meeting(segments[i], segments[j]);
    return p ? std::optional(crossing_of(segments[i], segments[j], *p)) : std::nullopt;
  };
  for (std::size_t e = 0; e < events.size(); ++e) {
    const Event& event = events[e];
    // Two vertices in one place: the segments that end and start here never meet in the sweep.
    if (e > 0 && events[e - 1].at == event.at) {
      const SweepSegment &a = segments[events[e - 1].segment], &b = segments[event.segment];
      if (vertex_at(a, loops, event.at) != vertex_at(b, loops, event.at)) return crossing_of(a, b, event.at);
    }
    if (event.starts) {
      const auto it = sweep.insert(event.segment);
      place[event.segment] = it;
      if (it != sweep.begin())
        if (auto found = check(*std::prev(it), *it)) return found;
      if (std::next(it) != sweep.end())
        if (auto found = check(*it, *std::next(it))) return found;
    } else {
      const auto next = sweep.erase(place[event.segment]);
      if (next != sweep.begin() && next != sweep.end())
        if (auto found = check(*std::prev(next), *next)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace toile::geometry
