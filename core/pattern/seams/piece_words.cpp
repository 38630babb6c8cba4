#include "core/pattern/seams/piece_words.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/pattern/pattern.h"
#include "core/pattern/seams/piece_language.h"

namespace toile::seams {
namespace {

constexpr const char* kLegWords[] = {"pant",    "pants",    "trouser", "trousers", "leg",
                                     "legging", "leggings", "tights",  "joggers",  "jogger",
                                     "shorts",  "jeans",    "slacks",  "culottes", "culotte"};

bool is_leg_word(const std::string& w) {
  return std::any_of(std::begin(kLegWords), std::end(kLegWords), [&](const char* leg) { return w == leg; });
}

/// Whether legs are what a name tells of that says this besides: trousers' torso part is theirs.
bool may_be_of_legs(PieceKind kind) {
  using enum PieceKind;
  return kind == kOther || kind == kCollar || kind == kHood || kind == kTorso || kind == kBand ||
         kind == kSkirt;
}

bool is_part_word(const std::string& w) {
  static const char* const kParts[] = {"torso", "bodice", "body", "panel", "skirt",
                                       "pant",  "leg",    "yoke", "sleeve"};
  return std::any_of(std::begin(kParts), std::end(kParts), [&](const char* part) { return w == part; });
}

/// The most telling word counts: a skirt of a cuff is a frill.
PieceKind kind_of(const std::vector<std::string>& words) {
  struct KindWord {
    const char* word;
    PieceKind kind;
  };
  static const KindWord kWords[] = {
      {"collar", PieceKind::kCollar},  {"neckband", PieceKind::kCollar}, {"hood", PieceKind::kHood},
      {"lapel", PieceKind::kCollar},   {"torso", PieceKind::kTorso},     {"ftorso", PieceKind::kTorso},
      {"btorso", PieceKind::kTorso},   {"bodice", PieceKind::kTorso},    {"wb", PieceKind::kBand},
      {"waistband", PieceKind::kBand}, {"skirt", PieceKind::kSkirt},     {"sleeve", PieceKind::kSleeve},
      {"slv", PieceKind::kSleeve},     {"cuff", PieceKind::kCuff},       {"ins", PieceKind::kInsert},
      {"insert", PieceKind::kInsert},  {"gore", PieceKind::kSkirt},      {"godet", PieceKind::kInsert},
      {"gusset", PieceKind::kInsert},  {"bib", PieceKind::kTorso},       {"strap", PieceKind::kStrap},
      {"straps", PieceKind::kStrap},   {"tie", PieceKind::kStrap},       {"ties", PieceKind::kStrap},
      {"belt", PieceKind::kStrap},     {"cord", PieceKind::kStrap},      {"drawstring", PieceKind::kStrap},
      {"tier", PieceKind::kSkirt},     {"peplum", PieceKind::kSkirt}};
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool frill = has("ruffle") || has("flounce") || has("frill");
  if ((has("cuff") && has("skirt")) || (frill && (has("sleeve") || has("cuff")))) return PieceKind::kFrill;
  PieceKind kind = PieceKind::kOther;
  for (const KindWord& known : kWords)
    if (has(known.word)) kind = known.kind;
  if (may_be_of_legs(kind) && std::any_of(words.begin(), words.end(), is_leg_word)) return PieceKind::kLegs;
  if (kind != PieceKind::kOther) return kind;
  const auto any_ends = [&](const char* end) {  // "undersleeve", "overskirt"
    return std::any_of(words.begin(), words.end(), [&](const std::string& w) { return w.ends_with(end); });
  };
  for (const KindWord& known : kWords)
    if (std::strlen(known.word) > 3 && any_ends(known.word)) kind = known.kind;
  if (may_be_of_legs(kind) && (any_ends("pant") || any_ends("pants") || any_ends("trousers")))
    return PieceKind::kLegs;
  return kind;
}

bool holds_in_a_row(const std::vector<std::string>& words, const char* first, const char* second) {
  for (std::size_t k = 1; k < words.size(); ++k)
    if (words[k - 1] == first && words[k] == second) return true;
  return false;
}

/// Whether the word tells of cloth that lies on other cloth, alone or at the end of another word.
bool lies_on_cloth(const std::string& word) {
  static const char* const kAlone[] = {
      "canvas", "welt",   "bag",    "flap",    "stay",  "guard",   "shield", "loop",       "tab", "fly",
      "loops",  "piping", "fusing", "fusible", "patch", "elastic", "cord",   "drawstring", "tape"};
  static const char* const kEnds[] = {"lining",  "facing",      "pocket", "undercollar",
                                      "placket", "zipperguard", "binding"};
  return std::any_of(std::begin(kAlone), std::end(kAlone), [&](const char* w) { return word == w; }) ||
         std::any_of(std::begin(kEnds), std::end(kEnds), [&](const char* w) { return word.ends_with(w); });
}

/// PieceWords::sleeve_part of a sleeve: "topsleeve", "under sleeve".
int part_of_sleeve(const std::vector<std::string>& words) {
  for (const std::string& w : words) {
    if (w.starts_with("top") || w.starts_with("upper")) return 1;
    if (w.starts_with("under") || w.starts_with("lower") || w == "und") return -1;
  }
  return 0;
}

/// Whether a stand is all that is told of, so that it is the neck's and not of buttons.
bool stands_alone(const std::vector<std::string>& words) {
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  return has("stand") && !has("button") && !has("front");
}

/// Whether the words tell of a band along that edge: "hem band", "neck rib", "hemband", or, where what is
/// told more of comes first, "band hem".
bool tells_band(const std::vector<std::string>& words, const std::string& edge) {
  for (const char* band : {"band", "rib", "ribbing"}) {
    if (holds_in_a_row(words, edge.c_str(), band) || holds_in_a_row(words, band, edge.c_str())) return true;
    if (std::find(words.begin(), words.end(), edge + band) != words.end()) return true;
  }
  return false;
}

/// Two letters that names differ by, and which sides they tell: gauche and droite, izquierda, sinistra,
/// esquerda and derecha, destra, direita; lewy and prawy. Two that are called a and b are parts of something.
struct LetterPair {
  char first, second;
  bool sides;
};
constexpr LetterPair kLetterPairs[] = {{'g', 'd', true}, {'i', 'd', true}, {'s', 'd', true},
                                       {'e', 'd', true}, {'l', 'p', true}, {'a', 'b', false}};

/// Gives two pieces what the letters tell that alone their names differ by: sides, where they have none; that
/// b is no back.
void tell_letter_pairs(const pattern::Pattern& pattern, std::vector<PieceWords>& all) {
  std::map<std::string, std::size_t> names;
  for (std::size_t p = 0; p < all.size(); ++p) names.emplace(lower_case(pattern.panels[p].id), p);
  const auto is_letter = [](const std::string& s, std::size_t i) {
    return i < s.size() && std::isalpha(static_cast<unsigned char>(s[i])) != 0;
  };
  for (const auto& [name, p] : names) {
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (!is_letter(name, i) || is_letter(name, i + 1) || (i > 0 && is_letter(name, i - 1))) continue;
      for (const LetterPair& pair : kLetterPairs) {
        std::string other = name;
        other[i] = pair.second;
        const auto met = name[i] == pair.first ? names.find(other) : names.end();
        if (met == names.end()) continue;
        PieceWords &x = all[p], &y = all[met->second];
        if (!pair.sides) y.face = x.face;
        if (!pair.sides || x.side > 0 || y.side != 0) continue;
        x.side = -1;
        y.side = 1;
      }
    }
  }
}

/// Whether the word is all that the name says beside a style's number: "RT", "4711-RT", "rt_mirrored".
bool says_alone(const std::string& name, std::string_view word) {
  std::vector<std::string> words = words_of_name(name);
  std::erase_if(words, [](const std::string& w) {
    return w == "mirrored" || w.find_first_not_of("0123456789") == w.npos;
  });
  return words.size() == 1 && words.front() == word;
}

/// A waistband of what has sleeves, and neither a skirt nor legs, is where the top ends below.
void tell_bands_that_end_tops(std::vector<PieceWords>& all) {
  using enum PieceKind;
  const auto any = [&](PieceKind kind) {
    return std::any_of(all.begin(), all.end(), [&](const PieceWords& words) { return words.kind == kind; });
  };
  if (!any(kSleeve) || any(kSkirt) || any(kLegs)) return;
  for (PieceWords& words : all)
    if (words.kind == kBand) words.hem_band = true;
}

}  // namespace

bool is_tied(const PieceWords& words) {
  return words.kind == PieceKind::kStrap && !words.over_shoulder && !words.layer;
}

bool is_neck(PieceKind kind) { return kind == PieceKind::kCollar || kind == PieceKind::kHood; }

int hangs_from(PieceKind lower, PieceKind upper) {
  using enum PieceKind;
  const auto hangs_anywhere = [](PieceKind k) { return k == kOther || k == kInsert || k == kStrap; };
  if (hangs_anywhere(lower) || hangs_anywhere(upper)) return 0;
  const bool told = ((upper == kCollar || upper == kHood) && lower == kTorso) ||
                    (upper == kTorso && (lower == kBand || lower == kSkirt || lower == kLegs)) ||
                    (upper == kBand && (lower == kSkirt || lower == kLegs)) ||
                    ((upper == kSleeve || upper == kLegs) && lower == kCuff) ||
                    ((upper == kCuff || upper == kSleeve || upper == kLegs) && lower == kFrill) ||
                    (upper == kSkirt && lower == kSkirt);
  return told ? 1 : -1;
}

bool ever_meet(PieceKind a, PieceKind b) {
  using enum PieceKind;
  if (a == kInsert && b == kInsert) return false;  // each is let into a piece, not into another
  if (a == kStrap || b == kStrap) {
    const PieceKind other = a == kStrap ? b : a;
    return other == kOther || other == kTorso || other == kBand || other == kSkirt;
  }
  if (a == kOther || b == kOther || a == b || a == kInsert || b == kInsert) return true;
  const auto either = [&](PieceKind x, PieceKind y) { return (a == x && b == y) || (a == y && b == x); };
  return hangs_from(a, b) == 1 || hangs_from(b, a) == 1 || either(kTorso, kSleeve);
}

PieceWords words_of(const std::string& name) {
  PieceWords words;
  const std::vector<std::string> all = words_of_piece(name);
  words.kind = kind_of(all);
  words.layer = holds_in_a_row(all, "chest", "piece") || holds_in_a_row(all, "under", "collar") ||
                holds_in_a_row(all, "collar", "under");
  const bool neckband = tells_band(all, "neck") || tells_band(all, "collar");
  if (neckband) words.kind = PieceKind::kCollar;
  words.stand = neckband;
  if (tells_band(all, "sleeve") || tells_band(all, "leg")) words.kind = PieceKind::kCuff;
  words.hem_band = tells_band(all, "hem") || tells_band(all, "bottom") || tells_band(all, "waist");
  if (words.hem_band && words.kind == PieceKind::kBand)
    words.hem_band = false;  // "waistband" is what it says
  words.leg = words.kind == PieceKind::kLegs;
  if (words.kind == PieceKind::kOther && stands_alone(all)) words.kind = PieceKind::kCollar;
  for (const std::string& w : all) {
    const auto is = [&](std::initializer_list<const char*> any) {
      return std::any_of(any.begin(), any.end(), [&](const char* x) { return w == x; });
    };
    // "backpanel", "ftorso": written as one
    const auto starts = [&](const char* start, char letter) {
      return w.starts_with(start) || (w[0] == letter && is_part_word(w.substr(1)));
    };
    if (is({"l", "lf", "lt", "lft", "lh"}) || starts("left", 'l')) words.side = -1;
    if (is({"r", "rt", "rgt", "rh"}) || starts("right", 'r')) words.side = 1;
    if (is({"f", "fr", "frt", "fnt", "ft", "cf"}) || starts("front", 'f')) words.face = 1;
    if (is({"bib", "apron"}) && words.face == 0) words.face = 1;  // but for a "back bib"
    if (w == "bib") words.bib = true;
    if (is({"b", "bk", "bck", "rear", "cb"}) || starts("back", 'b')) words.face = -1;
    if (is_leg_word(w)) words.leg = true;
    if (w == "yoke") words.yoke = true;
    if (w == "belt") words.belt = words.kind == PieceKind::kStrap;
    if (is({"strap", "straps"})) words.over_shoulder = words.kind == PieceKind::kStrap;
    if (is({"side", "sidepanel", "flank"})) words.flank = words.kind != PieceKind::kHood;
    if (is({"stand", "neckband"}) && words.kind == PieceKind::kCollar) words.stand = true;
    if (lies_on_cloth(w)) words.layer = true;
    if (is({"slv", "sl", "arm"}) || w.ends_with("sleeve") || w.ends_with("cuff")) words.limb = true;
  }
  if (words.kind == PieceKind::kSleeve) words.sleeve_part = part_of_sleeve(all);
  if (tell_both_faces(all)) words.face = 0;
  // A "front band" goes up along the front and around the neck.
  if (words.kind == PieceKind::kOther && std::find(all.begin(), all.end(), "band") != all.end())
    words.face = 0;
  return words;
}

std::vector<PieceWords> words_of_garment(const pattern::Pattern& pattern) {
  constexpr std::size_t kGarment = 3;  // pieces
  const bool german = std::any_of(pattern.panels.begin(), pattern.panels.end(),
                                  [](const pattern::Panel& panel) { return says_alone(panel.id, "vt"); });
  std::vector<PieceWords> all;
  all.reserve(pattern.panels.size());
  for (const pattern::Panel& panel : pattern.panels) {
    PieceWords& words = all.emplace_back(words_of(panel.id));
    if (!german || !says_alone(panel.id, "rt")) continue;
    words.face = -1;
    words.side = 0;
  }
  const bool common = std::all_of(all.begin(), all.end(),
                                  [&](const PieceWords& words) { return words.side == all.front().side; });
  if (common && all.size() >= kGarment)
    for (PieceWords& words : all) words.side = 0;
  tell_letter_pairs(pattern, all);
  tell_bands_that_end_tops(all);
  for (std::size_t p = 0; p < all.size(); ++p)
    if (lower_case(pattern.panels[p].id).find("_mirrored") != std::string::npos) all[p].side = -all[p].side;
  return all;
}

}  // namespace toile::seams
