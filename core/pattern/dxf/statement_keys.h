#pragma once
// What the texts of AAMA and ASTM files state, in the languages that programs write them in.

#include <string>

namespace toile::dxf {

/// The key in English, as ASTM D6673 has it, of one that is written in another language: "Stückzahl",
/// "parça adı". Small letters, single blanks; what is not known stays.
std::string english_key(const std::string& key);

}  // namespace toile::dxf
