#include "core/pattern/dxf/cut_words.h"

#include <cstddef>
#include <string>

namespace toile::dxf {
namespace {

// Small letters without accents, between semicolons.
constexpr std::string_view kCutWords =
    ";cut;couper;coupez;coupe;cortar;corte;cortes;tagliare;tagliate;schneiden;zuschneiden;zuschnitt;"
    "knippen;knip;klipp;klippe;klippes;klip;kroic;wyciac;krojit;strihat;strihej;strih;leikkaa;kes;kesilecek;"
    "kesim;taie;croit;croieste;szabni;vagni;kiszabni;rezati;kroj;krojiti;kroit;vykroit;";

}  // namespace

bool tells_cutting(std::string_view word) {
  constexpr std::size_t kLeast = 4;  // letters
  const std::string start = ";" + std::string(word);
  return kCutWords.find(start + ";") != std::string_view::npos ||
         (word.size() >= kLeast && kCutWords.find(start) != std::string_view::npos);
}

}  // namespace toile::dxf
