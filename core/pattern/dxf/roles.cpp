#include "core/pattern/dxf/roles.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/geometry/polygon2.h"

namespace toile::dxf {
namespace {

constexpr double kWidestGap = 1;       // mm that are closed without a question
constexpr double kWidestShare = 2e-3;  // of the line's length, likewise
constexpr double kSliver = 1e-3;       // of the line's length squared: less area than that is no outline

/// Whether the open chain is a half that the fold closes.
bool ends_at_a_fold(const DxfChain& chain, const std::vector<DxfFold>& folds) {
  return std::any_of(folds.begin(), folds.end(), [&](const DxfFold& fold) {
    return closes_at_fold(chain.points, fold.axis) && !spans_fold(chain.points, fold.axis);
  });
}

/// Whether the open chain stops so little short that it was meant to close.
bool nearly_closes(const DxfChain& chain) {
  const double gap = length(chain.points.front() - chain.points.back());
  const double way = geometry::polyline_length(chain.points);
  return !(gap > std::max(kWidestGap, kWidestShare * way) || gap > way / 4 ||
           std::abs(geometry::signed_area(chain.points)) < kSliver * way * way);
}

void tell_gap(const DxfChain& chain, DxfNotes& notes) {
  const double gap = length(chain.points.front() - chain.points.back());
  notes.warn(chain.line,
             "the outline on layer " + chain.layer + " had a gap of " + significant_text(gap, 3) +
                 " mm and was closed",
             -1, chain.points.back());
}

}  // namespace

bool makes_aama(const std::string& layer, const DxfLayerMap& given) {
  const DxfRole role = repeated_role(layer, given);
  return role == DxfRole::kCut || role == DxfRole::kSew;
}

DxfRoles roles_of(const std::vector<DxfChain>& chains, const DxfLayerMap& given) {
  std::set<DxfRole> there;  // on the layers of their own numbers
  bool by_aama = false;
  for (const DxfChain& c : chains) {
    there.insert(role_of_layer(c.layer, given));
    by_aama = by_aama || makes_aama(c.layer, given);
  }
  // Of layers that repeat others those have something to say whose others are empty.
  const auto role_of = [&](const std::string& layer) {
    const DxfRole deep = repeated_role(layer, given);
    return there.contains(deep) ? role_of_layer(layer, given) : deep;
  };
  DxfRoles roles;
  roles.by_aama = by_aama;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const std::optional<DxfRole> told =
        told_role(chains[i].layer, geometry::polyline_length(chains[i].points), given);
    roles.told.push_back(told.has_value());
    roles.of.push_back(told ? *told : by_aama ? role_of(chains[i].layer) : DxfRole::kCut);
    if (chains[i].inner && roles.makes_outlines(i)) roles.of[i] = DxfRole::kInternal;
  }
  return roles;
}

std::vector<DxfFold> folds_of(const std::vector<DxfChain>& chains, const DxfRoles& roles) {
  std::vector<DxfFold> folds;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (roles.of[i] == DxfRole::kMirror && !chains[i].closed)
      if (const auto axis = fold_axis(chains[i].points)) folds.push_back({i, *axis});
  return folds;
}

DxfClosed closed_at_gaps(std::vector<DxfChain> chains, const DxfRoles& roles,
                         const std::vector<DxfFold>& folds) {
  DxfNotes notes;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    DxfChain& chain = chains[i];
    if (chain.closed || !roles.makes_outlines(i) || chain.points.size() < 3) continue;
    const bool at_fold = ends_at_a_fold(chain, folds);
    if (!at_fold && !nearly_closes(chain)) continue;
    chain.closed = true;
    if (!at_fold) tell_gap(chain, notes);
  }
  return {std::move(chains), std::move(notes)};
}

}  // namespace toile::dxf
