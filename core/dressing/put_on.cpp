#include "core/dressing/put_on.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "core/collision/crossings.h"
#include "core/dressing/turn_over.h"
#include "core/mesh/flat_locator.h"

namespace toile::dressing {

namespace {

/// Cloth that keeps less of its size than this leaves takes long to unfold: another way may do better.
constexpr double kSqueezed = 0.25;  // as Certificate::shrink_p99

/// Share of the worst panel's crossings from which on another is at fault as well.
constexpr double kCrossesMost = 0.5;

/// Of a shape that is certified. Straps that hang on the arms are not drawn back onto the shoulders by any
/// drape; squeezed cloth unfolds.
std::pair<int, double> shortcomings_of(const Dressed& dressed) {
  return {dressed.bared_shoulders, dressed.certificate.shrink_p99};
}

Shortfall shortfall_of(const Certificate& c) { return {c.wrong_rings(), c.crossings.all()}; }

/// How many triangles of each panel cross something.
std::vector<int> crossing_triangles(const sewing::GarmentMesh& g, const Wearer& wearer,
                                    std::span<const Vec3> x) {
  std::vector<int> count(g.first_vertex.size() - 1, 0);
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  for (const auto& pair : collision::body_crossings(surface, x, wearer.crossing()))
    ++count[g.panel_of_triangle[pair[0]]];
  for (const auto& pair : collision::self_crossings(surface, x))
    for (const Index t : pair) ++count[g.panel_of_triangle[t]];
  return count;
}

/// Panels with wrong rings; where all are right, those that cross most.
std::set<Index> in_the_way(const sewing::GarmentMesh& g, const Wearer& wearer, const Dressed& failed) {
  std::set<Index> panels;
  for (const WornRing& ring : failed.certificate.rings)
    for (const Index v : ring.vertices)
      if (!ring.right) panels.insert(g.panel_of_vertex[v]);
  if (!panels.empty()) return panels;
  const std::vector<int> count = crossing_triangles(g, wearer, failed.positions);
  const int most = *std::max_element(count.begin(), count.end());
  for (std::size_t p = 0; most > 0 && p < count.size(); ++p)
    if (count[p] >= kCrossesMost * most) panels.insert(static_cast<Index>(p));
  return panels;
}

/// A garment is more without a sleeve than without its back: pieces for the trunk are at fault only where no
/// others are.
std::vector<Index> at_fault(const sewing::Assembly& assembly, const Wearer& wearer, const Dressed& failed) {
  const std::set<Index> panels = in_the_way(assembly.garment, wearer, failed);
  const std::vector<Covers> covers = covers_of(assembly, wearer.figure());
  std::vector<Index> others;
  for (const Index p : panels)
    if (covers[static_cast<std::size_t>(p)] != Covers::kTrunk) others.push_back(p);
  return others.empty() ? std::vector<Index>(panels.begin(), panels.end()) : others;
}

/// Ways that a start before this one was made by count as well.
bool tried_before(const sewing::Assembly& assembly, const Wearer& wearer, std::size_t number) {
  const std::vector<DressingWay>& ways = dressing_ways();
  for (std::size_t k = 0; k < number; ++k)
    if (same_way(assembly, wearer, ways[k], ways[number])) return true;
  return false;
}

/// Shares of the room there is by which collars are turned down, in the order in which they are tried.
constexpr double kTurnedBy[] = {1, 0.9, 0.8, 0.65};

/// Turns down what is pressed back, if that can be certified: a collar that stands is no fault. What the
/// garment is worth against other ways is told by its certificate before: all of them stretch a fall alike.
void turn_down(const sewing::Assembly& assembly, const Wearer& wearer, Dressed& dressed) {
  if (assembly.pressed_back.empty()) return;
  for (const double share : kTurnedBy) {
    Dressed down = dressed;
    down.positions = turned_over(assembly, wearer, dressed.positions, share);
    finish(assembly, wearer, down);
    if (!down.certificate.holds_strained()) continue;
    dressed.positions = std::move(down.positions);
    return;
  }
}

/// What was certified by the coarse mesh on the fine one; nothing where it is not on there. How squeezed it
/// is was seen by the coarse mesh.
std::optional<Dressed> on_fine(const sewing::Assembly& fine, const sewing::Assembly& coarse,
                               const Wearer& wearer, Dressed dressed) {
  const double squeezed = dressed.certificate.shrink_p99;
  if (&fine != &coarse) {
    dressed.positions = carried_over(fine.garment, coarse.garment, dressed.positions);
    finish(fine, wearer, dressed);
  }
  if (!dressed.certificate.holds_strained()) return std::nullopt;
  turn_down(fine, wearer, dressed);
  dressed.certificate.shrink_p99 = squeezed;
  return dressed;
}

}  // namespace

std::vector<Vec3> carried_over(const sewing::GarmentMesh& fine, const sewing::GarmentMesh& coarse,
                               std::span<const Vec3> shape) {
  std::vector<std::vector<Tri>> of_panel(coarse.first_vertex.size() - 1);
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    of_panel[coarse.panel_of_triangle[t]].push_back(coarse.triangles[t]);
  std::vector<mesh::FlatLocator> flat;
  flat.reserve(of_panel.size());
  for (const std::vector<Tri>& triangles : of_panel) flat.emplace_back(coarse.rest, triangles);
  std::vector<Vec3> x(fine.rest.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Index panel = fine.panel_of_vertex[v];
    const mesh::FlatPlace place = flat[panel].at(fine.rest[v]);
    if (place.triangle == kNone) continue;
    const Tri& corners = of_panel[panel][place.triangle];
    for (std::size_t k = 0; k < 3; ++k) x[v] += shape[corners[k]] * place.share[k];
  }
  return sewing::together_at_means(fine, x);
}

TriedOn put_on(const sewing::Assembly& fine, const sewing::Assembly& coarse, const Wearer& wearer,
               const RunContext& context, std::size_t first, Effort effort) {
  TriedOn tried;
  tried.effort = effort;
  std::optional<Dressed> nearest, strained;
  Effort better;  // for one less squeezed, once one is certified: twice what it took to come there
  for (std::size_t number = first; number < dressing_ways().size(); ++number) {
    if (context.cancelled()) return {};
    tried.gave_up = number > first && tried.effort.spent() && !tried.on;
    tried.next = number;
    if (tried.gave_up || (tried.on && better.spent())) break;
    if (tried_before(coarse, wearer, number)) continue;
    Dressed dressed =
        dress(coarse, wearer, dressing_ways()[number], context, {}, tried.on ? better : tried.effort);
    if (tried.on) {
      tried.effort = tried.effort.less(better, dressed.effort);
      better = dressed.effort;
    } else {
      tried.effort = dressed.effort;
      better = effort.spent_since(tried.effort).twice();
    }
    dressed.number = number;
    if (!dressed.certificate.holds()) {
      if (dressed.certificate.holds_strained() &&
          (!strained || dressed.certificate.stretch_p99 < strained->certificate.stretch_p99))
        strained = dressed;
      if (!nearest || shortfall_of(dressed.certificate) < shortfall_of(nearest->certificate))
        nearest = std::move(dressed);
      continue;
    }
    if (tried.on && shortcomings_of(dressed) >= shortcomings_of(*tried.on)) continue;
    std::optional<Dressed> on = on_fine(fine, coarse, wearer, std::move(dressed));
    if (!on || !on->certificate.holds()) continue;
    const bool good = on->certificate.shrink_p99 < kSqueezed && on->bared_shoulders == 0;
    tried.on = std::move(on);
    if (good) break;
  }
  if (!tried.on && strained) tried.on = on_fine(fine, coarse, wearer, std::move(*strained));
  if (tried.on || !nearest) return tried;
  tried.nearest = nearest->number;
  tried.shortfall = shortfall_of(nearest->certificate);
  tried.at_fault = at_fault(coarse, wearer, *nearest);
  return tried;
}

}  // namespace toile::dressing
