#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/pattern/seams/parts_of_words.h"
#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/word_stems.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using Words = std::vector<std::string>;
using seams::PieceKind;
using seams::words_of_piece;

TEST(PieceLanguage, EnglishNamesStayWhatTheyAre) {
  EXPECT_EQ(words_of_piece("leftSleeve-2"), (Words{"left", "sleeve"}));
  EXPECT_EQ(words_of_piece("TOP COLLAR"), (Words{"top", "collar"}));
  EXPECT_EQ(words_of_piece("backpanel"), (Words{"backpanel"}));
  EXPECT_TRUE(words_of_piece("").empty());
}

TEST(PieceLanguage, PartsOfCompoundsTellPieceAndFace) {
  EXPECT_EQ(words_of_piece("ROCKVORDERTEIL"), (Words{"skirt", "front"}));
  EXPECT_EQ(words_of_piece("Rokachterpand"), (Words{"skirt", "back"}));
  EXPECT_EQ(words_of_piece("Bakficka"), (Words{"back", "pocket"}));
  EXPECT_EQ(words_of_piece("Rockbund"), (Words{"waistband"}));
  EXPECT_EQ(words_of_piece("Futtersatin"), (Words{"satin"})) << "a cloth, and no lining";
}

/// What the pieces of a garment say, of which three have these names.
seams::PieceWords last_of(const char* first, const char* second, const char* last) {
  pattern::Pattern pattern;
  for (const char* name : {first, second, last})
    pattern.panels.push_back(garments::piece(name, {{0, 0}, {100, 0}, {100, 200}, {0, 200}}));
  return seams::words_of_garment(pattern).back();
}

TEST(PieceLanguage, OnePieceForFrontAndBackHasNoFace) {
  EXPECT_EQ(seams::words_of("SKIRT FRONT / BACK").face, 0);
  EXPECT_EQ(seams::words_of("Vorder- und R\u00fcckenteil").face, 0);
  EXPECT_EQ(seams::words_of("front panel").face, 1);
}

TEST(PieceLanguage, RtIsABackBesideVtWhateverTheStyleIs) {
  EXPECT_EQ(last_of("4711-VT", "4711-\u00c4RMEL", "4711-RT").face, -1);
  EXPECT_EQ(last_of("VT", "AERMEL", "RT").face, -1);
  EXPECT_EQ(last_of("front", "AERMEL", "RT").side, 1);
  EXPECT_TRUE(last_of("VT", "RT", "NACKENBAND").layer) << "a tape";
}

TEST(PieceLanguage, AccentsAndTheirTranscriptionsAreOne) {
  for (const char* name : {"\u00c4rmel", "Aermel", "AERMEL", "\u00e4rmel_2"})
    EXPECT_EQ(words_of_piece(name), (Words{"sleeve"})) << name;
  EXPECT_EQ(words_of_piece("R\u00fcckenteil").front(), "back");
  EXPECT_EQ(words_of_piece("Rueckenteil"), words_of_piece("R\u00fcckenteil"));
  EXPECT_EQ(words_of_piece("BEINBUENDCHEN"), (Words{"cuff"}));
  EXPECT_EQ(words_of_piece("pu\u00f1o derecho"), (Words{"cuff", "right"}));
  EXPECT_EQ(words_of_piece("ko\u0142nierz"), (Words{"collar"}));
  EXPECT_EQ(words_of_piece("prz\u00f3d lewy"), (Words{"front", "left"}));
}

TEST(PieceLanguage, ArticlesAreLeftOutAndRowsAreOneTerm) {
  EXPECT_EQ(words_of_piece("pied de col"), (Words{"collar", "stand"}));
  EXPECT_EQ(words_of_piece("bande d'encolure"), (Words{"neckband"}));
  EXPECT_EQ(words_of_piece("bord-c\u00f4te"), (Words{"rib"}));
  EXPECT_EQ(words_of_piece("manga de la camisa"), (Words{"sleeve", "shirt"}));
}

TEST(PieceLanguage, CompoundsAreTakenApart) {
  EXPECT_EQ(words_of_piece("Vorderhose"), (Words{"front", "pants"}));
  EXPECT_EQ(words_of_piece("Hinter\u00e4rmel"), (Words{"back", "sleeve"}));
  EXPECT_EQ(words_of_piece("Saumb\u00fcndchen"), (Words{"hem", "rib"}));
  EXPECT_EQ(words_of_piece("Hosenbund"), (Words{"waistband"}));
  EXPECT_EQ(words_of_piece("achterpand"), (Words{"back"}));
  EXPECT_EQ(words_of_piece("voorband"), (Words{"front", "band"}));
  EXPECT_EQ(words_of_piece("waistband blue"), (Words{"waistband", "blue"}));
}

TEST(PieceLanguage, WhatIsToldInOtherWordsIsUnderstood) {
  EXPECT_EQ(seams::words_of("Vorderteil links").face, 1);
  EXPECT_EQ(seams::words_of("Vorderteil links").side, -1);
  EXPECT_EQ(seams::words_of("dos").face, -1);
  EXPECT_EQ(seams::words_of("Halsb\u00fcndchen").kind, PieceKind::kCollar);
  EXPECT_TRUE(seams::words_of("Saumb\u00fcndchen").hem_band);
  EXPECT_EQ(seams::words_of("manica destra").kind, PieceKind::kSleeve);
  EXPECT_TRUE(seams::words_of("manica destra").limb);
  EXPECT_EQ(seams::words_of("Pretina").kind, PieceKind::kBand);
  EXPECT_TRUE(seams::words_of("Taschenbeutel").layer);
  EXPECT_EQ(seams::words_of("nogawka").kind, PieceKind::kLegs);
}

TEST(PieceLanguage, WhatDraftingProgramsShortenIsUnderstood) {
  EXPECT_TRUE(seams::words_of("KANGAROO PKT").layer);
  EXPECT_EQ(seams::words_of("WBND").kind, PieceKind::kBand);
  EXPECT_EQ(seams::words_of("VT Mitte").face, 1);
  EXPECT_EQ(seams::words_of("RT Mitte").face, -1);
  EXPECT_EQ(seams::words_of("RT Mitte").side, 0);
  EXPECT_TRUE(seams::words_of("RT Seite").flank);
  EXPECT_EQ(seams::words_of("SLV RT").side, 1) << "right, in English";
  EXPECT_EQ(seams::words_of("HH").kind, PieceKind::kLegs);
  EXPECT_EQ(seams::words_of("TIER 2").kind, PieceKind::kSkirt);
}

TEST(PieceLanguage, WordsWithoutTheirVowelsAndBeginningsOfWordsAreSpelledOut) {
  for (const auto& [name, word] :
       std::initializer_list<std::pair<const char*, const char*>>{{"PARMT", "facing"},
                                                                  {"crsg", "bodice"},
                                                                  {"Kapz", "hood"},
                                                                  {"ESPAL", "back"},
                                                                  {"Voorp", "front"},
                                                                  {"wstb", "waistband"},
                                                                  {"Bdc", "bodice"},
                                                                  {"poign", "cuff"}})
    EXPECT_EQ(words_of_piece(name), Words{word}) << name;
  EXPECT_EQ(words_of_piece("DEVT ENCOL"), (Words{"front", "neck"}));
}

TEST(PieceLanguage, WhatMayShortenSeveralTermsOrNoneStaysAsItIs) {
  for (const char* name :
       {"mnc", "gurt", "slp", "the", "lin", "int", "cord", "coton", "denim", "centre", "xl"})
    EXPECT_EQ(words_of_piece(name), Words{name});
}

TEST(PieceLanguage, PartCodesBehindAStylesNumberAreSpelledOut) {
  EXPECT_EQ(words_of_piece("4417-FP_mirrored"), (Words{"front", "panel", "mirrored"}));
  EXPECT_EQ(words_of_piece("K6114-BFC"), (Words{"back", "facing"}));
  EXPECT_EQ(words_of_piece("PD3107-03-CB"), (Words{"center", "back"}));
  for (const char* layer : {"4417-PBG", "K6114-FFCI", "QZ3380-ZGD", "4417-BPK_2", "4417-FLS"})
    EXPECT_TRUE(seams::words_of(layer).layer) << layer;
  EXPECT_TRUE(seams::words_of("QZ3380-SPN").flank);
  EXPECT_TRUE(seams::words_of("4417-YK L").yoke);
  // Not without such a number, nor beside other words, nor where no code is known.
  EXPECT_EQ(words_of_piece("FP"), (Words{"fp"}));
  EXPECT_EQ(words_of_piece("FP 12"), (Words{"fp"}));
  EXPECT_EQ(words_of_piece("4417-BS DEVANT"), (Words{"bs", "front"}));
  EXPECT_EQ(words_of_piece("4417-XQ"), (Words{"xq"}));
}

TEST(PieceLanguage, LeftHandsCordsAndElasticsAreKnown) {
  EXPECT_EQ(seams::words_of("0417-FRT LH").side, -1);
  EXPECT_EQ(seams::words_of("0417-FRT RH").side, 1);
  for (const char* layer : {"CORDON", "Kordel", "drawstring", "ELASTICO 40MM", "Gummiband"})
    EXPECT_TRUE(seams::words_of(layer).layer) << layer;
}

TEST(PieceLanguage, FrontsAndBacksAreKnownInManyLanguages) {
  for (const char* front : {"PRET DEL", "Delantero", "Voorpijp", "prz\u00f3d", "\u00d6N", "\u00d6n beden",
                            "framstycke", "p\u0159edn\u00ed d\u00edl", "\u041f\u0435\u0440\u0435\u0434",
                            "etukappale", "\u524d\u7247", "\u524d\u8eab\u9803"})
    EXPECT_EQ(seams::words_of(front).face, 1) << front;
  for (const char* back : {"POST", "Rugstuk", "ty\u0142", "arka", "bakstycke", "zadn\u00ed d\u00edl",
                           "\u0421\u043f\u0438\u043d\u043a\u0430", "\u540e\u7247"})
    EXPECT_EQ(seams::words_of(back).face, -1) << back;
  EXPECT_EQ(seams::words_of("CHQ5520 DEL_mirrored").face, 1) << "of the copy as well";
  EXPECT_EQ(seams::words_of("PL220_DIE_mirrored").face, -1);
  EXPECT_EQ(seams::words_of("cut on fold").face, 0) << "of English, no front of Turkish";
  EXPECT_EQ(seams::words_of("cuello del vestido").face, 0) << "an article";
}

TEST(PieceLanguage, KindsAreKnownInManyLanguages) {
  for (const char* band : {"PRET POST", "Kemer", "\u8170\u5934", "linning", "\u043f\u043e\u044f\u0441"})
    EXPECT_EQ(seams::words_of(band).kind, PieceKind::kBand) << band;
  for (const char* sleeve : {"kol", "\u00e6rme", "\u0440\u0443\u043a\u0430\u0432", "\u8896", "hiha"})
    EXPECT_EQ(seams::words_of(sleeve).kind, PieceKind::kSleeve) << sleeve;
  for (const char* neck : {"BORDO SCOLLO", "yaka", "limec", "\u9886\u5b50", "RIB NECK"})
    EXPECT_EQ(seams::words_of(neck).kind, PieceKind::kCollar) << neck;
  for (const char* layer :
       {"borstzak", "Zakvoering", "Riemlus", "cep", "kiesze\u0144", "\u53e3\u888b", "ARM BIND"})
    EXPECT_TRUE(seams::words_of(layer).layer) << layer;
  EXPECT_TRUE(seams::words_of("RIB HEM").hem_band);
  EXPECT_TRUE(seams::words_of("barra").hem_band);
  EXPECT_TRUE(seams::words_of("Schouderband").over_shoulder);
  EXPECT_FALSE(seams::words_of("ceintuur").over_shoulder) << "a belt";
  EXPECT_TRUE(seams::words_of("spodnie ty\u0142").leg);
}

TEST(PieceLanguage, NoSignHidesALongerOne) {
  for (const seams::PieceTerm& sign : seams::sign_terms()) {
    EXPECT_FALSE(sign.english.empty());
    // A shorter sign before a longer one that holds it would hide it.
    for (const seams::PieceTerm& later : seams::sign_terms()) {
      if (&later <= &sign) continue;
      EXPECT_EQ(later.theirs.find(sign.theirs), std::string_view::npos) << later.theirs;
    }
  }
}

TEST(PieceLanguage, BytesThatAreNoTextDoNoHarm) {
  EXPECT_EQ(words_of_piece("\xd0"), Words{});

  EXPECT_EQ(words_of_piece("\xc3"), Words{});
  EXPECT_EQ(words_of_piece("\xff\xc5sleeve\xc3\x28"), (Words{"sleeve"}));
}

std::vector<seams::PieceWords> words_of_names(const std::vector<std::string>& names) {
  pattern::Pattern pattern;
  for (const std::string& name : names) pattern.panels.push_back(garments::strip(name, 100, 50));
  return seams::words_of_garment(pattern);
}

TEST(PieceLanguage, LettersThatAloneTellTwoPiecesApartAreSides) {
  for (const char* letters : {"GD", "ID", "SD", "ED", "LP"}) {
    const auto words =
        words_of_names({"Devant", std::string("Manche_") + letters[0], std::string("Manche_") + letters[1]});
    EXPECT_EQ(words[1].side, -1) << letters;
    EXPECT_EQ(words[2].side, 1) << letters;
  }
  EXPECT_EQ(words_of_names({"Devant", "Dos", "Manche_D"})[2].side, 0) << "no other";
}

TEST(PieceLanguage, ABesideAAreTwoParts) {
  EXPECT_EQ(words_of_names({"2301A", "2301B"})[1].face, 0);
  EXPECT_EQ(words_of_names({"2301F", "2301B"})[1].face, -1);
}

TEST(PieceLanguage, TheMirrorImageOfALeftPieceIsARightOne) {
  const auto words = words_of_names({"Front left", "Front left_mirrored", "Back"});
  EXPECT_EQ(words[0].side, -1);
  EXPECT_EQ(words[1].side, 1);
}

TEST(PieceLanguage, RibsAndFrillsOfSleevesEndThem) {
  EXPECT_EQ(seams::words_of("Mudd \u00e4rm 2x").kind, PieceKind::kCuff);
  EXPECT_EQ(seams::words_of("bord c\u00f4te manche").kind, PieceKind::kCuff);
  EXPECT_EQ(seams::words_of("ujja fodor").kind, PieceKind::kFrill);
  EXPECT_TRUE(seams::words_of("BORD COTE COL").stand) << "a neckband";
}

TEST(PieceLanguage, MoreLanguagesAreUnderstood) {
  EXPECT_EQ(words_of_piece("prednji dio"), (Words{"front", "dio"}));
  EXPECT_EQ(words_of_piece("p\u0159edn\u00ed d\u00edl"), (Words{"front"}));
  EXPECT_EQ(words_of_piece("bretea st\u00e2ng\u0103"), (Words{"strap", "left"}));
  EXPECT_EQ(words_of_piece("\u021aes\u0103tur\u0103").front(), "tesatura");
  EXPECT_TRUE(seams::words_of("contropatta").layer);
  EXPECT_TRUE(seams::words_of("vy\u00f6t\u00e4r\u00f6").kind == PieceKind::kBand);
}

TEST(PieceLanguage, AWordInAFormThatNoTableHasIsToldByItsStem) {
  EXPECT_EQ(seams::english_by_stem("kapsou"), std::nullopt) << "less than five letters in common";
  EXPECT_EQ(seams::english_by_stem("rukavem"), "sleeve");
  EXPECT_EQ(seams::english_by_stem("delanteras"), "front");
  EXPECT_EQ(words_of_piece("Predniho"), (Words{"front"}));
  EXPECT_EQ(words_of_piece("centre"), (Words{"centre"})) << "a word that names have besides";
}

TEST(PieceLanguage, FartherLanguagesTellFrontBackAndSleeve) {
  EXPECT_EQ(words_of_piece("THAN TRUOC"), (Words{"front"}));
  EXPECT_EQ(words_of_piece("Th\u00e2n sau"), (Words{"back"}));
  EXPECT_EQ(words_of_piece("lengan kanan"), (Words{"sleeve", "right"}));
  EXPECT_EQ(words_of_piece("PIEDURKNE"), (Words{"sleeve"}));
  EXPECT_EQ(words_of_piece("esquena"), (Words{"back"}));
}

}  // namespace
}  // namespace toile
