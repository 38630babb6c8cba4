#include "core/project/create/choose_fabrics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "core/pattern/curve.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::create {
namespace {

struct GarmentWord {
  const char* word;
  const char* fabric;
};

/// The first that the name has counts, so that a sweatshirt dress is of fleece and a shirt dress of shirting.
constexpr GarmentWord kGarments[] = {
    {"tshirt", "single-jersey"},
    {"tee", "single-jersey"},
    {"jersey", "single-jersey"},
    {"polo", "interlock"},
    {"hoodie", "sweatshirt-fleece"},
    {"hoody", "sweatshirt-fleece"},
    {"jeans", "denim-10oz"},
    {"leggings", "ponte"},
    {"legging", "ponte"},
    {"yoga", "ponte"},
    {"tights", "ponte"},
    {"leotard", "ponte"},
    {"bodysuit", "ponte"},
    {"swimsuit", "ponte"},
    {"swimwear", "ponte"},
    {"bikini", "ponte"},
    {"rashguard", "ponte"},
    {"underwear", "single-jersey"},
    {"briefs", "single-jersey"},
    {"cardigan", "interlock"},
    {"sweater", "interlock"},
    {"pyjama", "poplin"},
    {"pyjamas", "poplin"},
    {"pajama", "poplin"},
    {"pajamas", "poplin"},
    {"blazer", "wool-suiting"},
    {"suit", "wool-suiting"},
    {"coat", "wool-flannel"},
    {"sweatshirt", "sweatshirt-fleece"},
    {"trousers", "twill"},
    {"trouser", "twill"},
    {"pants", "twill"},
    {"pant", "twill"},
    {"shorts", "twill"},
    {"chinos", "twill"},
    {"shirt", "shirting"},
    {"blouse", "shirting"},
    {"dress", "shirting"},
    {"top", "single-jersey"},
};

/// Words for cloth, without accents, between semicolons; of several in a name the first line counts.
struct MaterialWords {
  std::string_view words;
  const char* fabric;
};

constexpr MaterialWords kMaterials[] = {
    {";rib;ribbing;", "rib"},
    {";interlining;interfacing;fusible;fusing;fuse;", "interlining"},
    {";lining;underlining;pocketing;", "lining"},
    {";lycra;spandex;elastane;elastan;stretch;ponte;romanit;badelycra;", "ponte"},
    {";fleece;molton;molleton;moletom;moletao;dresowka;felpa;sweat;sweatshirt;futter;futer;teplakovina;"
     "collegetrikoo;joggingstoff;",
     "sweatshirt-fleece"},
    {";pique;piquet;pike;interlock;", "interlock"},
    {";jersey;tricot;trikoo;triko;trikot;trika;punto;uplet;dzianina;pletenina;pletivo;kotott;singlejersey;"
     "trikotazh;tricotaje;malha;maglina;knit;meia;",
     "single-jersey"},
    {";denim;jean;jeans;mezclilla;vaquera;dzins;dzinsowa;dzhins;farmer;kot;", "denim-10oz"},
    {";linen;lin;lino;linho;leinen;linnen;linne;linned;hor;len;keten;pellava;", "linen"},
    {";melton;loden;flausch;boiled;", "wool-flannel"},
    {";wool;laine;lana;wolle;wol;ull;uld;villa;yun;welna;vlna;gyapju;sherst;suiting;", "wool-suiting"},
    {";velvet;samt;velours;velluto;terciopelo;veludo;sametti;kadife;aksamit;samet;flojl;sammet;", "velvet"},
    {";chiffon;sifon;gasa;mousseline;szyfon;shifon;", "silk-chiffon"},
    {";organza;", "silk-organza"},
    {";tulle;tyll;tul;tyl;tiul;fatin;", "tulle"},
    {";satin;saten;raso;atlas;satyna;szaten;", "satin"},
    {";silk;soie;seide;seda;seta;silke;silkki;jedwab;hedvabi;selyem;ipek;shelk;zijde;", "silk-charmeuse"},
    {";leather;leder;cuir;cuero;pelle;couro;skind;nahka;skora;kuze;bor;deri;kozha;", "leather"},
    {";poplin;popeline;popelin;popelina;popelini;poplina;", "poplin"},
    {";oxford;", "oxford"},
    {";canvas;segeltuch;", "canvas"},
    {";twill;gabardine;gabardina;gabardin;koper;chino;serge;sarga;kepr;diagonal;", "twill"},
    {";felt;filz;feutre;", "felt"},
};

bool has(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Words of a garment's name; "T-shirt" is one.
std::vector<std::string> garment_words(const std::string& name) {
  std::vector<std::string> words = seams::words_of_piece(name);
  for (std::size_t k = 1; k < words.size(); ++k)
    if (words[k - 1] == "t" && words[k] == "shirt") words[k] = "tshirt";
  return words;
}

/// What garments of such a name are made of; null where the words name none.
const char* fabric_of(const std::vector<std::string>& words) {
  for (const GarmentWord& known : kGarments)
    if (has(words, known.word)) return known.fabric;
  return nullptr;
}

/// `legs`: by their shape, whatever their names are.
bool are_trousers(const std::vector<std::string>& pieces, bool legs) {
  const auto any = [&](seams::PieceKind kind) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const std::string& piece) { return seams::words_of(piece).kind == kind; });
  };
  return (legs || any(seams::PieceKind::kLegs)) && !any(seams::PieceKind::kTorso);
}

bool is_rib(const std::vector<std::string>& words) { return has(words, "rib") || has(words, "ribbing"); }

/// A hood and ribs: of the garments that have both most are sweatshirts.
bool are_of_sweatshirt(const std::vector<std::string>& pieces) {
  bool rib = false, hood = false;
  for (const std::string& piece : pieces) {
    rib = rib || is_rib(seams::words_of_piece(piece));
    hood = hood || seams::words_of(piece).kind == seams::PieceKind::kHood;
  }
  return rib && hood;
}

/// A neckband that no collar is sewn to is a rib: knits have one, since nothing else closes their neck.
bool are_of_a_knit(const std::vector<std::string>& pieces) {
  bool band = false, collar = false;
  for (const std::string& piece : pieces) {
    const seams::PieceWords words = seams::words_of(piece);
    if (words.kind == seams::PieceKind::kCollar) (words.stand ? band : collar) = true;
  }
  return band && !collar;
}

/// How long the narrower of the piece's ends along its grain is, mm.
double narrower_end(const pattern::Panel& panel) {
  constexpr double kFaces = 0.9;
  const Vec2 grain = normalized(panel.grain);
  double ends[2] = {0, 0};
  for (const pattern::PanelEdge& edge : panel.outline.edges) {
    const Vec2 across = edge.curves.back().p3 - edge.curves.front().p0;
    const double faces = dot(normalized(perpendicular(across)), grain);
    if (std::abs(faces) > kFaces) ends[faces > 0] += pattern::arc_length(edge);
  }
  return std::min(ends[0], ends[1]);
}

/// Whether legs end so narrow that no foot goes through: heels measure about 300 mm around, ankles 200 to
/// 250. Such are of a cloth that stretches.
bool are_leggings(const pattern::Pattern& pattern, const std::vector<seams::PieceWords>& words) {
  constexpr double kHeel = 270;  // mm
  double ends = 0;
  for (std::size_t p = 0; p < words.size() && p < pattern.panels.size(); ++p)
    if (words[p].kind == seams::PieceKind::kLegs && !words[p].layer) ends += narrower_end(pattern.panels[p]);
  return ends > 0 && ends < 2 * kHeel;
}

}  // namespace

std::string garment_fabric(const std::string& name, const std::vector<std::string>& pieces, bool legs) {
  if (const char* fabric = fabric_of(garment_words(name))) return fabric;
  if (are_of_sweatshirt(pieces)) return "sweatshirt-fleece";
  if (are_of_a_knit(pieces)) return "single-jersey";
  if (!are_trousers(pieces, legs)) return "shirting";
  // Legs say by their own names what trousers they are: "LEGGING LEG", "JEANS BACK".
  for (const std::string& piece : pieces)
    if (const char* fabric = fabric_of(garment_words(piece))) return fabric;
  return "twill";
}

std::string piece_fabric(const std::string& piece) {
  const std::vector<std::string> words = seams::words_of_piece(piece);
  for (const char* word : {"interlining", "interfacing", "fusing", "fusible"})
    if (has(words, word)) return "interlining";
  if (has(words, "lining") || has(words, "underlining")) return "lining";
  return is_rib(words) ? "rib" : "";
}

std::string material_fabric(const std::string& material) {
  const std::vector<std::string> words = seams::words_of_piece(material);
  for (const MaterialWords& known : kMaterials)
    for (const std::string& word : words)
      if (known.words.find(";" + word + ";") != std::string_view::npos) return known.fabric;
  return "";
}

void choose_fabrics(const pattern::Pattern& pattern, const std::vector<std::string>& materials,
                    project::Project& project) {
  const std::vector<seams::PieceWords> words = seams::garment_words(pattern);
  const bool legs = std::any_of(words.begin(), words.end(), [](const seams::PieceWords& w) {
    return w.guessed && w.kind == seams::PieceKind::kLegs;
  });
  std::vector<std::string> pieces;
  std::map<std::string, int> told;  // pieces cut of each
  for (std::size_t p = 0; p < project.pieces.size(); ++p) {
    project::ProjectPiece& piece = project.pieces[p];
    pieces.push_back(piece.id);
    piece.fabric = piece_fabric(piece.id);
    if (piece.fabric.empty() && p < materials.size()) piece.fabric = material_fabric(materials[p]);
    ++told[piece.fabric];
  }
  // Ribs end a garment, and a lining is none: they are its own cloth where there is no other.
  if (told.size() > 1)
    for (const char* beside : {"rib", "lining", "interlining"}) told.erase(beside);
  const auto most = std::max_element(told.begin(), told.end(),
                                     [](const auto& x, const auto& y) { return x.second < y.second; });
  const bool says = most != told.end() && !most->first.empty();
  const bool tight = legs && are_leggings(pattern, words);
  project.fabric = says ? most->first : tight ? "ponte" : garment_fabric(project.name, pieces, legs);
  for (project::ProjectPiece& piece : project.pieces)
    if (piece.fabric == project.fabric) piece.fabric.clear();
}

}  // namespace toile::create
