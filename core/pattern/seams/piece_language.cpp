#include "core/pattern/seams/piece_language.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

#include "core/base/text.h"

namespace toile::seams {
namespace {

/// The letters of U+00C0 to U+017F without what is above or below them; '?' is none of ASCII, or two.
constexpr std::string_view kBareLetters =
    "AAAAAA?CEEEEIIII?NOOOOO?OUUUUY??aaaaaa?ceeeeiiii?nooooo?ouuuuy?y"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIi??JjKkkLlLlLlLlLlNnNnNnnNnOoOoOo??RrRrRrSsSsSsSsTtTtTt"
    "UuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(kBareLetters.size() == 0x180 - 0xC0);

/// What a letter of U+00C0 to U+017F is written as without accents.
std::string bare(unsigned letter) {
  switch (letter) {
    case 0xC6:
    case 0xE6:
      return "ae";
    case 0xDF:
      return "ss";
    case 0x152:
    case 0x153:
      return "oe";
    default:
      return std::string(1, kBareLetters[letter - 0xC0]);
  }
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether an article of one letter stands there: "l'encolure", "d'épaule".
bool is_elided(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size() || text[at + 1] != '\'' || (at > 0 && is_letter(text[at - 1]))) return false;
  return text[at] == 'l' || text[at] == 'd' || text[at] == 'L' || text[at] == 'D';
}

/// Whether the byte goes on a letter of UTF-8.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80; }

std::string without_accents(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (is_elided(text, i)) {
      out += ' ';
    } else if (byte >= 0xC3 && byte <= 0xC5 && i + 1 < text.size() && goes_on(text[i + 1])) {
      out += bare((byte & 0x1Fu) << 6 | (static_cast<unsigned char>(text[i + 1]) & 0x3Fu));
      ++i;
    } else {
      out += text[i];
    }
  }
  return out;
}

struct Term {
  std::string_view foreign;  ///< small letters without accents; two words where they stand in a row
  std::string_view english;
};

constexpr Term kTerms[] = {
    // As drafting programs shorten English
    {"pkt", "pocket"},
    {"wbnd", "waistband"},
    {"wband", "waistband"},
    {"clr", "collar"},
    {"fcg", "facing"},
    {"sf", "side front"},
    {"sb", "side back"},
    // German
    {"vt", "front"},
    {"ht", "back"},
    {"rt mitte", "back"},  // alone it is English, and right
    {"rt seite", "back side"},
    {"vh", "front pants"},
    {"hh", "back pants"},
    {"vorne", "front"},
    {"vorn", "front"},
    {"hinten", "back"},
    {"rucken", "back"},
    {"links", "left"},
    {"linke", "left"},
    {"linker", "left"},
    {"linkes", "left"},
    {"rechts", "right"},
    {"rechte", "right"},
    {"rechter", "right"},
    {"rechtes", "right"},
    {"seite", "side"},
    {"seitenteil", "side"},
    {"armel", "sleeve"},
    {"kragen", "collar"},
    {"kragensteg", "collar stand"},
    {"steg", "stand"},
    {"unterkragen", "undercollar"},
    {"revers", "lapel"},
    {"kapuze", "hood"},
    {"manschette", "cuff"},
    {"armelbundchen", "cuff"},
    {"beinbundchen", "cuff"},
    {"bund", "waistband"},
    {"gurtel", "belt"},
    {"rock", "skirt"},
    {"hose", "pants"},
    {"bein", "leg"},
    {"hosenbein", "leg"},
    {"oberteil", "bodice"},
    {"mieder", "bodice"},
    {"rumpf", "torso"},
    {"passe", "yoke"},
    {"sattel", "yoke"},
    {"blende", "band"},
    {"trager", "strap"},
    {"volant", "ruffle"},
    {"rusche", "ruffle"},
    {"zwickel", "gusset"},
    {"tasche", "pocket"},
    {"beleg", "facing"},
    {"futter", "lining"},
    {"einlage", "interlining"},
    {"kleid", "dress"},
    {"hemd", "shirt"},
    {"bluse", "blouse"},
    {"mantel", "coat"},
    {"jacke", "jacket"},
    {"weste", "vest"},
    // French
    {"devant", "front"},
    {"dos", "back"},
    {"gauche", "left"},
    {"droit", "right"},
    {"droite", "right"},
    {"cote", "side"},
    {"bord cote", "rib"},
    {"manche", "sleeve"},
    {"col", "collar"},
    {"pied col", "collar stand"},
    {"dessous col", "undercollar"},
    {"capuche", "hood"},
    {"capuchon", "hood"},
    {"poignet", "cuff"},
    {"ceinture", "waistband"},
    {"jupe", "skirt"},
    {"pantalon", "pants"},
    {"jambe", "leg"},
    {"corsage", "bodice"},
    {"empiecement", "yoke"},
    {"bretelle", "strap"},
    {"bande encolure", "neckband"},
    {"encolure", "neck"},
    {"bande", "band"},
    {"soufflet", "gusset"},
    {"poche", "pocket"},
    {"parementure", "facing"},
    {"enforme", "facing"},
    {"doublure", "lining"},
    {"thermocollant", "fusible"},
    {"chemise", "shirt"},
    {"chemisier", "blouse"},
    {"veste", "jacket"},
    {"manteau", "coat"},
    {"gilet", "vest"},
    // Spanish and Portuguese
    {"delantero", "front"},
    {"delantera", "front"},
    {"frente", "front"},
    {"espalda", "back"},
    {"trasero", "back"},
    {"trasera", "back"},
    {"costas", "back"},
    {"izquierda", "left"},
    {"izquierdo", "left"},
    {"derecha", "right"},
    {"derecho", "right"},
    {"esquerda", "left"},
    {"esquerdo", "left"},
    {"direita", "right"},
    {"direito", "right"},
    {"costado", "side"},
    {"lateral", "side"},
    {"manga", "sleeve"},
    {"cuello", "collar"},
    {"gola", "collar"},
    {"colarinho", "collar"},
    {"capucha", "hood"},
    {"capuz", "hood"},
    {"puno", "cuff"},
    {"punho", "cuff"},
    {"pretina", "waistband"},
    {"cinturilla", "waistband"},
    {"cos", "waistband"},
    {"falda", "skirt"},
    {"saia", "skirt"},
    {"pantalones", "pants"},
    {"calca", "pants"},
    {"calcas", "pants"},
    {"pierna", "leg"},
    {"perna", "leg"},
    {"canesu", "yoke"},
    {"tirante", "strap"},
    {"volante", "ruffle"},
    {"bolsillo", "pocket"},
    {"bolso", "pocket"},
    {"vista", "facing"},
    {"forro", "lining"},
    {"entretela", "interlining"},
    {"vestido", "dress"},
    {"camisa", "shirt"},
    {"blusa", "blouse"},
    {"chaqueta", "jacket"},
    {"abrigo", "coat"},
    {"chaleco", "vest"},
    // Italian
    {"davanti", "front"},
    {"davanto", "front"},
    {"dietro", "back"},
    {"schiena", "back"},
    {"sinistra", "left"},
    {"sinistro", "left"},
    {"destra", "right"},
    {"destro", "right"},
    {"fianco", "side"},
    {"fianchetto", "side"},
    {"manica", "sleeve"},
    {"collo", "collar"},
    {"colletto", "collar"},
    {"cappuccio", "hood"},
    {"polso", "cuff"},
    {"polsino", "cuff"},
    {"cintura", "waistband"},
    {"cinturino", "waistband"},
    {"gonna", "skirt"},
    {"pantalone", "pants"},
    {"pantaloni", "pants"},
    {"gamba", "leg"},
    {"corpetto", "bodice"},
    {"sprone", "yoke"},
    {"bretella", "strap"},
    {"balza", "ruffle"},
    {"tasca", "pocket"},
    {"paramontura", "facing"},
    {"fodera", "lining"},
    {"vestito", "dress"},
    {"camicia", "shirt"},
    {"camicetta", "blouse"},
    {"giacca", "jacket"},
    {"cappotto", "coat"},
    // Dutch
    {"voor", "front"},
    {"voorkant", "front"},
    {"achter", "back"},
    {"achterkant", "back"},
    {"rugpand", "back"},
    {"linker", "left"},
    {"rechter", "right"},
    {"zijkant", "side"},
    {"zijpand", "side"},
    {"mouw", "sleeve"},
    {"kraag", "collar"},
    {"manchet", "cuff"},
    {"tailleband", "waistband"},
    {"rok", "skirt"},
    {"broek", "pants"},
    {"pijp", "leg"},
    {"broekspijp", "leg"},
    {"schouderstuk", "yoke"},
    {"schouderband", "strap"},
    {"zak", "pocket"},
    {"voering", "lining"},
    {"jurk", "dress"},
    {"overhemd", "shirt"},
    {"jas", "coat"},
    // Polish
    {"przod", "front"},
    {"tyl", "back"},
    {"lewy", "left"},
    {"lewa", "left"},
    {"prawy", "right"},
    {"prawa", "right"},
    {"bok", "side"},
    {"rekaw", "sleeve"},
    {"kolnierz", "collar"},
    {"stojka", "stand"},
    {"kaptur", "hood"},
    {"mankiet", "cuff"},
    {"pasek", "waistband"},
    {"spodnica", "skirt"},
    {"spodnie", "pants"},
    {"nogawka", "leg"},
    {"karczek", "yoke"},
    {"kieszen", "pocket"},
    {"podszewka", "lining"},
    {"sukienka", "dress"},
    {"koszula", "shirt"},
    {"bluzka", "blouse"}};

/// Compounds: what a word begins with …
constexpr Term kBeginnings[] = {
    {"vorder", "front"}, {"voor", "front"}, {"rucken", "back"}, {"hinter", "back"}, {"achter", "back"},
    {"seiten", "side"},  {"hals", "neck"},  {"saum", "hem"},    {"bauch", "waist"}, {"taillen", "waist"}};
/// … and ends with.
constexpr Term kEndings[] = {{"armel", "sleeve"},
                             {"kragen", "collar"},
                             {"manschette", "cuff"},
                             {"bundchen", "rib"},
                             {"hosenbund", "waistband"},
                             {"rockbund", "waistband"},
                             {"taillenbund", "waistband"},
                             {"hose", "pants"},
                             {"hosenteil", "pants"},
                             {"rock", "skirt"},
                             {"rockteil", "skirt"},
                             {"passe", "yoke"},
                             {"trager", "strap"},
                             {"tasche", "pocket"},
                             {"taschenbeutel", "pocket"},
                             {"beleg", "facing"},
                             {"futter", "lining"},
                             {"kleid", "dress"},
                             {"hemd", "shirt"},
                             {"bluse", "blouse"},
                             {"mantel", "coat"},
                             {"jacke", "jacket"},
                             {"mouw", "sleeve"},
                             {"kraag", "collar"},
                             {"broek", "pants"}};

constexpr std::string_view kArticles[] = {"de",  "du",  "des", "la",  "le",  "les", "el",    "los", "las",
                                          "del", "der", "die", "das", "dei", "di",  "della", "do",  "da"};

bool is_article(std::string_view word) {
  return std::find(std::begin(kArticles), std::end(kArticles), word) != std::end(kArticles);
}

template <typename Terms>
std::optional<std::string_view> english_of(const Terms& terms, std::string_view word) {
  const auto met =
      std::find_if(std::begin(terms), std::end(terms), [&](const Term& t) { return t.foreign == word; });
  return met == std::end(terms) ? std::nullopt : std::optional(met->english);
}

/// Both parts of a compound; empty where neither is known.
std::string english_parts(std::string_view word) {
  std::string parts;
  for (const Term& t : kBeginnings) {
    if (word.size() <= t.foreign.size() || !word.starts_with(t.foreign)) continue;
    parts = t.english;
    word.remove_prefix(t.foreign.size());
    break;
  }
  if (!parts.empty() && word == "band") return parts + " band";
  const Term* longest = nullptr;
  for (const Term& t : kEndings) {
    if (!word.ends_with(t.foreign)) continue;
    if (longest == nullptr || t.foreign.size() > longest->foreign.size()) longest = &t;
  }
  if (longest != nullptr) parts += (parts.empty() ? "" : " ") + std::string(longest->english);
  return parts;
}

/// Empty where the word is not known.
std::string english_word(std::string_view word) {
  const auto told = english_of(kTerms, word);
  return told ? std::string(*told) : english_parts(word);
}

/// "aermel" as "armel": vowels with two dots are written so where there are none.
std::string without_transcriptions(std::string_view word) {
  std::string out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool dotted =
        i > 0 && word[i] == 'e' && (word[i - 1] == 'a' || word[i - 1] == 'o' || word[i - 1] == 'u');
    if (!dotted) out += word[i];
  }
  return out;
}

}  // namespace

std::vector<std::string> words_of_piece(std::string_view name) {
  std::vector<std::string> words = words_of_name(without_accents(name));
  std::erase_if(words, [](const std::string& w) { return is_article(w); });
  std::string english;
  for (std::size_t k = 0; k < words.size(); ++k) {
    std::string told;
    if (k + 1 < words.size()) told = english_of(kTerms, words[k] + " " + words[k + 1]).value_or("");
    if (!told.empty()) {
      ++k;
    } else {
      told = english_word(words[k]);
      if (told.empty()) told = english_word(without_transcriptions(words[k]));
    }
    english += " " + (told.empty() ? words[k] : told);
  }
  return words_of_name(english);
}

}  // namespace toile::seams
