#include "core/pattern/dxf/told_quantity.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "core/base/latin_letters.h"
#include "core/base/text.h"
#include "core/pattern/dxf/cut_words.h"
#include "core/pattern/dxf/statement_keys.h"

namespace toile::dxf {
namespace {

constexpr int kMostTold = 12;  // of one piece; greater figures are sizes

// Small letters without accents, between semicolons.
constexpr std::string_view kCountWords =
    ";pc;pcs;st;piece;pieces;pce;pces;pieza;piezas;peca;pecas;pezzo;pezzi;pz;stk;stck;stuck;stueck;stuks;"
    "styck;szt;sztuk;sztuki;ks;kusy;kus;adet;kpl;kappaletta;db;darab;buc;bucati;kom;komada;kosa;sht;det;"
    "detali;mal;fois;vez;veces;vezes;volte;keer;krat;raz;razy;times;kez;gange;ganger;";
/// Of these, the words for a single one: "2 PIECE SLEEVE" is a name.
constexpr std::string_view kSingularWords = ";piece;pieza;peca;pezzo;";
constexpr std::string_view kPairWords = ";pair;paire;par;pari;paar;paio;coppia;paru;pereche;cift;";
constexpr std::string_view kManyPairWords = ";pairs;paires;pares;paare;coppie;pary;perechi;";
constexpr std::string_view kFoldWords =
    ";fold;bruch;stoffbruch;pli;pliure;doblez;dobra;piega;ripiegata;stoffplooi;stofvouw;vouw;zgiecie;zgieciu;"
    "zlozeni;prehyb;prehybu;kat;katli;taite;taitteelta;taitteesta;hajtas;hajtasra;hajtasban;pliu;indoitura;"
    "vikning;tygvikning;vikt;dubbelvikt;vik;tygvik;fold;stoffold;sgib;sgibom;presavijen;pregib;";
/// Beside all these, where a text tells of nothing but how often a piece is cut.
constexpr std::string_view kBesideWords =
    ";x;on;the;of;en;vis;mot;tyg;stof;stoff;in;aan;de;het;op;para;bias;biais;schuin;sbieco;schrag;lesie;"
    "im;am;auf;au;aux;al;a;sur;sul;na;so;po;v;do;w;ve;i;and;und;et;y;e;mirrored;mirror;mirr;mir;"
    "gespiegelt;spiegelbildlich;gegengleich;zerkalno;zrcadlove;zrcadlovo;aynali;spegelvand;spegelvant;"
    "speculare;speculari;miroir;espejo;espelhado;gespiegeld;peilikuva;tukrozve;tukorkep;lustrzane;oglinda;"
    "zrcalno;";

/// A row of digits or of letters.
struct Token {
  std::string text;
  int figure = -1;  ///< that it is; -1: letters, or no small whole number
  bool is_figure() const { return figure >= 1 && figure <= kMostTold; }
};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::vector<Token> tokens_of(std::string_view text) {
  const std::string latin = lower_case(in_latin_letters(text));
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < latin.size();) {
    std::size_t end = i + 1;
    if (is_letter_or_digit(latin[i])) {
      while (end < latin.size() && is_letter_or_digit(latin[end]) &&
             is_digit(latin[end]) == is_digit(latin[i]))
        ++end;
      Token& token = tokens.emplace_back(Token{latin.substr(i, end - i)});
      token.figure = number_in<int>(token.text).value_or(-1);
    }
    i = end;
  }
  return tokens;
}

/// Whether the word is what a quantity is called: "QTY 2".
bool is_quantity(const std::string& word) { return english_key(word) == "quantity"; }

/// Whether what follows the first figure says how it is made up: "2 (1x left, 1x right)".
bool is_sum_of_rest(const std::vector<Token>& tokens) {
  if (tokens.size() < 3 || !tokens[0].is_figure() || !tokens[1].is_figure() || tokens[2].text != "x")
    return false;
  int rest = 0;
  for (std::size_t i = 1; i < tokens.size(); ++i) rest += std::max(0, tokens[i].figure);
  return tokens[0].figure == rest;
}

/// The figure that the tokens tell a quantity by; 0 where there is none.
int counted_by(const std::vector<Token>& tokens) {
  if (is_sum_of_rest(tokens)) return tokens[0].figure;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].is_figure()) continue;
    const std::string before = i > 0 ? tokens[i - 1].text : "",
                      after = i + 1 < tokens.size() ? tokens[i + 1].text : "";
    const bool crossed = (i > 1 && before == "x" && tokens[i - 2].figure >= 0) ||
                         (i + 2 < tokens.size() && after == "x" && tokens[i + 2].figure >= 0);
    if (crossed) continue;                // "5 x 5" are lengths
    const int figure = tokens[i].figure;  // "2 (pair)" are two, "2 pairs" four
    if (is_listed(kManyPairWords, after)) return 2 * figure;
    const bool last = i + 2 == tokens.size();  // "2 para forro" are two for a lining
    if (is_listed(kPairWords, after) || (last && after == "para"))
      return figure % 2 == 0 ? figure : 2 * figure;
    if (before == "x" || after == "x" || tells_cutting(before) || is_listed(kCountWords, after) ||
        is_quantity(before))
      return figure;
  }
  return 0;
}

}  // namespace

std::optional<DxfQuantity> told_quantity(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  const auto tells = [&](std::string_view list) {
    return std::any_of(tokens.begin(), tokens.end(), [&](const Token& t) { return is_listed(list, t.text); });
  };
  int count = counted_by(tokens);
  if (count == 0 && !tokens.empty() && is_listed(kPairWords, tokens.back().text)) count = 2;
  if (count == 0) return std::nullopt;
  return DxfQuantity{count, 0, tells(kFoldWords)};
}

bool tells_only_quantity(std::string_view text) {
  if (!told_quantity(text)) return false;
  const std::vector<Token> tokens = tokens_of(text);
  return std::all_of(tokens.begin(), tokens.end(), [](const Token& t) {
    if (t.is_figure() || tells_cutting(t.text) || is_quantity(t.text)) return true;
    for (const std::string_view list : {kCountWords, kPairWords, kManyPairWords, kFoldWords, kBesideWords})
      if (is_listed(list, t.text)) return true;
    return false;
  });
}

bool is_cutting_order(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  return tokens.size() > 1 && tells_cutting(tokens[0].text) && tokens[1].is_figure();
}

bool begins_with_count(std::string_view text) {
  constexpr std::string_view kSizeWords = ";large;l;big;small;s;tall;plus;";  // "2X LARGE"
  const std::vector<Token> tokens = tokens_of(text);
  if (tokens.size() < 2) return false;
  const Token &first = tokens[0], &second = tokens[1];
  const std::string third = tokens.size() > 2 ? tokens[2].text : "";
  const bool more_figures = third == "x" || (tokens.size() > 2 && tokens[2].figure >= 0);
  if (first.text == "x") return second.is_figure() && !more_figures;
  if (!first.is_figure()) return false;
  if (second.text == "x") return !third.empty() && !more_figures && !is_listed(kSizeWords, third);
  return is_listed(kCountWords, second.text) && !is_listed(kSingularWords, second.text);
}

bool is_fold_word(std::string_view word) { return is_listed(kFoldWords, word); }
bool is_beside_word(std::string_view word) { return is_listed(kBesideWords, word); }

}  // namespace toile::dxf
