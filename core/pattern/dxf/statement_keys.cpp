#include "core/pattern/dxf/statement_keys.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "core/base/latin_letters.h"

namespace toile::dxf {
namespace {

/// What one statement is called in other languages, without accents, between semicolons.
struct KeyNames {
  std::string_view english, others;
};

constexpr KeyNames kKeys[] = {
    {"piece name",
     ";teil;teilname;teilename;schnittteil;piece;nom de piece;nom de la piece;nom piece;"
     "pieza;nombre de pieza;nombre de la pieza;peca;nome da peca;pezzo;nome pezzo;"
     "nome del pezzo;deel;patroondeel;naam;nazwa;czesc;dil;nazev dilu;diel;parca;"
     "parca adi;delnamn;part name;"},
    {"size",
     ";groesse;grosse;taille;talla;tamanho;taglia;maat;rozmiar;velikost;velkost;beden;"
     "storlek;storrelse;"},
    {"quantity",
     ";anzahl;stueck;stuck;stueckzahl;stuckzahl;menge;quantite;cantidad;quantidade;"
     "quantita;aantal;ilosc;pocet;kusu;adet;antal;antall;qty;"},
    {"material", ";stoff;tissu;matiere;tela;tejido;tecido;tessuto;stof;tkanina;latka;kumas;tyg;fabric;"},
    {"style name", ";modell;modele;modelo;modello;"},
    {"units",
     ";einheit;einheiten;unite;unites;unidad;unidades;unita;eenheid;eenheden;jednostka;"
     "jednostki;jednotka;jednotky;birim;enhet;enhed;unit;"},
    {"sample size",
     ";mustergroesse;basisgroesse;taille de base;talla base;taglia base;basismaat;"
     "base size;"}};

}  // namespace

std::string english_key(const std::string& key) {
  const std::string wanted = ";" + in_latin_letters(key) + ";";
  const KeyNames* known = std::find_if(std::begin(kKeys), std::end(kKeys), [&](const KeyNames& names) {
    return names.others.find(wanted) != std::string_view::npos;
  });
  return known == std::end(kKeys) ? key : std::string(known->english);
}

}  // namespace toile::dxf
