#include "core/pattern/seams/mirror_images.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/pattern/curve.h"
#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/taken_edges.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

using Edges = std::vector<pattern::SeamEdge>;

bool is_one(const pattern::SeamEdge& x, const pattern::SeamEdge& y) {
  constexpr double kNear = 1e-3;  // of an edge's length
  return x.panel == y.panel && x.edge == y.edge && std::abs(x.from - y.from) < kNear &&
         std::abs(x.to - y.to) < kNear;
}

bool holds_same(const Edges& x, const Edges& y) {
  return x.size() == y.size() && std::all_of(x.begin(), x.end(), [&](const pattern::SeamEdge& e) {
           return std::any_of(y.begin(), y.end(), [&](const pattern::SeamEdge& f) { return is_one(e, f); });
         });
}

bool is_one(const pattern::Seam& x, const pattern::Seam& y) {
  return (holds_same(x.a, y.a) && holds_same(x.b, y.b)) || (holds_same(x.a, y.b) && holds_same(x.b, y.a));
}

/// The seams of a pattern seen in a mirror.
class Mirrors {
 public:
  Mirrors(const pattern::Pattern& pattern, const SeamModel& model)
      : model_(model), first_(first_runs(pattern)) {}

  /// Nothing where one of its edges has no image, as those of holes, or lies on other cloth.
  std::optional<pattern::Seam> image_of(pattern::Seam seam) const {
    for (Edges* side : {&seam.a, &seam.b}) {
      for (pattern::SeamEdge& e : *side) {
        const Index r = first_[e.panel] + e.edge;
        if (r >= first_[e.panel + 1]) return std::nullopt;
        const SeamRun& run = model_.runs[r];
        if (run.mirror_panel == kNone || run.mirror_edge == kNone) return std::nullopt;
        if (model_.words[e.panel].layer || model_.words[run.mirror_panel].layer) return std::nullopt;
        e = {run.mirror_panel, run.mirror_edge, !e.reversed, 1 - e.to, 1 - e.from};
      }
    }
    say_plainly(seam);
    return seam;
  }

 private:
  const SeamModel& model_;
  const std::vector<Index> first_;
};

}  // namespace

std::vector<SeamProposal> with_mirror_images(const pattern::Pattern& pattern,
                                             std::vector<SeamProposal> proposals) {
  const SeamModel model = make_seam_model(pattern);
  const Mirrors mirrors(pattern, model);
  const std::vector<bool> sewn = sewn_together(proposals, kLikely);
  TakenEdges taken;
  for (const pattern::Seam& seam : pattern.seams) taken.take(seam);
  for (std::size_t i = 0; i < proposals.size(); ++i)
    if (sewn[i]) taken.take(proposals[i].seam);
  std::vector<SeamProposal> all = proposals;
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    if (!sewn[i] || proposals[i].confidence < kFits) continue;
    const std::optional<pattern::Seam> image = mirrors.image_of(proposals[i].seam);
    if (!image || is_one(*image, proposals[i].seam) || taken.clashes(*image)) continue;
    taken.take(*image);
    const double confidence = kConfidenceWeights.mirror_image * proposals[i].confidence;
    const auto told =
        std::find_if(all.begin(), all.end(), [&](const SeamProposal& p) { return is_one(p.seam, *image); });
    if (told != all.end()) {
      told->confidence = std::max(told->confidence, confidence);
      continue;
    }
    all.push_back({*image, confidence, proposals[i].length_a, proposals[i].length_b});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const SeamProposal& x, const SeamProposal& y) { return x.confidence > y.confidence; });
  return all;
}

}  // namespace toile::seams
