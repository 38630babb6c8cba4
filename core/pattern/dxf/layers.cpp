#include "core/pattern/dxf/layers.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/latin_letters.h"
#include "core/base/names.h"
#include "core/base/text.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

struct RoleWord {
  DxfRole role;
  std::string_view word;
  bool can_be_given;
};

/// What a layer is given says what is drawn there; the other roles only follow from numbers and names.
constexpr std::array<RoleWord, 16> kWords{{{DxfRole::kCut, "cut", true},
                                           {DxfRole::kSew, "sew", true},
                                           {DxfRole::kInternal, "internal", true},
                                           {DxfRole::kCutout, "cutout", true},
                                           {DxfRole::kMirror, "mirror", true},
                                           {DxfRole::kGrain, "grain", true},
                                           {DxfRole::kNotch, "notch", true},
                                           {DxfRole::kDrill, "drill", true},
                                           {DxfRole::kTurn, "turn", true},
                                           {DxfRole::kCurve, "curve", true},
                                           {DxfRole::kIgnored, "ignore", true},
                                           {DxfRole::kGrade, "grade", false},
                                           {DxfRole::kGuide, "guide", false},
                                           {DxfRole::kText, "text", false},
                                           {DxfRole::kRepeat, "repeat", false},
                                           {DxfRole::kOther, "other", false}}};

DxfRole role_of_number(int number) {
  static const std::map<int, DxfRole> kRoles{
      {1, DxfRole::kCut},     {2, DxfRole::kTurn},   {3, DxfRole::kCurve},   {4, DxfRole::kNotch},
      {5, DxfRole::kGrade},   {6, DxfRole::kMirror}, {7, DxfRole::kGrain},   {8, DxfRole::kInternal},
      {9, DxfRole::kGuide},   {10, DxfRole::kGuide}, {11, DxfRole::kCutout}, {13, DxfRole::kDrill},
      {14, DxfRole::kSew},    {15, DxfRole::kText},  {80, DxfRole::kNotch},  {81, DxfRole::kNotch},
      {82, DxfRole::kNotch},  {83, DxfRole::kNotch}, {84, DxfRole::kRepeat}, {85, DxfRole::kRepeat},
      {86, DxfRole::kRepeat}, {87, DxfRole::kRepeat}};
  const auto it = kRoles.find(number);
  return it == kRoles.end() ? DxfRole::kOther : it->second;
}

/// What layers of notches are called where a general program drew the pattern; small letters without accents
/// or spaces, between semicolons.
constexpr std::string_view kNotchWords =
    ";notch;notches;tacca;tacche;tacchette;riscontro;riscontri;knips;knipse;knipsen;knipjes;inkeping;"
    "passzeichen;passermarken;kerbe;kerben;cran;crans;encoche;encoches;repere;reperes;piquete;piquetes;"
    "muesca;muescas;aplomo;aplomos;pique;piques;hak;hack;jack;passmarken;passmarkering;"
    "kohdistusmerkit;hakit;zarez;zarezy;naciecie;naciecia;nastrih;nastrihy;znacka;znacky;rovatka;"
    "illesztojel;crestatura;crestaturi;semn;semne;citlik;citlikler;cit;nadsechka;nadsechki;nasechka;"
    "nasechki;zasecka;zasecke;urez;urezi;takik;";

/// Likewise of grain lines.
constexpr std::string_view kGrainWords =
    ";grain;grainline;grainlines;drittofilo;fadenlauf;fadenlaufe;fadenrichtung;droitfil;hilo;rectohilo;"
    "hilorecto;sentidohilo;sentidodelhilo;fio;fioreto;fiodotecido;sentidodofio;tradriktning;tradretning;"
    "tradlopp;trad;langsuunta;langansuunta;nitka;nitkaprosta;nit;smerniti;smernite;osnova;szalirany;"
    "firdrept;directiefir;iplik;duziplik;boyiplik;dolevaya;dolevayanit;dolevajanit;napravlenieniti;"
    "draadrichting;draad;";

/// The name in small Latin letters, without what parts its words, nor a size before them: "46_NITKA".
std::string plain_name(const std::string& layer) {
  std::string name;
  for (const char c : lower_case(in_latin_letters(layer)))
    if (c != ' ' && c != '_' && c != '-') name += c;
  return name.erase(0, std::min(name.size(), name.find_first_not_of("0123456789")));
}

/// What holds whether a drawing goes by AAMA's layers or not.
std::optional<DxfRole> plain_role(const std::string& layer) {
  const std::string name = plain_name(layer);
  if (is_listed(kNotchWords, name)) return DxfRole::kNotch;
  if (is_listed(kGrainWords, name)) return DxfRole::kGrain;
  return std::nullopt;
}

DxfRole role_of_name(const std::string& layer) {
  static const std::map<std::string, DxfRole> kRoles{{"cut", DxfRole::kCut},
                                                     {"cutline", DxfRole::kCut},
                                                     {"cutting", DxfRole::kCut},
                                                     {"cuttingline", DxfRole::kCut},
                                                     {"boundary", DxfRole::kCut},
                                                     {"outline", DxfRole::kCut},
                                                     {"pieceboundary", DxfRole::kCut},
                                                     {"sew", DxfRole::kSew},
                                                     {"sewline", DxfRole::kSew},
                                                     {"sewing", DxfRole::kSew},
                                                     {"sewingline", DxfRole::kSew},
                                                     {"stitch", DxfRole::kSew},
                                                     {"stitchline", DxfRole::kSew},
                                                     {"seam", DxfRole::kSew},
                                                     {"seamline", DxfRole::kSew},
                                                     {"mirror", DxfRole::kMirror},
                                                     {"mirrorline", DxfRole::kMirror},
                                                     {"fold", DxfRole::kMirror},
                                                     {"foldline", DxfRole::kMirror},
                                                     {"internal", DxfRole::kInternal},
                                                     {"internals", DxfRole::kInternal},
                                                     {"internalline", DxfRole::kInternal},
                                                     {"drill", DxfRole::kDrill},
                                                     {"drillhole", DxfRole::kDrill},
                                                     {"drillholes", DxfRole::kDrill},
                                                     {"cutout", DxfRole::kCutout},
                                                     {"cutouts", DxfRole::kCutout},
                                                     {"text", DxfRole::kText},
                                                     {"annotation", DxfRole::kText}};
  if (const auto plain = plain_role(layer)) return *plain;
  const auto it = kRoles.find(plain_name(layer));
  return it == kRoles.end() ? DxfRole::kOther : it->second;
}

}  // namespace

std::optional<DxfRole> given_role(const std::string& layer, const DxfLayerMap& given) {
  const auto it = given.find(layer);
  return it == given.end() ? std::nullopt : std::optional(it->second);
}

std::optional<DxfRole> told_role(const std::string& layer, double length_mm, const DxfLayerMap& given) {
  constexpr double kLongestNotch = 40;  // mm; longer marks show where pockets lie
  if (const auto role = given_role(layer, given)) return role;
  const auto role = plain_role(layer);
  return role == DxfRole::kNotch && length_mm > kLongestNotch ? std::nullopt : role;
}

std::optional<int> layer_number(const std::string& layer) {
  std::string name = lower_case(layer);
  for (const char* prefix : {"layer", "aama", "astm", "l"}) {
    if (!name.starts_with(prefix)) continue;
    name.erase(0, std::string(prefix).size());
    break;
  }
  const std::size_t begin = name.find_first_not_of(" _-");
  if (begin == std::string::npos) return std::nullopt;
  return number_in<int>(std::string_view(name).substr(begin));
}

DxfRole role_of_layer(const std::string& layer, const DxfLayerMap& given) {
  if (const auto role = given_role(layer, given)) return *role;
  const std::optional<int> number = layer_number(layer);
  return number ? role_of_number(*number) : role_of_name(layer);
}

DxfRole repeated_role(const std::string& layer, const DxfLayerMap& given) {
  if (const auto role = given_role(layer, given)) return *role;
  const int number = layer_number(layer).value_or(0);
  if (number == 84) return DxfRole::kCut;
  if (number == 85) return DxfRole::kInternal;
  if (number == 86) return DxfRole::kCutout;
  if (number == 87) return DxfRole::kSew;
  return role_of_layer(layer);
}

std::string_view role_word(DxfRole role) {
  const auto* known =
      std::find_if(kWords.begin(), kWords.end(), [&](const RoleWord& w) { return w.role == role; });
  return known->word;
}

std::vector<std::string> given_role_words() {
  std::vector<std::string> words;
  for (const RoleWord& known : kWords)
    if (known.can_be_given) words.emplace_back(known.word);
  return words;
}

Result<DxfRole> role_named(const std::string& word) {
  for (const RoleWord& known : kWords)
    if (known.can_be_given && known.word == word) return known.role;
  return Error{"dxf.unknown_role",
               "a layer cannot be read as " + in_quotes(word) + "; " + advice(word, given_role_words()), ""};
}

std::string_view read_as(const DxfLayerUse& layer) {
  return layer.by_shape ? std::string_view("shape") : role_word(layer.role);
}

}  // namespace toile::dxf
