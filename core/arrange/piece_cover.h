#pragma once

#include <string>

#include "core/arrange/garment_graph.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::arrange {

/// "torso", "sleeve", …
const char* name_of(Cover cover);

/// What a piece's name says that it covers: "pant_f_l" a leg, "wb_front" the waist, "SleeveL" an arm.
Cover cover_of_name(const std::string& name);

/// What a piece of that kind covers.
Cover cover_of_kind(seams::PieceKind kind);

/// 1 when it is worn in front by its name ("ftorso", "FrontPanel"), -1 when behind, 0 when that is not told.
int face_of_name(const std::string& name);

}  // namespace toile::arrange
