#include "core/mesh/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "core/geometry/polygon2.h"

namespace toile::mesh {
namespace {

struct Segment {
  Vec2 a, b;
};

std::vector<Segment> segments_of(std::span<const Polygon> loops) {
  std::vector<Segment> segments;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  return segments;
}

/// Segments by square cells of side `cell`; each is listed wherever it may come nearer than `margin`.
class SegmentGrid {
 public:
  SegmentGrid(const std::vector<Segment>& segments, Vec2 origin, double cell, double margin)
      : segments_(segments), origin_(origin), cell_(cell), margin_(margin) {
    for (std::size_t i = 0; i < segments.size(); ++i) add(static_cast<Index>(i));
    std::sort(entries_.begin(), entries_.end());
    entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
  }

  bool is_near(Vec2 p) const {
    const Entry key{row(p.x - origin_.x), row(p.y - origin_.y), kNone};
    for (auto e = std::lower_bound(entries_.begin(), entries_.end(), key); e != entries_.end(); ++e) {
      if (std::get<0>(*e) != std::get<0>(key) || std::get<1>(*e) != std::get<1>(key)) break;
      const Segment& s = segments_[std::get<2>(*e)];
      if (geometry::distance_to_segment(p, s.a, s.b) < margin_) return true;
    }
    return false;
  }

 private:
  using Entry = std::tuple<std::int64_t, std::int64_t, Index>;  // column, row, segment

  std::int64_t row(double d) const { return static_cast<std::int64_t>(std::floor(d / cell_)); }

  /// In steps of a cell, so that a long slanting segment does not fill its whole bounding box.
  void add(Index i) {
    const Segment& s = segments_[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(length(s.b - s.a) / cell_)));
    for (int k = 0; k < steps; ++k) {
      const Vec2 a = s.a + (s.b - s.a) * (double(k) / steps) - origin_;
      const Vec2 b = s.a + (s.b - s.a) * (double(k + 1) / steps) - origin_;
      const std::int64_t x1 = row(std::max(a.x, b.x) + margin_), y1 = row(std::max(a.y, b.y) + margin_);
      for (std::int64_t x = row(std::min(a.x, b.x) - margin_); x <= x1; ++x) {
        for (std::int64_t y = row(std::min(a.y, b.y) - margin_); y <= y1; ++y) entries_.push_back({x, y, i});
      }
    }
  }

  const std::vector<Segment>& segments_;
  Vec2 origin_;
  double cell_, margin_;
  std::vector<Entry> entries_;
};

/// Where the segments cross the lines y = origin + k·spacing, sorted: (k, x).
std::vector<std::pair<Index, double>> row_crossings(const std::vector<Segment>& segments, double origin,
                                                    double spacing) {
  std::vector<std::pair<Index, double>> crossings;
  for (const Segment& s : segments) {
    const double low = (std::min(s.a.y, s.b.y) - origin) / spacing;
    const double high = (std::max(s.a.y, s.b.y) - origin) / spacing;
    // Half open, so that a line through a shared end point counts once.
    for (auto k = static_cast<Index>(std::ceil(low)); k < high; ++k) {
      // Clamped: an edge that rises by a rounding error alone is met anywhere along its line.
      const double t = std::clamp((origin + k * spacing - s.a.y) / (s.b.y - s.a.y), 0.0, 1.0);
      crossings.push_back({k, s.a.x + t * (s.b.x - s.a.x)});
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

std::vector<Vec2> lattice_points(std::span<const Polygon> loops, double spacing, double margin,
                                 std::span<const std::vector<Vec2>> lines) {
  const std::vector<Segment> segments = segments_of(loops);
  if (segments.empty()) return {};
  std::vector<Vec2> corners;
  corners.reserve(segments.size());
  for (const Segment& s : segments) corners.push_back(s.a);
  const Aabb2 box = bounding_box(corners);
  const Vec2 low = box.low, size = box.size();
  const double dy = size.y / std::max(1.0, std::round(size.y / (spacing * std::sqrt(0.75))));
  const double dx = size.x / std::max(1.0, std::round(size.x / spacing));
  if (!(dx > 0 && dy > 0)) return {};
  std::vector<Segment> avoided = segments;
  for (const std::vector<Vec2>& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) avoided.push_back({line[i], line[i + 1]});
  }
  const SegmentGrid grid(avoided, low, spacing, margin);
  const auto crossings = row_crossings(segments, low.y, dy);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const Index k = crossings[i].first;
    const double start = low.x + (k % 2 == 0 ? 0 : dx / 2);
    for (double column = std::ceil((crossings[i].second - start) / dx);; ++column) {
      const Vec2 p{start + column * dx, low.y + k * dy};
      if (p.x >= crossings[i + 1].second) break;
      if (!grid.is_near(p)) points.push_back(p);
    }
  }
  return points;
}

}  // namespace toile::mesh
