#include "core/pattern/seams/piece_terms.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "core/pattern/seams/language_terms.h"

namespace toile::seams {
namespace {

// As language_tables(): "theirs=english".
constexpr std::string_view kShortened =
    "waist belt=waistband;pkt=pocket;wbnd=waistband;wband=waistband;clr=collar;fcg=facing;sf=side "
    "front;sb=side back;"
    "wstbnd=waistband;wstband=waistband;wst=waist;lnng=lining;intl=interlining;fus=fusible;"
    "nkb=neckband;cfb=cuff;hmb=hem band;wsb=waistband;clb=collar band;plkt=placket;plk=placket;yk=yoke;ctr "
    "front=front;ctr back=back;nk=neck;nkband=neckband;"
    "nkbd=neckband;strp=strap;gst=gusset;sdft=side front;sdbk=side back;scrotch=gusset;pckt=pocket;"
    "pock=pocket;undslv=undersleeve;topslv=topsleeve;upslv=topsleeve;cuf=cuff;btm=bottom;"
    "bdy=body;bnd=band;bind=binding;bndg=binding;wbf=front waistband;wbb=back waistband;wbl=left waistband;"
    "wbr=right waistband;ln=lining;kpkt=pocket;cpkt=pocket;bpkt=pocket;fpkt=pocket;mche=sleeve;"
    "mang=sleeve;capu=hood;cint=waistband;coll=collar;capp=hood;krag=collar;forr=lining;prz=front;hd=hood;"
    "flp=flap;stm "
    "flap=flap;storm flp=flap;stm flp=flap;tnl=facing;";

// What closes a garment and what small parts lie on it, in many names and few glossaries. A zip tells nothing
// of the piece that has it: "costas ziper" is a back.
constexpr std::string_view kTrims =
    "zipguard=guard;zipshield=guard;beltloop=loop;beltloops=loop;carrier=loop;carriers=loop;keeper=loop;"
    "welts=welt;jet=welt;jets=welt;jetting=welt;tabs=tab;epaulette=tab;epaulet=tab;hanger=loop;"
    "flaps=flap;"
    // German, Dutch
    "reissverschluss=zip;rv beleg=facing;rv untertritt=fly;kinnschutz=facing;windschutz=guard;riegel=tab;"
    "schulterklappe=tab;aufhanger=loop;schlaufen=loop;gurtelschlaufen=loop;eingriff=facing;paspeln=welt;"
    "rits=zip;ritsbeleg=facing;lusje=loop;lusjes=loop;lussen=loop;riemlussen=loop;knoopbies=placket;"
    // French
    "fermeture=zip;glissiere=zip;passants=loop;patte epaule=tab;patte polo=placket;passepoils=welt;"
    "coulisse=facing;plaque=facing;"
    // Spanish, Portuguese
    "cremallera=zip;cierre=zip;guardacierre=guard;tapacierre=guard;botonera=placket;vivo=welt;vivos=welt;"
    "jareta=facing;charretera=tab;trabillas=loop;presillas=loop;carteras=flap;tapas=flap;ziper=zip;"
    "fecho=zip;passadores=loop;passantes=loop;passadeiras=loop;revel=facing;abas=flap;vista fecho=fly;"
    // Italian
    "cerniera=zip;lampo=zip;coprizip=guard;sottozip=guard;paracerniera=guard;filetti=welt;"
    "patelletta=flap;mostre=facing;mostrina=facing;fintino=placket;pattine=flap;alamaro=tab;"
    // Polish, Czech
    "zamek=zip;zamka=zip;oslona=guard;plisa zamka=placket;patki=flap;kieszeniowy=pocket;wypustka=piping;"
    "guma=elastic;gumka=elastic;sznurek=cord;tasma=tape;pagon=tab;krytka=guard;poutka=loop;"
    "vypustka=piping;kapsovina=pocket;legy=placket;patky=flap;zdrhovadlo=zip;"
    // Turkish
    "koprusu=loop;kopruler=loop;fermuar=zip;fermuar pati=fly;fermuar alti=fly;fitil=welt;fleto=welt;"
    "karsilik=facing;karsiligi=facing;torba=pocket;torbasi=pocket;kapagi=flap;apolet=tab;brit=loop;"
    "dugme pati=placket;ilik pati=placket;pati=placket;"
    // Swedish, Danish, Norwegian
    "dragkedja=zip;blixtlas=zip;lynlas=zip;glidelas=zip;hallor=loop;skarphallor=loop;haelder=loop;"
    "baeltestrop=loop;beltestropp=loop;beltehemper=loop;hempe=loop;hemper=loop;passpoal=welt;paspol=welt;"
    "knaphulskant=placket;knappekant=placket;knappestolpe=placket;klaff=flap;lommeklaff=flap;gylp=fly;"
    "glidlasskydd=guard;"
    // Russian
    "molniya=zip;shlevki=loop;listochki=welt;pata=tab;vetrozashchita=guard;"
    // Finnish, Hungarian, Romanian
    "vetoketju=zip;lenkki=loop;vyolenkki=loop;tere=piping;cipzar=zip;ovbujtato=loop;paszpol=piping;"
    "fermoar=zip;gaica=loop;gaici=loop;paspoal=piping;"
    // Croatian, Serbian, Slovene
    "zatvarac=zip;patentni zatvarac=zip;petlja=loop;petlje=loop;lajsna=placket;";

/// Of all tables in a row; of terms that more than one has, the first counts.
std::vector<PieceTerm> terms_in_order() {
  std::vector<PieceTerm> terms;
  const auto add = [&](std::string_view table) {
    while (!table.empty()) {
      const std::size_t end = table.find(';'), equals = table.find('=');
      terms.push_back({table.substr(0, equals), table.substr(equals + 1, end - equals - 1)});
      table.remove_prefix(end + 1);
    }
  };
  add(kShortened);
  for (const std::string_view table : language_tables()) add(table);
  add(kTrims);
  return terms;
}

}  // namespace

std::span<const PieceTerm> all_terms() {
  static const std::vector<PieceTerm> terms = terms_in_order();
  return terms;
}

std::optional<std::string_view> english_of(std::string_view term) {
  static const std::unordered_map<std::string_view, std::string_view> map = [] {
    std::unordered_map<std::string_view, std::string_view> of;
    for (const PieceTerm& t : all_terms()) of.emplace(t.theirs, t.english);
    return of;
  }();
  const auto met = map.find(term);
  return met == map.end() ? std::nullopt : std::optional(met->second);
}

}  // namespace toile::seams
