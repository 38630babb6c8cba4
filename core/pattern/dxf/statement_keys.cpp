#include "core/pattern/dxf/statement_keys.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "core/base/latin_letters.h"
#include "core/base/text.h"

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
     "parca adi;delnamn;part name;detal;nazvanie;nazvanie detali;naimenovanie;naimenovanie detali;"
     "element;dio;naziv;naziv dijela;komad;kos;alkatresz;szabasresz;megnevezes;kappale;osa;osan nimi;"
     "name;nome;nom;nombre;navn;namn;bezeichnung;benennung;onderdeel;isim;nimi;nev;ime;nume;"
     "piesa;reper;denumire;stykke;stykkenavn;del;molde;nome do molde;裁片;裁片名;裁片名称;部件;パーツ名;"},
    {"size",
     ";groesse;grosse;gr;tam;tg;storl;rozm;taille;talla;tamanho;taglia;maat;rozmiar;velikost;velkost;beden;"
     "storlek;storrelse;razmer;rozmir;velicina;meret;koko;marime;masura;尺码;码数;サイズ;"},
    {"quantity",
     ";anzahl;stueck;stuck;stueckzahl;stuckzahl;menge;quantite;cantidad;quantidade;"
     "quantita;qtd;qtde;qta;q.ta;"
     "qte;qt;cant;ctd;anz;stk;szt;aantal;ilosc;pocet;kusu;adet;antal;antall;qty;kolichestvo;kilkist;kol "
     "vo;kolicina;"
     "mennyiseg;darabszam;darab;maara;lukumaara;kpl;cantitate;bucati;数量;件数;裁片数量;枚数;"},
    {"material",
     ";stoff;tissu;matiere;tela;tejido;tecido;tessuto;stof;tkanina;latka;kumas;tyg;fabric;"
     "materijal;materiale;materiaali;kangas;anyag;tesatura;tkan;面料;布料;生地;"},
    {"style name", ";style;modell;modele;modelo;modello;fason;stil;"},
    {"units",
     ";einheit;einheiten;unite;unites;unidad;unidades;unita;eenheid;eenheden;jednostka;"
     "jednostki;jednotka;jednotky;birim;enhet;enhed;unit;"},
    {"sample size",
     ";mustergroesse;basisgroesse;taille de base;talla base;taglia base;basismaat;"
     "base size;"}};

}  // namespace

std::string english_key(const std::string& key) {
  const std::string latin = lower_case(in_latin_letters(key)), wanted = ";" + latin + ";";
  const KeyNames* known = std::find_if(std::begin(kKeys), std::end(kKeys), [&](const KeyNames& names) {
    return names.english == latin || names.others.find(wanted) != std::string_view::npos;
  });
  return known == std::end(kKeys) ? key : std::string(known->english);
}

}  // namespace toile::dxf
