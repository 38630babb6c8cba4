#include "core/project/create/waist_elastic.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/weights.h"

namespace toile::create {
namespace {

// A waist is about 0.75 of the hip, which has to pass the edge with ease: the elastic is shorter than that,
// so that it holds on slim waists too; N per strain.
constexpr double kFactor = 0.55, kStiffness = 40;
constexpr double kHipBelow = 180;  // mm from the waist
constexpr double kAsWide = 0.88;   // times as wide as there: less is a shaped waist

bool is_lower(const seams::PieceWords& words) {
  return words.kind == seams::PieceKind::kLegs || words.kind == seams::PieceKind::kSkirt;
}

/// Whether the garment is of legs and skirts, and nothing that these hang from.
bool hangs_from_nothing(const seams::SeamModel& m) {
  using enum seams::PieceKind;
  bool lower = false;
  for (const seams::PieceWords& words : m.words) {
    if (words.layer) continue;
    if (words.kind == kTorso || words.kind == kBand || words.kind == kStrap || words.yoke) return false;
    lower = lower || is_lower(words);
  }
  return lower;
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

/// The upper edges of a piece; nothing where seams take one, or its waist is shaped.
std::optional<std::vector<Index>> waist_of(const seams::SeamModel& m, Index panel,
                                           const std::vector<pattern::Seam>& sewn) {
  std::vector<Index> edges;
  double length = 0, height = -HUGE_VAL;
  for (const seams::SeamRun& run : m.runs) {
    if (run.panel != panel || run.up < seams::kPairWeights.facing) continue;
    if (takes(sewn, run)) return std::nullopt;
    edges.push_back(run.edge);
    length += run.length;
    height = std::max(height, dot(run.at.front(), m.up[panel]));
  }
  if (edges.empty() || length < kAsWide * width_at(m, panel, height - kHipBelow)) return std::nullopt;
  return edges;
}

}  // namespace

std::vector<project::ProjectElastic> waist_elastics(const pattern::Pattern& pattern,
                                                    const std::vector<pattern::Seam>& proposed) {
  const seams::SeamModel m = seams::make_seam_model(pattern);
  if (!hangs_from_nothing(m)) return {};
  std::vector<project::ProjectElastic> elastics;
  for (Index p = 0; p < static_cast<Index>(pattern.panels.size()); ++p) {
    if (!is_lower(m.words[p]) || m.words[p].layer || m.level[p] > 0) continue;
    const std::optional<std::vector<Index>> waist = waist_of(m, p, proposed);
    if (!waist) return {};
    project::ProjectElastic& elastic = elastics.emplace_back();
    elastic.id = "waist_" + pattern.panels[p].id;
    elastic.piece = pattern.panels[p].id;
    for (const Index e : *waist) elastic.lines.push_back(pattern.panels[p].outline.edges[e].id);
    elastic.factor = kFactor;
    elastic.stiffness_n = kStiffness;
  }
  return elastics;
}

}  // namespace toile::create
