#pragma once

#include <string>

#include "core/drape/drape_input.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

/// 128 bits, as 32 hex digits, over every field of a drape's input and over the start that was made of it:
/// equal hashes mean that the same program drapes both to the same bytes.
std::string input_hash(const DrapeInput& input, const sewing::Assembly& start);

}  // namespace toile::drape
