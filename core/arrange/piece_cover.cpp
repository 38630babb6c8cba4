#include "core/arrange/piece_cover.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::arrange {

namespace {

struct CoverWord {
  Cover cover;
  bool inside;  ///< also as a part of a longer word
  std::string_view text;
};
/// The first that is met counts: a "sleeve cuff" is a cuff, a "trouser waistband" a waistband.
constexpr CoverWord kWords[] = {{Cover::kWaistband, true, "waistband"},
                                {Cover::kWaistband, false, "wb"},
                                {Cover::kWaistband, false, "belt"},
                                {Cover::kCuff, true, "cuff"},
                                {Cover::kCollar, true, "collar"},
                                {Cover::kCollar, true, "neckband"},
                                {Cover::kCollar, true, "turtle"},
                                {Cover::kSleeve, true, "sleeve"},
                                {Cover::kSleeve, false, "slv"},
                                {Cover::kSleeve, false, "arm"},
                                {Cover::kLeg, true, "pant"},
                                {Cover::kLeg, true, "trouser"},
                                {Cover::kLeg, true, "slacks"},
                                {Cover::kLeg, true, "jeans"},
                                {Cover::kLeg, true, "shorts"},
                                {Cover::kLeg, true, "legging"},
                                {Cover::kLeg, true, "jogger"},
                                {Cover::kLeg, true, "culotte"},
                                {Cover::kLeg, false, "tights"},
                                {Cover::kLeg, false, "leg"},
                                {Cover::kSkirt, true, "skirt"},
                                {Cover::kSkirt, false, "gore"},
                                {Cover::kSkirt, true, "godet"},
                                {Cover::kSkirt, true, "ruffle"},
                                {Cover::kSkirt, true, "petticoat"},
                                {Cover::kTorso, true, "hoodie"},
                                {Cover::kTorso, true, "hooded"},
                                {Cover::kHood, true, "hood"},
                                {Cover::kTorso, true, "torso"},
                                {Cover::kTorso, true, "bodice"},
                                {Cover::kTorso, true, "yoke"},
                                {Cover::kTorso, true, "bib"},
                                {Cover::kTorso, true, "shirt"},
                                {Cover::kTorso, true, "blouse"},
                                {Cover::kTorso, true, "jacket"},
                                {Cover::kTorso, true, "coat"},
                                {Cover::kTorso, true, "cardigan"},
                                {Cover::kTorso, true, "sweater"},
                                {Cover::kTorso, true, "tunic"},
                                {Cover::kTorso, true, "kimono"},
                                {Cover::kTorso, true, "poncho"},
                                {Cover::kTorso, false, "cape"},
                                {Cover::kTorso, true, "cloak"},
                                {Cover::kTorso, false, "vest"},
                                {Cover::kTorso, false, "gilet"},
                                {Cover::kTorso, true, "dress"}};

/// Whether a known word stands within a longer one, after `skip` letters.
bool holds_cover(const std::string& word, std::size_t skip) {
  return word.size() > skip && std::any_of(std::begin(kWords), std::end(kWords), [&](const CoverWord& known) {
           return known.inside && word.compare(skip, known.text.size(), known.text) == 0;
         });
}

}  // namespace

const char* name_of(Cover cover) {
  switch (cover) {
    case Cover::kSkirt:
      return "skirt";
    case Cover::kLeg:
      return "leg";
    case Cover::kSleeve:
      return "sleeve";
    case Cover::kWaistband:
      return "waistband";
    case Cover::kCuff:
      return "cuff";
    case Cover::kCollar:
      return "collar";
    case Cover::kHood:
      return "hood";
    default:
      return "torso";
  }
}

Cover cover_of_kind(seams::PieceKind kind) {
  using enum seams::PieceKind;
  switch (kind) {
    case kCollar:
      return Cover::kCollar;
    case kHood:
      return Cover::kHood;
    case kTorso:
      return Cover::kTorso;
    case kBand:
      return Cover::kWaistband;
    case kSkirt:
    case kFrill:
      return Cover::kSkirt;
    case kLegs:
      return Cover::kLeg;
    case kSleeve:
      return Cover::kSleeve;
    case kCuff:
      return Cover::kCuff;
    default:
      return Cover::kUnknown;
  }
}

int face_of_name(const std::string& name) {
  if (const int told = seams::words_of(name).face; told != 0) return told;
  const std::vector<std::string> words = seams::words_of_piece(name);
  if (seams::tell_both_faces(words)) return 0;
  for (const std::string& w : words) {
    if (w.find("front") != std::string::npos) return 1;
    if (w.find("back") != std::string::npos) return -1;
    // "ftorso", and "rbsleeve": a hand's letter before the face's.
    const std::size_t at = (w[0] == 'l' || w[0] == 'r') && w.size() > 1 ? 1 : 0;
    for (const std::size_t k : {std::size_t{0}, at})
      if ((w[k] == 'f' || w[k] == 'b') && holds_cover(w, k + 1)) return w[k] == 'f' ? 1 : -1;
  }
  return 0;
}

Cover cover_of_name(const std::string& name) {
  // Of several words, as "hem band", "neck rib" and "sleeve rib", the last of which is no sleeve.
  const seams::PieceWords told = seams::words_of(name);
  if (told.hem_band) return Cover::kWaistband;
  if (told.kind == seams::PieceKind::kCollar) return Cover::kCollar;
  if (told.kind == seams::PieceKind::kCuff) return Cover::kCuff;
  const std::vector<std::string> words = seams::words_of_piece(name);
  for (const CoverWord& known : kWords) {
    const bool met = std::any_of(words.begin(), words.end(), [&](const std::string& w) {
      return known.inside ? w.find(known.text) != std::string::npos : w == known.text;
    });
    if (met) return known.cover;
  }
  return Cover::kUnknown;
}

}  // namespace toile::arrange
