#include "core/pattern/seams/second_layers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>

#include "core/pattern/seams/likeness.h"

namespace toile::seams {
namespace {

constexpr const char* kMirrored = "_mirrored";

/// The name of the drawn piece that a panel is a copy of: "hood_mirrored_2" is one of "hood".
std::string drawn_name(std::string id) {
  const std::size_t end = id.find_last_not_of("0123456789");
  if (end != std::string::npos && end + 1 < id.size() && id[end] == '_') id.resize(end);
  if (id.ends_with(kMirrored)) id.resize(id.size() - std::string(kMirrored).size());
  return id;
}

/// Whether a band of that length (mm) goes around an end of the fronts and backs together, the lower one of a
/// top or the upper one of what hangs from the waist; ribs are shorter than what they hold in.
bool goes_around(const SeamModel& m, double length) {
  constexpr double kShortest = 0.75, kLongest = 1.12, kLevel = 0.9;
  double above = 0, below = 0;  // mm
  for (const SeamRun& run : m.runs) {
    if (m.words[run.panel].face == 0 || m.words[run.panel].layer) continue;
    if (run.up > kLevel) above += run.length;
    if (run.up < -kLevel) below += run.length;
  }
  const auto fits = [&](double end) { return length > kShortest * end && length < kLongest * end; };
  return fits(above) || fits(below);
}

/// How many copies of a band are worn: one where it goes all around and two would be too long.
std::size_t worn_bands(const SeamModel& m, Index panel) {
  double longest = 0;
  for (const SeamRun& run : m.runs)
    if (run.panel == panel) longest = std::max(longest, run.length);
  return goes_around(m, longest) && !goes_around(m, 2 * longest) ? 1 : 0;
}

/// Whether it is faced with its own cloth.
bool is_faced(const PieceWords& words) {
  return words.kind == PieceKind::kCollar || words.kind == PieceKind::kHood || words.yoke;
}

/// How many copies of the piece are worn outside; 0 where nothing tells. What is its own mirror image lies in
/// the middle of the body, but for what is worn on limbs.
std::size_t worn_copies(const SeamModel& m, Index panel) {
  const PieceWords& words = m.words[panel];
  const bool other_face = std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) {
    return (w.kind == words.kind || w.kind == PieceKind::kOther) && !w.layer && w.face * words.face < 0;
  });
  // A bib with what lines it, a waistband's front that is cut twice.
  if ((words.kind == PieceKind::kTorso || words.kind == PieceKind::kBand) && other_face)
    return mirrors_itself(m, panel) ? 1 : words.yoke ? 2 : 0;
  if (words.kind == PieceKind::kBand && words.side != 0) return 1;
  if (words.kind == PieceKind::kBand || words.hem_band) return worn_bands(m, panel);
  if (words.kind == PieceKind::kCuff || words.kind == PieceKind::kSleeve) return words.side != 0 ? 1 : 2;
  if (!is_faced(words)) return 0;
  return mirrors_itself(m, panel) || words.side != 0 ? 1 : 2;
}

/// Whether the names are those that copies of one drawn piece get: some of them turned over, or counted from
/// one, or, where the copies look the same turned over (`alike`), from two. Files that name each piece count
/// from nought, or differ in more.
bool are_copies(const pattern::Pattern& pattern, const std::vector<Index>& panels, const std::string& drawn,
                bool alike) {
  const auto any = [&](const std::string& id) {
    return std::any_of(panels.begin(), panels.end(), [&](Index p) { return pattern.panels[p].id == id; });
  };
  if (any(drawn + kMirrored)) return any(drawn);
  for (std::size_t k = 1; k <= panels.size(); ++k) {
    const bool first = k == 1 && alike && any(drawn);
    if (!first && !any(drawn + "_" + std::to_string(k))) return false;
  }
  return true;
}

}  // namespace

void find_layers_by_cloth(const pattern::Pattern& pattern, SeamModel& m) {
  const auto is_inner = [](const pattern::Panel& panel) {
    return panel.fabric == "lining" || panel.fabric == "interlining";
  };
  const std::vector<pattern::Panel>& panels = pattern.panels;
  if (std::all_of(panels.begin(), panels.end(), is_inner)) return;  // a garment of lining is one of its own
  for (std::size_t p = 0; p < panels.size(); ++p) m.words[p].layer = m.words[p].layer || is_inner(panels[p]);
}

void find_second_layers(const pattern::Pattern& pattern, SeamModel& m) {
  using Drawn = std::tuple<std::string, int, long>;  // with edges and girth, mm: no wardrobe's other piece
  std::map<Drawn, std::vector<Index>> drawn;
  for (Index p = 0; p < static_cast<Index>(pattern.panels.size()); ++p)
    drawn[{drawn_name(pattern.panels[p].id), m.lines[p], std::lround(m.girth[p])}].push_back(p);
  for (auto& [piece, copies] : drawn) {
    const std::size_t worn = worn_copies(m, copies.front());
    const PieceWords& words = m.words[copies.front()];
    const bool alike = worn == 1 && (words.face != 0 || is_faced(words)) && mirrors_itself(m, copies.front());
    if (worn == 0 || copies.size() <= worn || !are_copies(pattern, copies, std::get<0>(piece), alike))
      continue;
    const auto order = [&](Index p) {  // of those turned over and of the others the first is worn
      const std::string& id = pattern.panels[p].id;
      return std::tuple(id.size(), id);
    };
    std::sort(copies.begin(), copies.end(), [&](Index a, Index b) { return order(a) < order(b); });
    const bool turned = std::any_of(copies.begin(), copies.end(),
                                    [&](Index p) { return pattern.panels[p].id.ends_with(kMirrored); });
    std::size_t plain = 0, over = 0;
    for (const Index p : copies) {
      const bool mirrored = pattern.panels[p].id.find(kMirrored) != std::string::npos;
      std::size_t& before = mirrored ? over : plain;
      const bool is_worn = turned && worn == 2 ? before == 0 : plain + over < worn;
      ++before;
      m.words[p].layer = m.words[p].layer || !is_worn;
    }
  }
}

std::vector<char> lying_on_others(const pattern::Pattern& pattern) {
  std::vector<char> layers;
  for (const PieceWords& words : make_seam_model(pattern).words) layers.push_back(words.layer);
  return layers;
}

}  // namespace toile::seams
