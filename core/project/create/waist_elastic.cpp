#include "core/project/create/waist_elastic.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/weights.h"

namespace toile::create {
namespace {

// A waist is about 0.75 of the hip, which has to pass the edge with ease: the elastic is shorter than that,
// so that it holds on slim waists too; N per strain.
constexpr double kFactor = 0.55, kStiffness = 40;
constexpr double kBandFactor =
    0.45;  // of a casing sewn on, which is stiffer: it gathers less than it is asked to
constexpr double kHipBelow = 180;      // mm from the waist
constexpr double kAsWide = 0.88;       // times as wide as there: less is a shaped waist …
constexpr double kStraight = 0.95;     // … and this where a band tells that it may be …
constexpr double kAsWideClosed = 0.8;  // … but only this where nothing else lets the hip pass it
constexpr double kCasingFits = 0.03;   // share that a casing is longer or shorter: bands lap over

bool is_lower(const seams::PieceWords& words) {
  return words.kind == seams::PieceKind::kLegs || words.kind == seams::PieceKind::kSkirt;
}

/// What the garment's legs and skirts hang from.
struct Waist {
  bool lower = false;              ///< there are legs or skirts
  bool held = false;               ///< by a bodice, a yoke, straps or more than one band
  std::optional<Index> band = {};  ///< the only one
};

Waist waist_of_garment(const seams::SeamModel& m) {
  using enum seams::PieceKind;
  Waist waist;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) {
    const seams::PieceWords& words = m.words[p];
    if (words.layer) continue;
    const bool second = words.kind == kBand && waist.band;
    const bool strap = words.kind == kStrap && !seams::is_tied(words);
    waist.held = waist.held || words.kind == kTorso || strap || words.yoke || second;
    waist.lower = waist.lower || is_lower(words);
    if (words.kind == kBand) waist.band = p;
  }
  return waist;
}

/// How wide the piece is where that height (mm along its grain) crosses its outline.
double width_at(const seams::SeamModel& m, Index panel, double height) {
  const Vec2 up = m.up[panel], right{up.y, -up.x};
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const seams::SeamRun& run : m.runs) {
    if (run.panel != panel) continue;
    for (std::size_t k = 1; k < run.at.size(); ++k) {
      const double a = dot(run.at[k - 1], up) - height, b = dot(run.at[k], up) - height;
      if (a * b > 0 || a == b) continue;
      const Vec2 p = run.at[k - 1] + (run.at[k] - run.at[k - 1]) * (a / (a - b));
      low = std::min(low, dot(p, right));
      high = std::max(high, dot(p, right));
    }
  }
  return std::max(0.0, high - low);
}

bool takes(const std::vector<pattern::Seam>& seams, const seams::SeamRun& run) {
  return std::any_of(seams.begin(), seams.end(), [&](const pattern::Seam& seam) {
    const auto on = [&](const std::vector<pattern::SeamEdge>& side) {
      return std::any_of(side.begin(), side.end(), [&](const pattern::SeamEdge& e) {
        return e.panel == run.panel && e.edge == run.edge;
      });
    };
    return on(seam.a) || on(seam.b);
  });
}

/// The upper edges of a piece.
struct UpperEdges {
  std::vector<Index> edges;
  double length = 0;  ///< mm
};

/// Nothing where the piece's waist is shaped.
std::optional<UpperEdges> upper_edges(const seams::SeamModel& m, Index panel, double as_wide) {
  UpperEdges upper;
  double height = -HUGE_VAL, low = HUGE_VAL;
  for (const seams::SeamRun& run : m.runs) {
    if (run.panel != panel) continue;
    low = std::min(low, dot(run.at.front(), m.up[panel]));
    if (run.up < seams::kPairWeights.facing) continue;
    upper.edges.push_back(run.edge);
    upper.length += run.length;
    height = std::max(height, dot(run.at.front(), m.up[panel]));
  }
  const double hip = std::max(height - kHipBelow, low + 1);  // a tier may be shorter than that
  if (upper.edges.empty() || upper.length < as_wide * width_at(m, panel, hip)) return std::nullopt;
  return upper;
}

project::ProjectElastic elastic_along(const pattern::Panel& panel, const std::vector<Index>& edges,
                                      double factor) {
  project::ProjectElastic elastic;
  elastic.id = "waist_" + panel.id;
  elastic.piece = panel.id;
  for (const Index e : edges) elastic.lines.push_back(panel.outline.edges[e].id);
  elastic.factor = factor;
  elastic.stiffness_n = kStiffness;
  return elastic;
}

/// Whether a dart shapes the waist, or a fly, a zip or an underlap opens it.
bool opens_or_is_shaped(const pattern::Pattern& pattern, const std::vector<pattern::Seam>& sewn) {
  const bool dart = std::any_of(sewn.begin(), sewn.end(), [](const pattern::Seam& seam) {
    return seam.a.size() == 1 && seam.b.size() == 1 && seam.a[0].panel == seam.b[0].panel &&
           std::abs(seam.a[0].edge - seam.b[0].edge) == 1;
  });
  return dart || std::any_of(pattern.panels.begin(), pattern.panels.end(), [](const pattern::Panel& panel) {
           const std::vector<std::string> words = seams::words_of_piece(panel.id);
           return std::any_of(words.begin(), words.end(), [](const std::string& word) {
             return word == "fly" || word == "zip" || word == "zipper" || word == "placket";
           });
         });
}

/// The elastic of a casing: a strip as long as what hangs from it, which is not shaped to a waist.
std::vector<project::ProjectElastic> casing_elastic(const pattern::Pattern& pattern,
                                                    const seams::SeamModel& m, Index band,
                                                    const std::vector<pattern::Seam>& sewn) {
  double below = 0;
  const double straight = opens_or_is_shaped(pattern, sewn) ? kStraight : kAsWideClosed;
  for (Index p = 0; p < static_cast<Index>(pattern.panels.size()); ++p) {
    if (!is_lower(m.words[p]) || m.words[p].layer || m.level[p] > 0) continue;
    const std::optional<UpperEdges> upper = upper_edges(m, p, straight);
    if (!upper) return {};
    below += upper->length;
  }
  std::vector<Index> free;
  double length = 0;
  for (const seams::SeamRun& run : m.runs) {
    if (run.panel != band || takes(sewn, run)) continue;
    free.push_back(run.edge);
    length += run.length;
  }
  if (free.size() != 1 || std::abs(length - below) > kCasingFits * below) return {};
  return {elastic_along(pattern.panels[band], free, kBandFactor)};
}

}  // namespace

std::vector<project::ProjectElastic> waist_elastics(const pattern::Pattern& pattern,
                                                    const std::vector<pattern::Seam>& proposed) {
  const seams::SeamModel m = seams::make_seam_model(pattern);
  const Waist waist = waist_of_garment(m);
  if (!waist.lower || waist.held) return {};
  if (waist.band) return casing_elastic(pattern, m, *waist.band, proposed);
  std::vector<project::ProjectElastic> elastics;
  const double as_wide = opens_or_is_shaped(pattern, proposed) ? kAsWide : kAsWideClosed;
  for (Index p = 0; p < static_cast<Index>(pattern.panels.size()); ++p) {
    if (!is_lower(m.words[p]) || m.words[p].layer || m.level[p] > 0) continue;
    const std::optional<UpperEdges> upper = upper_edges(m, p, as_wide);
    const bool taken = std::any_of(m.runs.begin(), m.runs.end(), [&](const seams::SeamRun& run) {
      return run.panel == p && run.up >= seams::kPairWeights.facing && takes(proposed, run);
    });
    if (!upper || taken) return {};
    elastics.push_back(elastic_along(pattern.panels[p], upper->edges, kFactor));
  }
  return elastics;
}

}  // namespace toile::create
