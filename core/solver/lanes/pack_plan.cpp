#include "core/solver/lanes/pack_plan.h"

#include <algorithm>
#include <numeric>

namespace toile::solver::lanes {

namespace {

/// How far ahead a constraint is looked for that shares no vertex with those of a group.
constexpr std::size_t kLookAhead = 192;

/// Constraints below which a pass is over before a second thread has begun.
constexpr Index kFewestShared = 12000;

/// Walks over a mesh from vertex to vertex of the same constraint.
class Walker {
 public:
  Walker(Index count, Index vertex_count, const VerticesOf& vertices)
      : vertices_(vertices), first_(static_cast<std::size_t>(vertex_count) + 1) {
    for (Index c = 0; c < count; ++c) {
      for (const Index v : vertices(c)) {
        if (v != kNone) ++first_[v + 1];
      }
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index c = 0; c < count; ++c) {
      for (const Index v : vertices(c)) {
        if (v != kNone) at_[next[v]++] = c;
      }
    }
  }

  /// Tells each vertex that can be reached how many constraints away it is; the last one reached.
  Index from(Index start, std::vector<Index>& distance) {
    reached_.assign(1, start);
    distance[start] = 0;
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      const Index v = reached_[k];
      for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
        for (const Index w : vertices_(at_[i])) {
          if (w == kNone || distance[w] != kNone) continue;
          distance[w] = distance[v] + 1;
          reached_.push_back(w);
        }
      }
    }
    return reached_.back();
  }
  /// Those that the last walk came to.
  const std::vector<Index>& reached() const { return reached_; }

 private:
  const VerticesOf& vertices_;
  std::vector<std::size_t> first_;
  std::vector<Index> at_, reached_;
};

/// Constraints of each strip, in order: as many as there are levels to part them at, of about equal size.
std::vector<std::vector<Index>> strips_of(Index count, Index vertex_count, const VerticesOf& vertices) {
  std::vector<std::vector<Index>> strips;
  if (count < kFewestShared) {
    std::vector<Index>& all = strips.emplace_back(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return strips;
  }
  const std::vector<Index> levels = levels_of(count, vertex_count, vertices);
  std::vector<Index> size(static_cast<std::size_t>(*std::max_element(levels.begin(), levels.end())) + 1);
  for (const Index level : levels) ++size[level];
  const Index share = count / (2 * kMostSideBySide) + 1;
  std::vector<Index> strip_of(size.size());
  Index strip = 0, held = 0;
  for (std::size_t level = 0; level < size.size(); ++level) {
    if (held >= share) {
      ++strip;
      held = 0;
    }
    strip_of[level] = strip;
    held += size[level];
  }
  strips.resize(static_cast<std::size_t>(strip) + 1);
  for (Index c = 0; c < count; ++c) strips[strip_of[levels[c]]].push_back(c);
  return strips;
}

}  // namespace

std::vector<Index> levels_of(Index count, Index vertex_count, const VerticesOf& vertices) {
  Walker walker(count, vertex_count, vertices);
  std::vector<Index> distance(static_cast<std::size_t>(vertex_count), kNone), scratch = distance;
  for (Index v = 0; v < vertex_count; ++v) {
    if (distance[v] != kNone) continue;
    const Index end = walker.from(v, scratch);  // far from anywhere is an end
    walker.from(end, distance);
  }
  std::vector<Index> levels(static_cast<std::size_t>(count), kNone);
  for (Index c = 0; c < count; ++c) {
    for (const Index v : vertices(c)) {
      if (v != kNone && (levels[c] == kNone || distance[v] < levels[c])) levels[c] = distance[v];
    }
  }
  return levels;
}

std::vector<LaneGroup> group_apart(std::span<const Index> of, Index vertex_count,
                                   const VerticesOf& vertices) {
  std::vector<LaneGroup> groups;
  std::vector<Index> taken(static_cast<std::size_t>(vertex_count), kNone);  // by which group, last
  std::vector<Index> waiting;
  std::size_t next = 0;
  while (next < of.size() || !waiting.empty()) {
    while (next < of.size() && waiting.size() < kLookAhead) waiting.push_back(of[next++]);
    const auto self = static_cast<Index>(groups.size());
    LaneGroup& group = groups.emplace_back();
    group.fill(kNone);
    std::size_t size = 0, kept = 0;
    for (const Index c : waiting) {
      const std::span<const Index> mine = vertices(c);
      const bool apart = size < kLanes && std::none_of(mine.begin(), mine.end(), [&](Index v) {
                           return v != kNone && taken[v] == self;
                         });
      if (!apart) {
        waiting[kept++] = c;
        continue;
      }
      group[size++] = c;
      for (const Index v : mine) {
        if (v != kNone) taken[v] = self;
      }
    }
    waiting.resize(kept);
  }
  return groups;
}

PackPlan plan_packs(Index count, Index vertex_count, const VerticesOf& vertices) {
  PackPlan plan;
  const std::vector<std::vector<Index>> strips = strips_of(count, vertex_count, vertices);
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const std::vector<LaneGroup> groups = group_apart(strips[s], vertex_count, vertices);
    const std::size_t begin = plan.groups.size();
    plan.groups.insert(plan.groups.end(), groups.begin(), groups.end());
    plan.side.resize(plan.groups.size(), static_cast<Index>(s / 2));
    plan.rounds.at(s % 2).push_back({begin, plan.groups.size()});
  }
  return plan;
}

}  // namespace toile::solver::lanes
