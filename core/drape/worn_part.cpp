#include "core/drape/worn_part.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/disjoint_sets.h"
#include "core/drape/left_open.h"
#include "core/dressing/person.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/mesh/sewn_part.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/strangers.h"
#include "core/sewing/assembly.h"

namespace toile::drape {
namespace {

constexpr double kEnoughForBorders = 0.03;  // m; enough to tell how many borders a part has
constexpr double kTrifle = 0.03;            // of the largest part's area: a pocket sewn to itself
constexpr double kTrim = 0.02;              // of all cloth: a loop or a tab, smaller than a collar or a cuff

/// Whether all panels hang together by seams, without looking at any mesh.
bool all_sewn(const pattern::Pattern& pattern) {
  DisjointSets panels(pattern.panels.size());
  std::size_t parts = pattern.panels.size();
  for (const pattern::Seam& seam : pattern.seams)
    for (const std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (const pattern::SeamEdge& e : *side)
        if (panels.join(seam.a.front().panel, e.panel)) --parts;
  return parts <= 1;
}

/// Panels that something other than a seam holds.
std::vector<char> held_panels(const DrapeInput& input) {
  std::vector<char> held(input.pattern.panels.size(), 0);
  for (const sewing::Attachment& a : input.attachments) held[a.panel] = 1;
  for (const sewing::Button& b : input.notions.buttons) held[b.a.panel] = held[b.b.panel] = 1;
  for (const sewing::Cushion& c : input.notions.cushions)
    for (const Index p : c.panels) held[p] = 1;
  return held;
}

/// By its name of a sleeve, a collar, a cuff, a frill: worn only where it is sewn to a garment.
bool belongs_to_another(const std::string& name) {
  using enum seams::PieceKind;
  const seams::PieceWords words = seams::words_of(name);
  return words.limb || words.layer || words.kind == kSleeve || words.kind == kCuff || words.kind == kFrill ||
         words.kind == kCollar || words.kind == kInsert;
}

/// Panels of the parts that can be worn.
std::vector<Index> worn_panels(const DrapeInput& input, const std::vector<mesh::SewnPart>& parts) {
  const std::vector<char> held = held_panels(input);
  const auto largest =
      std::max_element(parts.begin(), parts.end(),
                       [](const mesh::SewnPart& a, const mesh::SewnPart& b) { return a.area < b.area; });
  std::vector<Index> worn;
  for (const mesh::SewnPart& part : parts) {
    const auto any = [&](auto is) { return std::any_of(part.panels.begin(), part.panels.end(), is); };
    const bool garment = part.borders.size() > 1 && part.area > kTrifle * largest->area &&
                         any([&](Index p) { return !belongs_to_another(input.pattern.panels[p].id); });
    const bool keeps =
        &part == &*largest || largest->seams == 0 || garment || any([&](Index p) { return held[p] != 0; });
    if (keeps) worn.insert(worn.end(), part.panels.begin(), part.panels.end());
  }
  std::sort(worn.begin(), worn.end());
  return worn;
}

bool is_layered(const pattern::Pattern& pattern) {
  return std::any_of(pattern.panels.begin(), pattern.panels.end(),
                     [&](const pattern::Panel& p) { return p.layer != pattern.panels.front().layer; });
}

void tell_places(const mesh::PanelMeshes& meshes, const DrapeInput& input, std::vector<LeftOut>& left_out) {
  const auto placed = sewing::assemble(meshes, input.placements, {}, {});
  if (!placed) return;  // the drape will say why
  for (LeftOut& piece : left_out) {
    const auto panel = std::find_if(input.pattern.panels.begin(), input.pattern.panels.end(),
                                    [&](const pattern::Panel& p) { return p.id == piece.id; });
    if (panel == input.pattern.panels.end()) continue;  // left out before
    const auto p = static_cast<std::size_t>(panel - input.pattern.panels.begin());
    const auto first = static_cast<std::size_t>(placed->garment.first_vertex[p]);
    const auto end = static_cast<std::size_t>(placed->garment.first_vertex[p + 1]);
    piece.place = bounding_box(std::span(placed->positions).subspan(first, end - first)).middle();
  }
}

/// Renumbers panels; what names one that is gone goes, too.
class Renumbering {
 public:
  Renumbering(std::size_t panels, const std::vector<Index>& kept) : now_(panels, kNone) {
    for (std::size_t i = 0; i < kept.size(); ++i) now_[kept[i]] = static_cast<Index>(i);
  }

  bool take(Index& panel) const {
    panel = now_[panel];
    return panel != kNone;
  }
  template <typename T>
  std::vector<T> those_of_panels(std::vector<T> all) const {
    std::erase_if(all, [&](T& one) { return !take(one.panel); });
    return all;
  }

 private:
  std::vector<Index> now_;
};

/// Of each panel whether the garment is whole without it: what lies on other cloth, and small pieces of which
/// nothing tells what they are.
std::vector<char> only_trims(const pattern::Pattern& pattern) {
  std::vector<char> trims = seams::sewn_last(pattern);
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  double cloth = 0;  // mm²
  for (const pattern::Panel& panel : pattern.panels) cloth += std::abs(pattern::signed_area(panel.outline));
  for (std::size_t p = 0; p < trims.size(); ++p)
    trims[p] = words[p].layer ||
               (trims[p] && std::abs(pattern::signed_area(pattern.panels[p].outline)) < kTrim * cloth);
  return trims;
}

void renumber(const Renumbering& now, std::vector<pattern::Seam>& seams) {
  std::erase_if(seams, [&](pattern::Seam& seam) {
    bool stays = true;
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) stays = now.take(e.panel) && stays;
    return !stays;
  });
}

void renumber(const Renumbering& now, sewing::Notions& notions) {
  std::erase_if(notions.buttons, [&](sewing::Button& b) {
    const bool a = now.take(b.a.panel);
    return !now.take(b.b.panel) || !a;
  });
  notions.elastics = now.those_of_panels(std::move(notions.elastics));
  notions.creases = now.those_of_panels(std::move(notions.creases));
  for (sewing::Cushion& c : notions.cushions) std::erase_if(c.panels, [&](Index& p) { return !now.take(p); });
  std::erase_if(notions.cushions, [](const sewing::Cushion& c) { return c.panels.empty(); });
}

}  // namespace

DrapeInput with_panels(const DrapeInput& input, const std::vector<Index>& kept) {
  DrapeInput some = input;
  const Renumbering now(input.pattern.panels.size(), kept);
  some.pattern.panels.clear();
  some.placements.clear();
  some.fabric_of_panel.clear();
  for (const Index p : kept) {
    some.pattern.panels.push_back(input.pattern.panels[p]);
    some.placements.push_back(input.placements[p]);
    some.fabric_of_panel.push_back(input.fabric_of_panel[p]);
  }
  renumber(now, some.pattern.seams);
  renumber(now, some.left_open);
  some.attachments = now.those_of_panels(std::move(some.attachments));
  renumber(now, some.notions);
  const std::vector<seams::PieceWords> words = seams::garment_words(input.pattern);
  const std::vector<char> trims = only_trims(input.pattern);
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    if (std::binary_search(kept.begin(), kept.end(), static_cast<Index>(p))) continue;
    const std::string& id = input.pattern.panels[p].id;
    some.left_out.push_back({id, trims[p] != 0, {}, false, seams::is_tied(words[p])});
  }
  return some;
}

DrapeInput worn_part(DrapeInput input) {
  input = with_seams_that_can_be_sewn(std::move(input));
  const pattern::Pattern& pattern = input.pattern;
  if (!input.settings.dress || pattern.seams.empty() || is_layered(pattern) || all_sewn(pattern))
    return input;
  if (!dressing::find_person(input.bodies)) return input;
  const double distance = std::max(kEnoughForBorders, input.settings.particle_distance);
  const auto meshes = mesh::make_panel_meshes(pattern, distance, {});
  if (!meshes) return input;  // the drape will say why
  const std::vector<Index> worn = worn_panels(input, mesh::sewn_parts(*meshes));
  if (worn.size() == pattern.panels.size()) return input;
  DrapeInput part = with_panels(input, worn);
  tell_places(*meshes, input, part.left_out);
  return part;
}

std::vector<std::string> names_left_out(const DrapeInput& input) {
  std::vector<std::string> names;
  for (const LeftOut& piece : input.left_out) names.push_back(piece.id);
  return names;
}

void tell_left_out(const DrapeInput& input, preflight::Findings& findings) {
  const std::string loose =
      "no seam holds this piece on, so that it is left out of the drape; sew it to the others, or attach it";
  const std::string in_the_way =
      "with this piece the garment could not be put on the body, so that it is left out of the drape; see to "
      "its seams, and whether one is missing";
  const std::string knotted =
      "a belt or a tie is knotted around the garment, which is not simulated: it is left out of the drape";
  for (const LeftOut& piece : input.left_out) {
    preflight::Finding& told =
        findings.emplace_back(preflight::found(preflight::FindingKind::kLeftOut,
                                               piece.tried  ? in_the_way
                                               : piece.tied ? knotted
                                                            : loose,
                                               {preflight::piece_named(piece.id)}, piece.place));
    if (piece.layer || piece.tied) told.severity = preflight::Severity::kNote;
  }
  preflight::sort_by_severity(findings);
}

}  // namespace toile::drape
