#pragma once
// What the names of pieces say: what kind of piece it is, for which side and face of the body.

#include <string>
#include <vector>

namespace toile::pattern {
struct Pattern;
}

namespace toile::seams {

/// What kind of piece a name tells of.
enum class PieceKind {
  kOther,
  kCollar,
  kHood,
  kTorso,
  kBand,
  kSkirt,
  kLegs,
  kSleeve,
  kCuff,
  kFrill,
  kInsert,
  kStrap  ///< a strip that hangs by its ends: straps, ties, belts
};

/// What a piece's name says of its place, as far as it says anything.
struct PieceWords {
  PieceKind kind = PieceKind::kOther;
  bool guessed = false;        ///< no name says the kind, but the rest of the garment
  int side = 0;                ///< -1 left, +1 right
  int face = 0;                ///< +1 front, -1 back
  int sleeve_part = 0;         ///< of a sleeve of two pieces: +1 the upper one, -1 the one under the arm
  bool flank = false;          ///< the side of a body: left and right never meet
  bool leg = false;            ///< of trousers
  bool limb = false;           ///< a sleeve or a cuff: left and right never meet
  bool stand = false;          ///< what a collar is sewn to along its length
  bool yoke = false;           ///< lies over both shoulders, or goes around the hip: it is no tube
  bool hem_band = false;       ///< a band that ends a top below; of a skirt nothing tells what it is
  bool bib = false;            ///< stands up from a waist in the middle of its face, its sides free
  bool over_shoulder = false;  ///< a strap, no tie or belt
  bool belt = false;           ///< a strap around the waist
  bool layer = false;          ///< a lining, a facing, a pocket: cloth that lies on other cloth

  void guess(PieceKind what) {
    kind = what;
    guessed = true;
  }
};

/// Whether the piece is a belt or a tie, which is knotted around the garment.
bool is_tied(const PieceWords& words);

/// Whether pieces of that kind go around the neck.
bool is_neck(PieceKind kind);

/// Whether a piece of kind `lower` is sewn to hang from the lower end of one of kind `upper`, as a skirt from
/// a bodice: +1. −1: the two are never sewn so, or not at all. 0: the kinds do not tell.
int hangs_from(PieceKind lower, PieceKind upper);

/// Whether pieces of the two kinds are ever sewn to each other.
bool ever_meet(PieceKind a, PieceKind b);

/// The words of one name, such as "left_sleeve_f", "FrontL" or "BK-2".
PieceWords words_of(const std::string& name);

/// The words of the panels' names, where one tells of another: "RT" alone is right, but beside a "VT"
/// (Vorderteil) it is a back (Rückenteil); and a side that three or more names all tell is a size ("_L") or
/// the half that is drawn, and no side.
std::vector<PieceWords> words_of_garment(const pattern::Pattern& pattern);

}  // namespace toile::seams
