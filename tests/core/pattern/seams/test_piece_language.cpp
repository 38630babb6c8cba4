#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_words.h"

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

TEST(PieceLanguage, BytesThatAreNoTextDoNoHarm) {
  EXPECT_EQ(words_of_piece("\xc3"), Words{});
  EXPECT_EQ(words_of_piece("\xff\xc5sleeve\xc3\x28"), (Words{"sleeve"}));
}

}  // namespace
}  // namespace toile
