#include "core/drape/drape_result.h"

namespace toile::drape {

std::string_view word_of(Worn worn) {
  switch (worn) {
    case Worn::kYes:
      return "yes";
    case Worn::kPartly:
      return "partly";
    case Worn::kNo:
      return "no";
    case Worn::kNobody:
      break;
  }
  return "";
}

}  // namespace toile::drape
