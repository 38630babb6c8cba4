#include "core/pattern/dxf/statement_keys.h"

#include <map>
#include <string_view>

#include "core/base/latin_letters.h"

namespace toile::dxf {
namespace {

/// Without accents.
const std::map<std::string_view, std::string_view>& keys() {
  static const std::map<std::string_view, std::string_view> kKeys{// German
                                                                  {"teil", "piece name"},
                                                                  {"teilname", "piece name"},
                                                                  {"teilename", "piece name"},
                                                                  {"schnittteil", "piece name"},
                                                                  {"groesse", "size"},
                                                                  {"grosse", "size"},
                                                                  {"anzahl", "quantity"},
                                                                  {"stueck", "quantity"},
                                                                  {"stuck", "quantity"},
                                                                  {"stueckzahl", "quantity"},
                                                                  {"stuckzahl", "quantity"},
                                                                  {"menge", "quantity"},
                                                                  {"stoff", "material"},
                                                                  {"modell", "style name"},
                                                                  {"einheit", "units"},
                                                                  {"einheiten", "units"},
                                                                  {"mustergroesse", "sample size"},
                                                                  {"basisgroesse", "sample size"},
                                                                  // French
                                                                  {"piece", "piece name"},
                                                                  {"nom de piece", "piece name"},
                                                                  {"nom de la piece", "piece name"},
                                                                  {"nom piece", "piece name"},
                                                                  {"taille", "size"},
                                                                  {"quantite", "quantity"},
                                                                  {"tissu", "material"},
                                                                  {"matiere", "material"},
                                                                  {"modele", "style name"},
                                                                  {"unite", "units"},
                                                                  {"unites", "units"},
                                                                  {"taille de base", "sample size"},
                                                                  // Spanish and Portuguese
                                                                  {"pieza", "piece name"},
                                                                  {"nombre de pieza", "piece name"},
                                                                  {"nombre de la pieza", "piece name"},
                                                                  {"peca", "piece name"},
                                                                  {"nome da peca", "piece name"},
                                                                  {"talla", "size"},
                                                                  {"tamanho", "size"},
                                                                  {"cantidad", "quantity"},
                                                                  {"quantidade", "quantity"},
                                                                  {"tela", "material"},
                                                                  {"tejido", "material"},
                                                                  {"tecido", "material"},
                                                                  {"modelo", "style name"},
                                                                  {"unidad", "units"},
                                                                  {"unidades", "units"},
                                                                  {"talla base", "sample size"},
                                                                  // Italian
                                                                  {"pezzo", "piece name"},
                                                                  {"nome pezzo", "piece name"},
                                                                  {"nome del pezzo", "piece name"},
                                                                  {"taglia", "size"},
                                                                  {"quantita", "quantity"},
                                                                  {"tessuto", "material"},
                                                                  {"modello", "style name"},
                                                                  {"unita", "units"},
                                                                  {"taglia base", "sample size"},
                                                                  // Dutch
                                                                  {"deel", "piece name"},
                                                                  {"patroondeel", "piece name"},
                                                                  {"naam", "piece name"},
                                                                  {"maat", "size"},
                                                                  {"aantal", "quantity"},
                                                                  {"stof", "material"},
                                                                  {"eenheid", "units"},
                                                                  {"eenheden", "units"},
                                                                  {"basismaat", "sample size"},
                                                                  // Polish, Czech, Slovak
                                                                  {"nazwa", "piece name"},
                                                                  {"czesc", "piece name"},
                                                                  {"dil", "piece name"},
                                                                  {"nazev dilu", "piece name"},
                                                                  {"diel", "piece name"},
                                                                  {"rozmiar", "size"},
                                                                  {"velikost", "size"},
                                                                  {"velkost", "size"},
                                                                  {"ilosc", "quantity"},
                                                                  {"pocet", "quantity"},
                                                                  {"kusu", "quantity"},
                                                                  {"tkanina", "material"},
                                                                  {"latka", "material"},
                                                                  {"jednostka", "units"},
                                                                  {"jednostki", "units"},
                                                                  {"jednotka", "units"},
                                                                  {"jednotky", "units"},
                                                                  // Turkish
                                                                  {"parca", "piece name"},
                                                                  {"parca adi", "piece name"},
                                                                  {"beden", "size"},
                                                                  {"adet", "quantity"},
                                                                  {"kumas", "material"},
                                                                  {"birim", "units"},
                                                                  // Swedish, Danish, Norwegian
                                                                  {"delnamn", "piece name"},
                                                                  {"storlek", "size"},
                                                                  {"storrelse", "size"},
                                                                  {"antal", "quantity"},
                                                                  {"antall", "quantity"},
                                                                  {"tyg", "material"},
                                                                  {"enhet", "units"},
                                                                  {"enhed", "units"},
                                                                  // English
                                                                  {"part name", "piece name"},
                                                                  {"qty", "quantity"},
                                                                  {"fabric", "material"},
                                                                  {"unit", "units"},
                                                                  {"base size", "sample size"}};
  return kKeys;
}

}  // namespace

std::string english_key(const std::string& key) {
  const auto known = keys().find(in_latin_letters(key));
  return known == keys().end() ? key : std::string(known->second);
}

}  // namespace toile::dxf
