#include "core/draft/garments.h"

#include <algorithm>

#include "core/draft/blouse.h"
#include "core/draft/chair_cover.h"
#include "core/draft/circle_dress.h"
#include "core/draft/circle_skirt.h"
#include "core/draft/curtain.h"
#include "core/draft/house.h"
#include "core/draft/jacket.h"
#include "core/draft/pencil_skirt.h"
#include "core/draft/trousers.h"
#include "core/draft/tshirt.h"

namespace toile::draft {

const std::vector<GarmentKind>& garment_kinds() {
  static const std::vector<GarmentKind> kinds{
      {"tshirt", "T-shirt of jersey with a rib neckband", "eu40",
       [](const Wearer& w) { return draft_tshirt(w); }},
      {"slacks", "Slacks with darts, a waistband and creases", "m50",
       [](const Wearer& w) { return draft_slacks(w); }},
      {"pencil-skirt", "Pencil skirt with darts, a waistband and a slit", "eu40",
       [](const Wearer& w) { return draft_pencil_skirt(w); }},
      {"circle-skirt", "Full circle on a waistband", "eu38",
       [](const Wearer& w) { return draft_circle_skirt(w); }},
      {"circle-dress", "Sleeveless dress, a darted bodice over a full circle", "eu38",
       [](const Wearer& w) { return draft_circle_dress(w); }},
      {"blouse", "Blouse with a collar on a stand, a placket, set-in sleeves and cuffs", "eu40",
       [](const Wearer& w) { return draft_blouse(w); }},
      {"jacket", "Tailored jacket with lapels, a collar that falls, panel seams and two-piece sleeves",
       "eu40", [](const Wearer& w) { return draft_jacket(w); }},
      {"trapezoids", "One shape, six fabrics, hung by two corners", "",
       [](const Wearer&) { return draft_trapezoids(); }},
      {"tablecloth", "Round cloth on a round table", "", [](const Wearer&) { return draft_tablecloth(); }},
      {"curtain", "Pair of curtains, gathered at a rail", "", [](const Wearer&) { return draft_curtain(); }},
      {"chair-cover", "Fitted cover of a dining chair, down to the floor", "",
       [](const Wearer&) { return draft_chair_cover(); }},
      {"cushion", "Cushion, filled", "", [](const Wearer&) { return draft_cushion(); }},
  };
  return kinds;
}

const GarmentKind* find_garment(std::string_view name) {
  const std::vector<GarmentKind>& kinds = garment_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const GarmentKind& k) { return k.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace toile::draft
