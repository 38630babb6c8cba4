// How often a piece is cut, where names and labels tell it in passing, and statements in other languages.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/pattern/dxf/read.h"
#include "core/pattern/dxf/told_quantity.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using dxf::told_quantity;
using namespace dxf_text;  // NOLINT(google-build-using-namespace): names of a test's own text

TEST(DxfQuantities, FiguresBesideWordsOfCuttingAndCountingTell) {
  const std::initializer_list<std::pair<std::string, int>> cases{
      {"SLEEVE x2", 2},        {"2x Taschenbeutel", 2}, {"CORTAR 2 (PAR)", 2},
      {"couper 1 paire", 2},   {"2 pairs", 4},          {"2 ADET (AYNALI)", 2},
      {"POCKET cut 4", 4},     {"rukav 2 ks", 2},       {"2 \u0434\u0435\u0442.", 2},
      {"Manga - 2 pzs 1x", 1}, {"1x im Stoffbruch", 1}, {"Hiha 2 kpl", 2},
      {"QTY 2 (1+1 MIRR)", 2}, {"Anzahl 3", 3},         {"2 (1x links, 1x rechts)", 2}};
  for (const auto& [text, count] : cases) {
    ASSERT_TRUE(told_quantity(text)) << text;
    EXPECT_EQ(told_quantity(text)->as_drawn, count) << text;
  }
  EXPECT_TRUE(told_quantity("cut 2 on fold")->told_apart) << "none of them is turned over";
}

TEST(DxfQuantities, SizesAndLengthsAreNone) {
  for (const char* text :
       {"FRONT 38", "5 x 5", "pocket 12 x 14", "Style 4471-03", "Sleeve", "x", "", "40x pcs"})
    EXPECT_FALSE(told_quantity(text)) << text;
}

TEST(DxfQuantities, AWordyTitleOfTheDrawingNamesNoPiece) {
  const std::string title = text({20, 300}, "Shirt Lina - Gr. 38 - ohne Nahtzugabe - Masse in mm", "1");
  const dxf::DxfDrawing d =
      read_trial(entities(rectangle({0, 0}, 300, 500, "1") + title + text({20, 200}, "Vorderteil", "1")));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].name, "Vorderteil");
}

TEST(DxfQuantities, WhatTellsNothingElseIsNoName) {
  for (const char* text : {"2x", "cut 1 on fold", "2 ADET (AYNALI)",
                           "2 \u0434\u0435\u0442. \u0437\u0435\u0440\u043a\u0430\u043b\u044c\u043d\u043e"})
    EXPECT_TRUE(dxf::tells_only_quantity(text)) << text;
  for (const char* text : {"SLEEVE x2", "Sleeve"}) EXPECT_FALSE(dxf::tells_only_quantity(text)) << text;
}

/// Pieces in a row, each with texts inside it.
dxf::DxfDrawing pieces_with(const std::vector<std::vector<std::string>>& texts) {
  std::string body;
  double x = 0;
  for (const std::vector<std::string>& lines : texts) {
    body += rectangle({x, 0}, 200, 300);
    double y = 280;
    for (const std::string& line : lines) body += text({x + 20, y -= 20}, line);
    x += 300;
  }
  return *dxf::read_dxf(entities(body), in_mm());
}

TEST(DxfQuantities, NamesAndLabelsCountPiecesWhereNothingElseDoes) {
  const dxf::DxfDrawing named = pieces_with({{"Front"}, {"Sleeve x2"}});
  EXPECT_EQ(named.pieces[0].quantity, 1);
  EXPECT_EQ(named.pieces[1].quantity, 2);
  EXPECT_EQ(named.pieces[1].mirrored, 1);
  const dxf::DxfDrawing labelled = pieces_with({{"2x", "Sleeve"}, {"Front", "Quantity: 1", "2x"}});
  EXPECT_EQ(labelled.pieces[0].name, "Sleeve");
  EXPECT_EQ(labelled.pieces[0].quantity, 2);
  EXPECT_EQ(labelled.pieces[1].quantity, 1) << "what is stated counts more";
}

TEST(DxfQuantities, SizesBehindAllNamesAndPiecesThatAreDrawnTwiceAreNotCounted) {
  for (const dxf::DxfPiece& piece : pieces_with({{"Front 2X"}, {"Back 2X"}, {"Sleeve 2X"}}).pieces)
    EXPECT_EQ(piece.quantity, 1) << "a size";
  const dxf::DxfDrawing drawn = pieces_with({{"Sleeve x2"}, {"Sleeve x2"}, {"Front"}});
  EXPECT_EQ(drawn.pieces[0].quantity + drawn.pieces[1].quantity, 2);
}

TEST(DxfQuantities, ShortenedWordsAndStatedTextsCount) {
  for (const char* text : {"TAGL. 2x", "CORT. 2", "1 para", "2x schuin", "1 paio", "QTD: 2x",
                           "Quantity: CUT 2", "Qte: 1 paire", "Q.TA: 2"}) {
    const dxf::DxfDrawing drawing = pieces_with({{"Sleeve", text}, {"Front"}});
    EXPECT_EQ(drawing.pieces[0].name, "Sleeve") << text;
    EXPECT_EQ(drawing.pieces[0].quantity, 2) << text;
  }
  EXPECT_FALSE(dxf::tells_only_quantity("2 para forro")) << "two for a lining";
}

TEST(DxfQuantities, ATextThatStandsInMostPiecesNamesNone) {
  const auto names_of = [](const std::vector<std::vector<std::string>>& texts) {
    std::vector<std::string> names;
    for (const dxf::DxfPiece& piece : pieces_with(texts).pieces) names.push_back(piece.name);
    return names;
  };
  EXPECT_EQ(names_of({{"REF 088", "FRENTE", "2x"}, {"REF 088", "TRASEIRO", "2x"}, {"REF 088", "COS", "1x"}}),
            (std::vector<std::string>{"FRENTE", "TRASEIRO", "COS"}));
  EXPECT_EQ(names_of({{"REF 088"}, {"REF 088"}, {"REF 088"}}),
            (std::vector<std::string>{"REF 088", "REF 088-2", "REF 088-3"}))
      << "there is nothing else";
  EXPECT_EQ(names_of({{"Sleeve", "lined"}, {"Sleeve", "plain"}, {"Front"}, {"Back"}}),
            (std::vector<std::string>{"Sleeve", "Sleeve-2", "Front", "Back"}))
      << "two of four are a pair";
}

TEST(DxfQuantities, StatementsOfOtherLanguagesAreRead) {
  const std::initializer_list<std::tuple<std::string, std::string, std::string>> cases{
      {"\u0414\u0435\u0442\u0430\u043b\u044c: A",
       "\u041a\u043e\u043b\u0438\u0447\u0435\u0441\u0442\u0432\u043e: 2",
       "\u041c\u0430\u0442\u0435\u0440\u0438\u0430\u043b: Denim"},
      {"Naziv: A", "Koli\u010dina: 2", "Materijal: Denim"},
      {"Alkatr\u00e9sz: A", "Darabsz\u00e1m: 2", "Anyag: Denim"},
      {"Reper: A", "Cantitate: 2", "\u021aes\u0103tur\u0103: Denim"},
      {"Kappale: A", "M\u00e4\u00e4r\u00e4: 2", "Kangas: Denim"}};
  for (const auto& [name, quantity, material] : cases) {
    const dxf::DxfPiece piece = pieces_with({{name, quantity, material}}).pieces[0];
    EXPECT_EQ(piece.name, "A") << name;
    EXPECT_EQ(piece.quantity, 2) << quantity;
    EXPECT_EQ(piece.material, "Denim") << material;
  }
}

TEST(DxfQuantities, AFigureAndAWordOfCountingAreAQuantityWhateverFollows) {
  for (const char* text : {"2 volte stoffa", "2 pcs main fabric", "2 Stk. Oberstoff", "2 szt. tkanina",
                           "x2 en vis-\u00e0-vis", "2x Oberstoff"}) {
    const dxf::DxfDrawing drawing = pieces_with({{"MANICA", text}, {"DIETRO"}});
    EXPECT_EQ(drawing.pieces[0].name, "MANICA") << text;
    EXPECT_EQ(drawing.pieces[0].quantity, 2) << text;
    EXPECT_EQ(drawing.pieces[1].quantity, 1) << text;
  }
  for (const char* text : {"2 PIECE SLEEVE", "2X", "2X LARGE", "5 x 5", "x 2 x 3", "SIZE 2"})
    EXPECT_FALSE(dxf::begins_with_count(text)) << text;
  EXPECT_EQ(pieces_with({{"2 pcs sleeve"}, {"BACK"}}).pieces[0].name, "2 pcs sleeve");
}

TEST(DxfQuantities, ATextThatBeginsWithHowOftenToCutIsAnOrderAndNoName) {
  for (const char* text : {"TAGLIARE 2 (DX+SX)", "Cut 2 fabric + 2 fusible", "cortar 2 tela"})
    EXPECT_TRUE(dxf::is_cutting_order(text)) << text;
  for (const char* text : {"Cut-off shorts", "Sleeve cut 2", "2x sleeve"})
    EXPECT_FALSE(dxf::is_cutting_order(text)) << text;
  for (const char* order : {"TAGLIARE 2 TESSUTO + 2 ADESIVO", "CORTAR: 2 TELA + 2 ENTRETELA"}) {
    const dxf::DxfDrawing drawing = pieces_with({{order, "MANICA"}, {"DIETRO"}});
    EXPECT_EQ(drawing.pieces[0].name, "MANICA") << order;
    EXPECT_EQ(drawing.pieces[0].quantity, 2) << order;
  }
  for (const char* told : {"KROJ: SLIM", "COUPE: 38"})
    EXPECT_EQ(pieces_with({{"MANICA", told}}).pieces[0].quantity, 1) << told;
}

TEST(DxfQuantities, TextsBelongToThePieceThatIsDrawnThereAndNotToAnUnfoldedOne) {
  // Half a back whose other half would lie over the front beside it.
  const std::string back =
      rectangle({0, 0}, 300, 500, "1") + line({300, 0}, {300, 500}, "6") + text({40, 300}, "Back", "1");
  const std::string front =
      rectangle({340, 0}, 240, 400, "1") + text({380, 200}, "Front", "1") + text({380, 160}, "Cut 2", "1");
  const dxf::DxfDrawing d = read_trial(entities(back + front), in_mm());
  ASSERT_EQ(d.pieces.size(), 2U);
  EXPECT_TRUE(d.pieces[0].unfolded);
  EXPECT_EQ(d.pieces[0].name, "Back");
  EXPECT_EQ(d.pieces[1].name, "Front");
  EXPECT_EQ(d.pieces[1].quantity, 2);
}

TEST(DxfQuantities, ATitleThatIsWiderThanItsStripBelongsToTheStripInItsMiddle) {
  const std::string strips = rectangle({0, 0}, 60, 400, "1") + rectangle({100, 0}, 60, 400, "1");
  const dxf::DxfDrawing d = read_trial(
      entities(strips + text({-20, 200}, "Binding of slit", "1") + text({78, 200}, "Interlining", "1")),
      in_mm());
  ASSERT_EQ(d.pieces.size(), 2U);
  EXPECT_EQ(d.pieces[0].name, "Binding of slit");
  EXPECT_EQ(d.pieces[1].name, "Interlining");
}

}  // namespace
}  // namespace toile
