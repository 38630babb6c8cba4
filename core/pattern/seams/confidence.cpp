#include "core/pattern/seams/confidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// By its margin and the lengths of its sides, mm.
double chance_of(double margin, double a, double b) {
  const double chance = 1 / (1 + std::exp(-(margin - kConfidenceWeights.even) / kConfidenceWeights.slope));
  const double difference = std::abs(a - b) / std::max(a, b);
  return chance *
         (1 - kConfidenceWeights.gathers * std::max(0.0, difference - kConfidenceWeights.gathers_begin));
}

/// The pairs of runs that a seam joins, each with the lesser first, rising. With `mirrored`, those on the
/// mirrored pieces; nothing where one of them has no mirror image.
std::vector<std::array<Index, 2>> joined_runs(const SeamModel& model, const FoundSeam& seam, bool mirrored) {
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t k = 0; k < seam.a.size(); ++k) {
    const Index a = mirrored ? model.mirror[seam.a[k]] : seam.a[k];
    const Index b = mirrored ? model.mirror[seam.b[k]] : seam.b[k];
    if (a == kNone || b == kNone) return {};
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Left and right are sewn alike: a seam is as sure as its mirror image, of which the garment has both. Each
/// by itself may seem to be missed less, since the other's pieces could take its place.
void share_with_mirror_images(FoundSeams& found) {
  std::map<std::vector<std::array<Index, 2>>, double> margin;
  for (const FoundSeam& seam : found.seams) margin[joined_runs(found.model, seam, false)] = seam.margin;
  for (FoundSeam& seam : found.seams) {
    const auto twin = margin.find(joined_runs(found.model, seam, true));
    if (twin != margin.end()) seam.margin = std::max(seam.margin, twin->second);
  }
}

bool are_neighbours(const SeamModel& m, Index x, Index y) {
  return m.runs[x].next == y || m.runs[y].next == x;
}

/// Whether the seam brings the ends of runs x and y together, which are of two pieces.
bool leads_over(const SeamModel& m, const FoundSeam& seam, Index x, Index y) {
  if (seam.a.size() != 1) return false;
  const Index a = seam.a[0], b = seam.b[0];
  return (are_neighbours(m, a, x) && are_neighbours(m, b, y)) ||
         (are_neighbours(m, a, y) && are_neighbours(m, b, x));
}

/// A sleeve that is sewn to front and back needs the shoulder: a seam over which another leads is as sure as
/// that.
void share_with_what_leads_over(FoundSeams& found) {
  const SeamModel& m = found.model;
  for (const FoundSeam& over : found.seams) {
    for (const std::vector<Index>* side : {&over.a, &over.b}) {
      for (std::size_t k = 1; k < side->size(); ++k) {
        const Index x = (*side)[k - 1], y = (*side)[k];
        if (m.runs[x].panel == m.runs[y].panel) continue;
        for (FoundSeam& seam : found.seams)
          if (leads_over(m, seam, x, y)) seam.margin = std::max(seam.margin, over.margin);
      }
    }
  }
}

bool is_middle_of_back(const SeamModel& m, const FoundSeam& seam) {
  if (seam.a.size() != 1 || seam.b.size() != 1 || m.mirror[seam.a[0]] != seam.b[0]) return false;
  const SeamRun &a = m.runs[seam.a[0]], &b = m.runs[seam.b[0]];
  // It is straight, or shaped a little where a back is fitted.
  const bool upright =
      std::abs(dot(normalized(a.at.back() - a.at.front()), m.up[a.panel])) > kPairWeights.twin_straight_rise;
  const bool shaped = upright && std::abs(a.turn.back()) < kPairWeights.curved_deg;
  return a.panel != b.panel && (a.straight || shaped) && m.words[a.panel].face < 0 &&
         m.words[b.panel].face < 0;
}

/// Whether the seam joins the two halves of a waistband, or of a hood.
bool joins_band_or_hood(const SeamModel& m, const FoundSeam& seam) {
  for (std::size_t k = 0; k < seam.a.size(); ++k)
    if (m.mirror[seam.a[k]] != seam.b[k]) return false;
  const Index p = m.runs[seam.a[0]].panel, q = m.runs[seam.b[0]].panel;
  const PieceKind kind = m.words[p].kind;
  return p != q && m.words[q].kind == kind && (kind == PieceKind::kBand || kind == PieceKind::kHood);
}

/// Fronts may stay open in the middle; a back that is cut in two halves does not, if it is sewn to anything,
/// and neither does a waistband, which is closed when it is worn, or a hood over the head.
void share_with_sides(FoundSeams& found) {
  const SeamModel& m = found.model;
  for (FoundSeam& middle : found.seams) {
    const bool closed = joins_band_or_hood(m, middle);
    if (!closed && !is_middle_of_back(m, middle)) continue;
    const Index half = m.runs[middle.a[0]].panel, other = m.runs[middle.b[0]].panel;
    const bool only = std::count_if(found.seams.begin(), found.seams.end(), [&](const FoundSeam& seam) {
                        return is_middle_of_back(m, seam) &&
                               (m.runs[seam.a[0]].panel == half || m.runs[seam.a[0]].panel == other);
                      }) == 1;
    if (!only && !closed) continue;
    double surest = 0;
    for (const FoundSeam& seam : found.seams) {
      const Index p = m.runs[seam.a[0]].panel, q = m.runs[seam.b[0]].panel;
      if ((p == half) == (q == half) || p == other || q == other) continue;
      surest = std::max(surest, seam.margin);
    }
    middle.margin = std::max(middle.margin, surest);
  }
}

/// Where pieces lie upon others there is a seam for every edge in every layer, and nothing in their outlines
/// says which belong to one: such seams are for a person to decide, the more where a layer takes part.
double layer_share(const FoundSeams& found, const FoundSeam& seam) {
  const auto is_layer = [](const PieceWords& words) { return words.layer; };
  const std::vector<PieceWords>& words = found.model.words;
  if (std::none_of(words.begin(), words.end(), is_layer)) return 1;
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side)
      if (words[found.model.runs[r].panel].layer) return kConfidenceWeights.layer;
  return kConfidenceWeights.beside_layer;
}

/// Collars stand, or are folded over, which changes the way their seams run. Outlines do not say, but for
/// lapels, which are folded.
double collar_share(const FoundSeams& found, const FoundSeam& seam) {
  const SeamModel& m = found.model;
  bool collar = false, lapel = false;
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side) collar = collar || m.words[m.runs[r].panel].kind == PieceKind::kCollar;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) lapel = lapel || is_lapel(m, p);
  return !collar ? 1 : lapel ? kConfidenceWeights.folded_collar : kConfidenceWeights.collar;
}

/// Where two pieces of a file have one role, as in a wardrobe, nothing says which is meant.
double rival_share(const FoundSeams& found, const FoundSeam& seam) {
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side)
      if (found.model.rival[found.model.runs[r].panel]) return kConfidenceWeights.rival;
  return 1;
}

/// Whether the seam joins the two halves of a front, or of a back, as their names tell them, or two pieces of
/// a bodice that mirror each other, by the same edge of both. Halves need not be alike.
bool joins_halves(const SeamModel& m, const FoundSeam& seam) {
  if (seam.a.size() != 1 || seam.b.size() != 1) return false;
  const Index p = m.runs[seam.a[0]].panel, q = m.runs[seam.b[0]].panel;
  const PieceWords &x = m.words[p], &y = m.words[q];
  if (p == q || x.kind != PieceKind::kTorso || y.kind != PieceKind::kTorso) return false;
  return m.mirror[seam.a[0]] == seam.b[0] || (x.side * y.side < 0 && x.face * y.face > 0);
}

/// Halves of a bodice meet in its middle, which runs along the grain, up to the neck: what they would be sewn
/// along from there, aslant, is the neck itself, which has to stay open for a head.
double neck_share(const FoundSeams& found, const FoundSeam& seam) {
  const SeamModel& m = found.model;
  const auto upright = [&](const FoundSeam& halves) {
    const SeamRun& run = m.runs[halves.a[0]];
    const double rise = std::abs(dot(normalized(run.at.back() - run.at.front()), m.up[run.panel]));
    return rise > kPairWeights.twin_straight_rise;
  };
  if (!joins_halves(m, seam) || upright(seam)) return 1;
  const bool neck = std::any_of(found.seams.begin(), found.seams.end(), [&](const FoundSeam& other) {
    return joins_halves(m, other) && upright(other) &&
           (are_neighbours(m, seam.a[0], other.a[0]) || are_neighbours(m, seam.a[0], other.b[0]));
  });
  return neck ? kConfidenceWeights.beside_middle : 1;
}

/// Gores go around what they hang from, and nothing says how far they are turned.
double gores_share(const FoundSeams& found, const FoundSeam& seam) {
  const SeamModel& m = found.model;
  const auto gore = [&](Index r) {
    const Index p = m.runs[r].panel;
    return m.rows[p].size > 2 && m.words[p].kind == PieceKind::kSkirt;
  };
  const bool a = std::any_of(seam.a.begin(), seam.a.end(), gore);
  const bool b = std::any_of(seam.b.begin(), seam.b.end(), gore);
  return a != b ? kConfidenceWeights.gores : 1;
}

}  // namespace

void share_margins(FoundSeams& found) {
  share_with_what_leads_over(found);
  share_with_mirror_images(found);
  share_with_sides(found);
}

double confidence_of(const FoundSeams& found, const FoundSeam& seam, double a, double b) {
  return chance_of(seam.margin, a, b) * layer_share(found, seam) * collar_share(found, seam) *
         rival_share(found, seam) * gores_share(found, seam) * neck_share(found, seam);
}

double belief_in(const FoundSeams& found, bool sides_known) {
  double named = 0;
  for (const PieceWords& words : found.model.words)
    named +=
        !(found.model.nameless && words.guessed) && (words.kind != PieceKind::kOther || words.side != 0 ||
                                                     words.face != 0 || words.limb || words.layer)
            ? 1
            : 0;
  const double share =
      named / std::max(1.0, static_cast<double>(found.model.words.size())) / kConfidenceWeights.enough_names;
  return sides_known ? 1
                     : std::min(1.0, kConfidenceWeights.nameless + (1 - kConfidenceWeights.nameless) * share);
}

}  // namespace toile::seams
