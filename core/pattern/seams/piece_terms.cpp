#include "core/pattern/seams/piece_terms.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace toile::seams {
namespace {

// Of each language: small letters without accents, "theirs=english", two words where they stand in a row.
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

// "rt" alone is English, and right.
constexpr std::string_view kGerman =
    "kordel=cord;gummi=elastic;gummiband=elastic;gummizug=elastic;vt=front;ht=back;rt mitte=back;rt "
    "seite=back side;vh=front pants;hh=back pants;vorne=front;"
    "vorn=front;hinten=back;rucken=back;links=left;linke=left;linker=left;linkes=left;rechts=right;"
    "rechte=right;rechter=right;rechtes=right;seite=side;seitenteil=side;armel=sleeve;kragen=collar;"
    "kragensteg=collar stand;steg=stand;unterkragen=undercollar;revers=lapel;kapuze=hood;"
    "manschette=cuff;armelbundchen=cuff;beinbundchen=cuff;bund=waistband;gurtel=belt;rock=skirt;"
    "hose=pants;bein=leg;hosenbein=leg;oberteil=bodice;mieder=bodice;rumpf=torso;passe=yoke;"
    "sattel=yoke;blende=band;trager=strap;volant=ruffle;rusche=ruffle;zwickel=gusset;tasche=pocket;"
    "beleg=facing;besatz=facing;besetzen=facing;futter=lining;einlage=interlining;kleid=dress;hemd=shirt;"
    "bluse=blouse;mantel=coat;"
    "jacke=jacket;weste=vest;vorder=front;hinter=back;vordere=front;hintere=back;vorderes=front;"
    "hinteres=back;vm=front;hm=back;mitte vorne=front;mitte hinten=back;vordere mitte=front;"
    "hintere mitte=back;seitlich=side;seitliches=side;oberarmel=topsleeve;unterarmel=undersleeve;"
    "kapuzenmitte=hood;kapuzenseite=hood side;oberkragen=collar;stehkragen=collar;bundchen=rib;"
    "halsbundchen=neckband;ausschnittblende=neckband;halsblende=neckband;halsausschnitt=neck;"
    "ausschnitt=neck;saum=hem;taille=waist;taillenband=waistband;schulterpasse=yoke;huftpasse=yoke;"
    "rockpasse=yoke;untertritt=fly;ubertritt=fly;hosenschlitz=fly;knopfleiste=placket;leiste=placket;"
    "schlitz=placket;schlaufe=loop;gurtelschlaufe=loop;ruckengurt=belt;ot=bodice;ho=pants;ae=sleeve;krg="
    "collar;ta=pocket;knie=patch;untertr=fly;tunnel=facing;patte=flap;klappe=flap;paspel=piping;"
    "schragband=binding;einfassung=binding;bindeband=tie;bindegurtel=belt;latz=bib;schosschen=peplum;"
    "keil=gusset;leggins=leggings;pullover=sweater;sakko=jacket;stufe=tier;"
    "li=left;re=right;halsbund=neckband;armelbund=cuff;beinbund=cuff;saumbund=hem rib;bundstreifen=waistband;"
    "kragenstand=collar stand;armelschlitz=placket;seitenstreifen=side;rockbahn=skirt "
    "panel;teilungsnaht=panel;"
    "stehbund=collar;umlegekragen=collar;bubikragen=collar;schalkragen=collar;rollkragen=collar;"
    "jeans=pants;shorts=pants;"
    "innenbund=facing;innenbeleg=facing;knopfband=placket;"
    "futtersatin=satin;futtertaft=satin;rockbund=waistband;hosenbund=waistband;taillenbund=waistband;"
    "nackenband=tape;nahtband=tape;koperband="
    "tape;kantenband=tape;";

constexpr std::string_view kFrench =
    "bracelet=cuff;parement "
    "manche=cuff;lacet=cord;elastique=elastic;devant=front;dos=back;gauche=left;droit=right;droite=right;"
    "cote=side;bord "
    "cote=rib;"
    "manche=sleeve;col=collar;pied col=collar stand;dessous col=undercollar;capuche=hood;"
    "capuchon=hood;poignet=cuff;ceinture=waistband;jupe=skirt;pantalon=pants;jambe=leg;"
    "corsage=bodice;empiecement=yoke;bretelle=strap;bande encolure=neckband;encolure=neck;bande=band;"
    "soufflet=gusset;poche=pocket;parementure=facing;enforme=facing;doublure=lining;"
    "thermocollant=fusible;chemise=shirt;chemisier=blouse;veste=jacket;manteau=coat;gilet=vest;"
    "avant=front;arriere=back;milieu devant=front;milieu dos=back;gauches=left;droits=right;"
    "petit cote=side;manches=sleeve;dessus manche=topsleeve;dessous manche=undersleeve;dessus=top;"
    "bord cotes=rib;bords cotes=rib;bande cou=neckband;bande col=neckband;bande bas=hem band;"
    "bande ceinture=waistband;bord encolure=neckband;col montant=collar;col chale=collar;bavette=bib;"
    "plastron=bib;culotte=pants;buste=bodice;corps=body;haut=top;basque=peplum;etage=tier;lien=tie;"
    "liens=tie;biais=binding;passepoil=piping;patte boutonnage=placket;patte capucin=placket;"
    "sous patte=fly;rabat=flap;passant=loop;braguette=fly;fond poche=pocket;sac poche=pocket;"
    "parement=facing;entoilage=interlining;renfort=interlining;ourlet=hem;bustier=bodice;hausse=yoke;"
    "triangle=gusset;"
    "contre=facing;demi devant=front;demi dos=back;dvt=front;tombant=collar;tombant col=collar;"
    "bas=bottom;bas jambe=cuff;bas manche=cuff;cou=neck;fente=placket;triplure=interlining;sous "
    "col=undercollar;"
    "garniture=facing;proprete=facing;epaule=shoulder;pont=fly;sous "
    "pont=fly;gousset=gusset;emmanchure=armhole;"
    "jambes=leg;poignets=cuff;bretelles=strap;poches=pocket;cotes=side;capuches=hood;robe=dress;"
    "blouson=jacket;combinaison=overall;"
    "interieur=facing;interieure=facing;ruban=tape;";

constexpr std::string_view kSpanishPortuguese =
    "faixa=band;faixa decote=neckband;faixa cintura=waistband;bajo "
    "cuello=undercollar;superior=top;sup=top;inferior=under;inf=under;manga cima=topsleeve;manga "
    "baixo=undersleeve;cordon=cord;cordao=cord;elastico=elastic;delant=front;post=back;esp=back;espald=back;"
    "tras=back;pret="
    "waistband;mga=sleeve;cllo=collar;bols=pocket;"
    "del izq=left front;del der=right front;del izdo=left front;del dcho=right front;izq=left;izdo=left;"
    "izda=left;der=right;dcho=right;dcha=right;cuart=side;fald=skirt;"
    "delantero=front;delantera=front;frente=front;espalda=back;trasero=back;trasera=back;costas=back;"
    "izquierda=left;izquierdo=left;derecha=right;derecho=right;esquerda=left;esquerdo=left;"
    "direita=right;direito=right;costado=side;lateral=side;manga=sleeve;cuello=collar;gola=collar;"
    "colarinho=collar;capucha=hood;capuz=hood;puno=cuff;punho=cuff;pretina=waistband;"
    "cinturilla=waistband;cos=waistband;falda=skirt;saia=skirt;pantalones=pants;calca=pants;"
    "calcas=pants;pierna=leg;perna=leg;canesu=yoke;tirante=strap;volante=ruffle;bolsillo=pocket;"
    "bolso=pocket;lazo=tie;lazos=tie;lazada=tie;vista=facing;forro=lining;entretela=interlining;vestido="
    "dress;camisa=shirt;"
    "blusa=blouse;chaqueta=jacket;abrigo=coat;chaleco=vest;adelante=front;atras=back;posterior=back;"
    "anterior=front;dianteiro=front;dianteira=front;traseiro=back;traseira=back;tras=back;lado=side;"
    "talle=bodice;corpino=bodice;corpete=bodice;cuello pie=collar stand;pie cuello=collar stand;"
    "pe gola=collar stand;tira cuello=neckband;tira escote=neckband;escote=neck;decote=neck;"
    "banda cuello=neckband;capucho=hood;punos=cuff;punhos=cuff;mangas=sleeve;cintura=waistband;"
    "cinturon=belt;cinto=belt;banda cintura=waistband;elastico cintura=waistband;cueros=yoke;"
    "pala=yoke;hombro=shoulder;tirantes=strap;alca=strap;alcas=strap;peto=bib;peitilho=bib;bajo=hem;"
    "bainha=hem;dobladillo=hem;barra=hem band;resorte=rib;canale=rib;ribana=rib;vuelo=ruffle;"
    "olan=ruffle;babado=ruffle;folho=ruffle;holan=ruffle;tapeta=placket;carcela=placket;aletilla=fly;"
    "bragueta=fly;braguilha=fly;braguilla=fly;pertingal=fly;tapa=flap;cartera=flap;aba=flap;"
    "trabilla=loop;presilla=loop;passante=loop;pasador=loop;ribete=binding;bies=binding;vies=binding;"
    "sesgo=binding;bolsillos=pocket;bolsa=pocket;fondo bolsillo=pocket;falso=facing;vistas=facing;"
    "guarnicion=facing;limpeza=facing;contorno=facing;fusionable=fusible;reforco=interlining;"
    "braga=pants;mallas=leggings;bermuda=pants;remera=tshirt;camiseta=tshirt;franela=tshirt;"
    "playera=tshirt;sudadera=sweatshirt;casaco=jacket;cuchilla=gusset;nesga=godet;godete=godet;"
    "nivel=tier;piernas=leg;pernas=leg;solapa=lapel;lapela=lapel;"
    "pechera=bib;botonadura=placket;costadillo=side;delanteros=front;espaldas=back;vuelta manga=cuff;"
    "centro frente=front;centro costas=back;frentes=front;espelho=facing;debrum=binding;passadeira=loop;"
    "portinhola=flap;fundo bolso=pocket;canesus=yoke;cuellos=collar;fajon=hem band;quimono=dress;"
    "saias=skirt;cos elastico=waistband;cinta cuello=tape;cinta hombro=tape;cinta nuca=tape;fita=tape;";

constexpr std::string_view kItalian =
    "nastro=tape;fettuccia=tape;cordoncino=cord;dav=front;davanti=front;davanto=front;dietro=back;schiena="
    "back;sinistra=left;sinistro="
    "left;destra=right;"
    "destro=right;fianco=side;fianchetto=side;manica=sleeve;collo=collar;colletto=collar;"
    "cappuccio=hood;polso=cuff;polsino=cuff;cinturino=waistband;gonna=skirt;pantalone=pants;"
    "pantaloni=pants;gamba=leg;corpetto=bodice;sprone=yoke;bretella=strap;balza=ruffle;tasca=pocket;"
    "paramontura=facing;fodera=lining;vestito=dress;camicia=shirt;camicetta=blouse;giacca=jacket;"
    "cappotto=coat;avanti=front;dietri=back;posteriore=back;anteriore=front;davantino=bib;"
    "centro davanti=front;centro dietro=back;fianchi=side;laterale=side;maniche=sleeve;"
    "sopra manica=topsleeve;sopramanica=topsleeve;sotto manica=undersleeve;sottomanica=undersleeve;"
    "manica sopra=topsleeve;manica sotto=undersleeve;collo sotto=undercollar;collo "
    "sopra=collar;martingala=belt;"
    "bavero=collar;listino collo=collar stand;listino=placket;pistagna=collar stand;"
    "solino=collar stand;sottocollo=undercollar;rever=lapel;bordo scollo=neckband;"
    "bordino scollo=neckband;fascia collo=neckband;scollo=neck;scollatura=neck;girocollo=neckband;"
    "bordo fondo=hem band;fascia fondo=hem band;fascia vita=waistband;fascione=waistband;fascia=band;"
    "bordo=band;bordo manica=cuff;polsini=cuff;costina=rib;fondo=hem;vita=waist;busto=bodice;"
    "carre=yoke;spallina=strap;spalline=strap;pettorina=bib;bustino=bodice;arriccio=ruffle;"
    "rouche=ruffle;baschina=peplum;passanti=loop;patta=fly;finta=placket;cannolo=placket;"
    "abbottonatura=placket;pattina=flap;aletta=flap;sbieco=binding;profilo=piping;sacco tasca=pocket;"
    "taschino=pocket;fusto tasca=pocket;filetto=welt;ripiego=facing;mostra=facing;adesivo=fusible;"
    "teletta=interlining;gonne=skirt;panta=pants;abito=dress;tubino=dress;maglietta=tshirt;"
    "felpa=sweatshirt;cinta=belt;laccio=tie;tassello=gusset;cuneo=gusset;"
    "contropatta=fly;contro patta=fly;sottopatta=fly;controfinta=fly;mezzo davanti=front;mezzo dietro=back;"
    "polsi=cuff;fascetta=band;fascetta collo=neckband;fascetta polso=cuff;giro collo=neckband;"
    "bordo collo=neckband;bordo polso=cuff;bordo "
    "vita=waistband;telo=panel;fessino=placket;cannoncino=placket;"
    "listello=placket;sacchetto tasca=pocket;sacchetto=pocket;rinforzo=interlining;gambale=leg;"
    "davanti sinistro=left front;davanti destro=right front;"
    "sacco=pocket;interna=facing;interno=facing;interni=facing;";

constexpr std::string_view kDutch =
    "koord=cord;elastiek=elastic;voor=front;voorkant=front;achter=back;achterkant=back;rugpand=back;zijkant="
    "side;zijpand=side;"
    "mouw=sleeve;kraag=collar;manchet=cuff;tailleband=waistband;rok=skirt;broek=pants;pijp=leg;"
    "broekspijp=leg;schouderstuk=yoke;schouderband=strap;zak=pocket;voering=lining;jurk=dress;"
    "overhemd=shirt;jas=coat;voorpand=front;achterpand=back;rug=back;rugstuk=back;borststuk=bib;"
    "borstlap=bib;linkervoorpand=left front;rechtervoorpand=right front;midden voor=front;"
    "midden achter=back;bovenmouw=topsleeve;ondermouw=undersleeve;mouwboord=cuff;mouwmanchet=cuff;"
    "boord=rib;halsboord=neckband;halsbies=neckband;tailleboord=waistband;zoomboord=hem band;"
    "zoom=hem;staander=stand;kraagstandaard=collar stand;bovenkraag=collar;onderkraag=undercollar;"
    "lijfje=bodice;lijf=bodice;heupstuk=yoke;heuppas=yoke;schouderbandje=strap;bandje=strap;"
    "strook=ruffle;gulp=fly;lus=loop;riemlus=loop;riem=belt;ceintuur=belt;klep=flap;"
    "biaisband=binding;knoopsluiting=placket;polo sluiting=placket;tussenvoering=interlining;"
    "vlieseline=interlining;baan=panel;rokbaan=skirt panel;tuinbroek=pants;trui=sweater;spie=gusset;"
    "kruisje=gusset;"
    "rugdeel=back;voordeel=front;achterdeel=back;zakklep=flap;kap=hood;schouderpas=yoke;"
    "mouwen=sleeve;halsboordje=neckband;boordje=rib;bloes=blouse;vest=vest;voorbroek=front pants;"
    "achterbroek=back pants;voorrok=front skirt;achterrok=back skirt;voorlijf=front;achterlijf=back;"
    "voormouw=front sleeve;achtermouw=back sleeve;";

constexpr std::string_view kPolish =
    "przod=front;tyl=back;lewy=left;lewa=left;prawy=right;prawa=right;bok=side;rekaw=sleeve;"
    "kolnierz=collar;stojka=stand;kaptur=hood;mankiet=cuff;pasek=waistband;spodnica=skirt;"
    "spodnie=pants;nogawka=leg;karczek=yoke;kieszen=pocket;podszewka=lining;sukienka=dress;"
    "koszula=shirt;bluzka=blouse;przodu=front;przednia=front;przedni=front;tylu=back;tylna=back;"
    "tylni=back;plecy=back;plecow=back;boczek=side;boczny=side;boczna=side;srodek przodu=front;"
    "srodek tylu=back;rekawa=sleeve;rekawy=sleeve;kolnierza=collar;stan=bodice;gora=bodice;"
    "korpus=body;mankietu=cuff;pas=waistband;paska=waistband;talia=waist;dol=hem;"
    "plisa dekoltu=neckband;plisa szyi=neckband;lamowka dekoltu=neckband;dekolt=neck;dekoltu=neck;"
    "sciagacz=rib;sciagacza=rib;sciagacz dolny=hem rib;spod=lower;spodnica przod=front skirt;"
    "spodnicy=skirt;spodni=pants;legginsy=leggings;ramiaczko=strap;ramiaczka=strap;szelka=strap;"
    "szelki=strap;falbana=ruffle;falbanka=ruffle;baskinka=peplum;odszycie=facing;odszycia=facing;"
    "oblozenie=facing;obszycie=facing;wklad=interlining;flizelina=interlining;klejonka=fusible;"
    "plisa=placket;listwa=placket;patka=flap;klapka=flap;klapa=lapel;rozporek=fly;szlufka=loop;"
    "szlufki=loop;lamowka=binding;kieszeni=pocket;worek=pocket;pasek klin=gusset;klin=gusset;"
    "karczka=yoke;wiazanie=tie;marynarka=jacket;kurtka=jacket;plaszcz=coat;kamizelka=vest;"
    "bluza=sweatshirt;koszulka=tshirt;"
    "przody=front;tyly=back;plecki=back;nogawki=leg;sciagacz rekawa=cuff;sciagacz szyi=neckband;"
    "szyja=neck;szyi=neck;mankiety=cuff;kapturek=hood;kieszonka=pocket;kieszenie=pocket;kolnierzyk=collar;"
    "wstawka=insert;podkroj=neck;tunel=waistband;sciagacze=rib;rekawow=sleeve;spodenki=pants;dresy=pants;"
    "golf=collar;";

// "on", the front, is English too: it is told alone, or by what follows.
constexpr std::string_view kTurkish =
    "onu=front;arka=back;arkasi=back;on beden=front;on etek=front skirt;on pantolon=front pants;"
    "on orta=front;on roba=front yoke;on pat=placket;on kol=front sleeve;on yan=side front;"
    "on pervaz=front facing;on fold=fold;arka beden=back;sol=left;sag=right;yan=side;kol=sleeve;"
    "ust kol=topsleeve;alt kol=undersleeve;yaka=collar;yaka ayagi=collar stand;ayak=stand;"
    "yaka ribana=neckband;yaka bandi=neckband;yaka biyesi=neckband;kapuson=hood;kapsonlu=hood;"
    "manset=cuff;kol ribana=cuff;kol manseti=cuff;paca=leg;paca ribana=cuff;kemer=waistband;"
    "bel kemeri=waistband;bel bandi=waistband;bel ribana=waistband;etek ribana=hem rib;etek=skirt;"
    "pantolon=pants;tayt=leggings;roba=yoke;lastik=rib;aski=strap;firfir=ruffle;volan=ruffle;"
    "cep=pocket;cebi=pocket;cep torbasi=pocket;cep kapagi=flap;kapak=flap;astar=lining;"
    "pervaz=facing;pat=placket;patlet=fly;kopru=loop;kusak=belt;biye=binding;"
    "elbise=dress;gomlek=shirt;ceket=jacket;mont=coat;yelek=vest;kus=gusset;"
    "on sol=left front;on sag=right front;sol on=left front;sag on=right front;on ust=front;on alt=front "
    "skirt;"
    "arka alt=back skirt;kol agzi=cuff;bel=waist;yirtmac=placket;kol yirtmac=placket;ust beden=bodice;"
    "cep torba=pocket;paca lastik=cuff;kol lastik=cuff;bel lastik=waistband;sort=pants;sapka=hood;";

constexpr std::string_view kSwedishDanishNorwegian =
    "framstycke=front;bakstycke=back;framsida=front;forstykke=front;bagstykke=back;rygstykke=back;"
    "framstykke=front;bakstykke=back;forstk=front;ryg=back;vanster=left;hoger=right;venstre=left;"
    "hojre=right;hoyre=right;sida=side;sidestykke=side;sidstycke=side;aerme=sleeve;erme=sleeve;"
    "krage=collar;krave=collar;stakrage=collar;kragstand=stand;huva=hood;hette=hood;haette=hood;"
    "mudd=rib;armmudd=cuff;halsmudd=neckband;halskant=neckband;midjemudd=hem rib;manschett=cuff;"
    "mansjett=cuff;linning=waistband;kjol=skirt;nederdel=skirt;skjort=skirt;byxa=pants;byxor=pants;"
    "bukser=pants;bukse=pants;byxben=leg;besparing=yoke;baerestykke=yoke;ficka=pocket;lomme=pocket;"
    "foder=lining;infodring=facing;belegg=facing;belaegning=facing;axelband=strap;strop=strap;"
    "stropp=strap;volang=ruffle;klanning=dress;kjole=dress;skjorta=shirt;skjorte=shirt;jakke=jacket;"
    "jacka=jacket;kappa=coat;"
    "forside=front;bagside=back;bagdel=back;baksida=back;arm=sleeve;aermer=sleeve;ermer=sleeve;"
    "armar=sleeve;halsband=neckband;halslinning=neckband;halsrib=neckband;halsribb=neckband;halsremsa="
    "neckband;"
    "ribb=rib;ribkant=rib;kantband=binding;skraband=binding;snedremsa=binding;livstykke=bodice;"
    "overdel=bodice;overstykke=bodice;kravestand=collar stand;kragefot=collar stand;fickpase=pocket;"
    "lommepose=pocket;lommeklap=flap;ficklock=flap;gylf=fly;sprund=placket;slids=placket;stolpe=placket;"
    "knappstolpe=placket;kile=gusset;kil=gusset;baelte=belt;balte=belt;belte=belt;skarp=belt;skulderstykke="
    "yoke;"
    "axelstycke=yoke;ok=yoke;luva=hood;nederkant=hem;framkjol=front skirt;bakkjol=back skirt;framliv=front "
    "bodice;"
    "bakliv=back bodice;framarm=front sleeve;bakarm=back sleeve;overarm=topsleeve;framben=front leg;"
    "bakben=back leg;frambyxa=front pants;bakbyxa=back pants;forbuks=front pants;bagbuks=back pants;"
    "forbukse=front pants;bakbukse=back pants;forskjort=front skirt;bakskjort=back skirt;forstykker=front;"
    "bagstykker=back;talje=waist;taljeband=waistband;linning rem=waistband;aermelinning=cuff;manchetter=cuff;"
    "slag=lapel;volanger=ruffle;genser=sweater;troja=sweater;troje=sweater;frakke=coat;"
    "knappsla=placket;knapsla=placket;";

constexpr std::string_view kCzechSlovak =
    "predni=front;predny=front;predne=front;zadni=back;zadny=back;zadne=back;predni dil=front;"
    "zadni dil=back;levy=left;pravy=right;bocni=side;bocny=side;rukav=sleeve;limec=collar;"
    "golier=collar;stojacek=stand;kapuce=hood;kapucna=hood;manzeta=cuff;sukne=skirt;sukna=skirt;"
    "kalhoty=pants;nohavice=pants;sedlo=yoke;kapsa=pocket;vrecko=pocket;podsivka=lining;"
    "podsadka=facing;raminko=strap;naplet=rib;naplet spodni=hem rib;spodni naplet=hem rib;naplet dolni=hem "
    "rib;dolni naplet=hem rib;"
    "saty=dress;kosile=shirt;kosela=shirt;"
    "predek=front;zadek=back;predna=front;zadna=back;predny diel=front;zadny diel=back;leve=left;"
    "leva=left;prave=right;rukavu=sleeve;rukavy=sleeve;limcova stojka=collar stand;golierik=collar;"
    "horni rukav=topsleeve;spodni rukav=undersleeve;pasovy limec=waistband;pasu=waistband;pasova=waistband;"
    "kalhot=pants;nohavica=leg;nohavic=leg;nohavicka=leg;kapsy=pocket;kapsicka=pocket;vacek=pocket;"
    "vrecka=pocket;klopa=lapel;lega=placket;rozparek=fly;sedla=yoke;raminka=strap;ramienko=strap;"
    "ramienka=strap;kanyr=ruffle;lemovka=binding;lemovani=binding;prukrcnik=neck;vystrih=neck;"
    "vyztuha=interlining;vyztuz=interlining;vystuz=interlining;vystuha=interlining;vlozka=interlining;tricko="
    "tshirt;mikina=sweatshirt;"
    "halenka=blouse;bunda=jacket;kabat=coat;vesta=vest;sako=jacket;poutko=loop;putko=loop;opasek=belt;"
    "opasok=belt;naplet krk=neckband;naplet krku=neckband;naplet rukav=cuff;naplet rukavu=cuff;"
    "manzety=cuff;manzetka=cuff;leginy=leggings;tilko=tshirt;sukni=skirt;sukne predni=front skirt;"
    "sukne zadni=back skirt;"
    "lem=band;lem krku=neckband;lem vystrihu=neckband;lem rukavu=cuff;spodni lem=hem rib;dolni lem=hem "
    "rib;krk=neck;"
    "krku=neck;pd=front;zd=back;";

// Russian and Ukrainian, as they are written in Latin letters.
constexpr std::string_view kRussianUkrainian =
    "pered=front;perednya=front;perednyaya=front;peredniy=front;polochka=front;polotschka=front;"
    "spinka=back;zad=back;zadnya=back;zadnyaya=back;zadniy=back;levaya=left;levyy=left;pravaya=right;"
    "pravyy=right;liva=left;prava=right;bochok=side;bokovaya=side;bokovoy=side;rukava=sleeve;"
    "verkhnyaya rukava=topsleeve;nizhnyaya rukava=undersleeve;vorotnik=collar;komir=collar;"
    "stoyka=stand;stiyka=stand;obtachka gorloviny=neckband;beyka gorloviny=neckband;gorlovina=neck;"
    "gorloviny=neck;kapyushon=hood;manzheta=cuff;manzhet=cuff;poyas=waistband;poyasa=waistband;"
    "yubka=skirt;yubki=skirt;spidnytsya=skirt;bryuki=pants;bryuk=pants;shtany=pants;"
    "polovinka bryuk=pants;polovinka=pants;lif=bodice;koketka=yoke;lyamka=strap;bretel=strap;"
    "bretelka=strap;oborka=ruffle;baska=peplum;karman=pocket;karmana=pocket;kyshenya=pocket;"
    "meshkovina=pocket;podkladka=lining;pidkladka=lining;obtachka=facing;podbort=facing;"
    "pidbort=facing;planka=placket;gulfik=fly;otkos=fly;klapan=flap;shlevka=loop;hlyastik=tab;"
    "lastovitsa=gusset;beyka=binding;dublerin=fusible;platye=dress;rubashka=shirt;zhilet=vest;"
    "palto=coat;"
    "polochki=front;spinki=back;lev=left;prav=right;podvyaz=rib;podvyaza=rib;rezinka=rib;niz=hem;"
    "niza=hem;podvyaz niza=hem rib;podvyaz rukava=cuff;podvyaz gorloviny=neckband;podborta=facing;"
    "yarus=tier;karmashek=pocket;listochka=welt;tolstovka=sweatshirt;futbolka=tshirt;pidzhak=jacket;"
    "sarafan=dress;halat=coat;khalat=coat;shorty=pants;kombinezon=overall;polovinka perednyaya=front pants;"
    "polovinka zadnyaya=back pants;perednyaya polovinka=front pants;zadnyaya polovinka=back pants;"
    "perednie=front;zadnie=back;perednee=front;zadnee=back;manzhety=cuff;koketki=yoke;vorotnika=collar;"
    "stoyka vorotnika=collar stand;verkh=top;lif pered=front bodice;lif spinka=back bodice;";

constexpr std::string_view kFinnishHungarianRomanian =
    "etukappale=front;takakappale=back;etu=front;taka=back;vasen=left;oikea=right;sivu=side;"
    "hiha=sleeve;kaulus=collar;huppu=hood;hihansuu=cuff;ranneke=cuff;resori=rib;vyotaro=waistband;"
    "vyotarokaitale=waistband;hame=skirt;housut=pants;lahje=leg;kaarroke=yoke;tasku=pocket;"
    "vuori=lining;olkain=strap;eleje=front;hata=back;hatulja=back;ujja=sleeve;galler=collar;"
    "kapucni=hood;mandzsetta=cuff;derekpant=waistband;szoknya=skirt;nadrag=pants;zseb=pocket;"
    "beles=lining;spate=back;fata=front;maneca=sleeve;guler=collar;gluga=hood;manseta=cuff;"
    "betelie=waistband;fusta=skirt;buzunar=pocket;captuseala=lining;platca=yoke;"
    "bizet=facing;"
    "etukpl=front;takakpl=back;etuosa=front;takaosa=back;keskietu=front;keskitaka=back;etukaarroke=front "
    "yoke;"
    "takakaarroke=back yoke;hihat=sleeve;paallihiha=topsleeve;ylahiha=topsleeve;aluhiha=undersleeve;"
    "alahiha=undersleeve;pystykaulus=collar;kaula=neck;paantie=neck;kaulakaitale=neckband;paantienkaitale="
    "neckband;"
    "paantieresori=neckband;kaularesori=neckband;helma=hem;helmaresori=hem rib;hihanresori=cuff;"
    "hihansuuresori=cuff;hihansuukaitale=cuff;lahkeensuu=cuff;lahkeensuuresori=cuff;resorit=rib;"
    "vyotaronauha=waistband;vyotarokappale=waistband;kaitale=band;vinokaitale=binding;etulahje=front leg;"
    "takalahje=back leg;etuhousu=front pants;takahousu=back pants;etuhelma=front skirt;takahelma=back skirt;"
    "etuhame=front skirt;takahame=back skirt;taskupussi=pocket;taskunkansi=flap;nappilista=placket;"
    "halkio=placket;sepalus=fly;tukikangas=interlining;alavara=facing;sisavara=facing;olkaimet=strap;"
    "vyo=belt;mekko=dress;paita=shirt;takki=jacket;liivi=vest;pusero=blouse;rimpsu=ruffle;kiila=gusset;"
    "miehusta=bodice;ylaosa=bodice;elej=front;elso=front;hatso=back;bal=left;jobb=right;oldal=side;"
    "oldala=side;ujj=sleeve;ujjak=sleeve;felsoujja=topsleeve;alsoujja=undersleeve;alsogaller=undercollar;"
    "gallerallo=collar stand;nyak=neck;nyakpant=neckband;nyakpassze=neckband;passze=rib;kezelo=cuff;"
    "kezeloje=cuff;derek=waist;derekresz=bodice;ov=belt;vallresz=yoke;vallpant=strap;nadragszar=leg;"
    "szoknyaresz=skirt;alj=skirt;zsebfedo=flap;zsebzacsko=pocket;zsebbelso=pocket;csuklya=hood;"
    "fodor=ruffle;ruha=dress;ing=shirt;bluz=blouse;zako=jacket;dzseki=jacket;melleny=vest;slicc=fly;"
    "szegopant=binding;ferdepant=binding;kozbeles=interlining;stanga=left;dreapta=right;stang=left;"
    "drept=right;fete=front;spete=back;maneci=sleeve;stei=collar stand;mansete=cuff;talie=waist;"
    "corsaj=bodice;fuste=skirt;crac=leg;clin=gusset;punga=pocket;dublura=lining;garnitura=facing;"
    "bentita=band;bentita gat=neckband;gat=neck;bretea=strap;bretele=strap;rochie=dress;camasa=shirt;"
    "jacheta=jacket;sacou=jacket;palton=coat;tricou=tshirt;insertie=interlining;intaritura=interlining;"
    "clapa=flap;prohab=fly;fata pantalon=front pants;spate pantalon=back pants;"
    "bujtatas=facing;fele=half;";

constexpr std::string_view kCroatianSerbianSlovene =
    "prednji=front;prednja=front;prednje=front;prednjica=front;straznji=back;straznja=back;straznjica=back;"
    "zadnji=back;zadnja=back;ledja=back;leda=back;lijevi=left;lijeva=left;levi=left;desni=right;desna=right;"
    "rukavi=sleeve;ovratnik=collar;okovratnik=collar;kragna=collar;kapuljaca=hood;kapuca=hood;"
    "orukvica=cuff;pojas=waistband;suknja=skirt;krilo=skirt;hlace=pants;nogavica=leg;dzep=pocket;zep=pocket;"
    "podstava=lining;podloga=lining;naramenica=strap;haljina=dress;obleka=dress;kosulja=shirt;srajca=shirt;"
    "jakna=jacket;kaput=coat;prsluk=vest;render=rib;porub=hem;bok=side;letvica=placket;rasporak=fly;"
    "vratni izrez=neck;rub=hem;";

// Vietnamese, Indonesian and Malay, and Chinese in Latin letters. Words of two letters stand with another.
constexpr std::string_view kEastAsian =
    "than truoc=front;than sau=back;truoc=front;ben trai=left;ben phai=right;tay ao=sleeve;tay lon=topsleeve;"
    "tay nho=undersleeve;mang tay=sleeve;mang lon=topsleeve;mang nho=undersleeve;co ao=collar;la co=collar;"
    "chan co=collar stand;bo co=neckband;vien co=neckband;bo tay=cuff;bo lai=hem rib;bo lung=waistband;"
    "cua tay=cuff;day vien=tape;day vien co=tape;tui nguc=pocket;tui hong=pocket;tui sau=pocket;tui=pocket;"
    "lot tui=pocket;nap tui=flap;mieng tui=flap;coi tui=welt;vai lot=lining;keo "
    "lot=fusible;keo=fusible;"
    "mex=interlining;dung=interlining;nep=placket;nep ao=placket;nep khuy=placket;nep nut=placket;"
    "cau vai=yoke;do vai=yoke;de cup=side;suon=side;chan vay=skirt;vay=skirt;vay truoc=front skirt;"
    "vay sau=back skirt;than quan=leg;quan truoc=front pants;quan sau=back pants;quan=pants;lung "
    "quan=waistband;"
    "cap quan=waistband;day keo=zip;khoa keo=zip;baget=fly;paget=fly;doi=loop;con dia=loop;mu trum=hood;"
    "non ao=hood;beo=ruffle;day ao=strap;quai=strap;that lung=belt;day lung=belt;"
    "depan=front;muka=front;badan depan=front;badan muka=front;belakang=back;badan belakang=back;kiri=left;"
    "kanan=right;lengan=sleeve;kerah=collar;kaki kerah=collar stand;daun kerah=collar;ban lengan=cuff;"
    "ban pinggang=waistband;ban leher=neckband;rib leher=neckband;leher=neck;celana=pants;saku=pocket;"
    "kantong=pocket;kantung=pocket;tutup "
    "saku=flap;furing=lining;vuring=lining;puring=lining;viselin=interlining;"
    "pelapis=lining;lapisan=lining;rompok=binding;bisban=binding;golbi=fly;gulbi=fly;belahan=placket;"
    "bahu=shoulder;pas bahu=yoke;tudung=hood;resleting=zip;ikat pinggang=belt;kemeja=shirt;gaun=dress;"
    "rompi=vest;ploi=pleat;"
    "qianpian=front;qian pian=front;houpian=back;hou pian=back;xiuzi=sleeve;xiupian=sleeve;xiu pian=sleeve;"
    "da xiu=topsleeve;xiao xiu=undersleeve;lingzi=collar;xialing=collar stand;xia ling=collar stand;"
    "xiukou=cuff;xiu kou=cuff;yaotou=waistband;yao tou=waistband;koudai=pocket;maozi=hood;menjin=placket;"
    "men jin=placket;libu=lining;kuzi=pants;qunzi=skirt;guojian=yoke;";

// Greek and Bulgarian as they are written in Latin letters, Lithuanian, Latvian, Estonian, Catalan,
// Icelandic.
constexpr std::string_view kFartherEuropean =
    "empros=front;mprosta=front;mprostino=front;brosta=front;brostino=front;piso=back;pisw=back;plati=back;"
    "aristero=left;aristera=left;dexi=right;dexia=right;manikia=sleeve;maniki=sleeve;giakas=collar;"
    "yiakas=collar;kolaro=collar stand;manseta=cuff;zonari=waistband;zoni=waistband;fousta=skirt;"
    "panteloni=pants;tsepi=pocket;tsepes=pocket;fodra=lining;kanavatso=interlining;patileta=placket;"
    "koukoula=hood;nomitis=yoke;"
    "predna=front;predna chast=front;grab=back;garb=back;zadna chast=back;rakav=sleeve;rakavi=sleeve;"
    "manshet=cuff;kolan=waistband;dzhob=pocket;podplata=lining;podlepka=fusible;kachulka=hood;platka=yoke;"
    "lyavo=left;dyasno=right;"
    "priekis=front;priekine=front;priekines=front;nugara=back;nugarele=back;nugaros=back;uzpakalis=back;"
    "uzpakaline=back;rankove=sleeve;rankoves=sleeve;apykakle=collar;rankogalis=cuff;rankogaliai=cuff;"
    "juosmuo=waistband;juosmens=waistband;sijonas=skirt;sijono=skirt;kelnes=pants;kelniu=pants;kisene=pocket;"
    "pamusalas=lining;kaire=left;desine=right;gobtuvas=hood;"
    "prieksa=front;priekspuse=front;priekseja=front;prieksdala=front;mugura=back;mugurpuse=back;"
    "muguras=back;aizmugure=back;piedurkne=sleeve;piedurknes=sleeve;apkakle=collar;aproce=cuff;josta="
    "waistband;"
    "svarki=skirt;bikses=pants;biksu=pants;kabata=pocket;odere=lining;kreisa=left;"
    "esiosa=front;esitukk=front;esiholm=front;seljaosa=back;seljatukk=back;selg=back;varrukas=sleeve;"
    "varruka=sleeve;krae=collar;mansett=cuff;varvel=waistband;seelik=skirt;seeliku=skirt;puksid=pants;"
    "vooder=lining;kapuuts=hood;vasak=left;parem=right;"
    "davanter=front;davant=front;esquena=back;darrere=back;esquerra=left;dreta=right;maniga=sleeve;"
    "manigues=sleeve;puny=cuff;faldilla=skirt;pantalo=pants;butxaca=pocket;folre=lining;caputxa=hood;"
    "tapeta=placket;"
    "framstykki=front;bakstykki=back;ermi=sleeve;kragi=collar;";

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

/// Of all tables in a row; of terms that more than one language has, the first counts.
std::vector<PieceTerm> terms_in_order() {
  std::vector<PieceTerm> terms;
  for (std::string_view table :
       {kShortened, kGerman, kFrench, kSpanishPortuguese, kItalian, kDutch, kPolish, kTurkish,
        kSwedishDanishNorwegian, kCzechSlovak, kRussianUkrainian, kFinnishHungarianRomanian,
        kCroatianSerbianSlovene, kEastAsian, kFartherEuropean, kTrims}) {
    while (!table.empty()) {
      const std::size_t end = table.find(';'), equals = table.find('=');
      terms.push_back({table.substr(0, equals), table.substr(equals + 1, end - equals - 1)});
      table.remove_prefix(end + 1);
    }
  }
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
