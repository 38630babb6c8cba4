#include "core/draft/chair_cover.h"

#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/draft/outline.h"

namespace toile::draft {
namespace {

constexpr double kOutside = 0.03;  // m that pieces begin outside of where they come to lie

/// The cover as a solid: the chair, `ease` larger all around. Millimetres; z as in space.
struct CoverSize {
  double half = 0;                           ///< of its width
  double front = 0, inside = 0, behind = 0;  ///< z at the seat: of the front, the back's two sides
  double seat = 0, top = 0;                  ///< heights
  double lean = 0;                           ///< that the back's top lies farther behind than its foot
  double hem = 0;                            ///< length of the skirt
  double seat_depth() const { return front - inside; }
  double boxing() const { return inside - behind; }
  double back_height() const { return top - seat; }
  double back_length() const { return std::hypot(back_height(), lean); }
};

CoverSize cover_of(const ChairCoverStyle& s, const ChairSize& c) {
  CoverSize out;
  out.half = c.width / 2 + s.ease;
  out.front = c.depth / 2 + s.ease;
  out.inside = c.back_thick - c.depth / 2 + s.ease;
  out.behind = -c.depth / 2 - s.ease;
  out.seat = c.seat;
  out.top = c.seat + c.back + s.ease;
  out.lean = c.rake * out.back_height();
  out.hem = c.seat - s.above_floor;
  return out;
}

/// The boxing of the side at +x, seen from outside: its front's foot at the origin, the chair's back to the
/// right.
pattern::Panel side_boxing(const std::string& id, const CoverSize& c) {
  const double thick = c.boxing(), high = c.back_height();
  Outline out({0, 0});
  out.line("bottom", {thick, 0}).line("back", {thick + c.lean, high});
  out.line("top", {c.lean, high}).line("front", {0, 0});
  return piece(id, out);
}

/// Of the front or behind: the middle of its upper edge at the origin.
pattern::Panel skirt(const std::string& id, const CoverSize& c, double flare) {
  Outline out({-c.half - flare, -c.hem});
  out.line("hem", {c.half + flare, -c.hem}).line("right", {c.half, 0});
  out.line("top", {-c.half, 0}).line("left", {-c.half - flare, -c.hem});
  return piece(id, out);
}

/// Of the side at +x, seen from outside: its front's upper end at the origin.
pattern::Panel side_skirt(const std::string& id, const CoverSize& c, double flare) {
  const double deep = c.seat_depth() + c.boxing();
  Outline out({-flare, -c.hem});
  out.line("hem", {deep + flare, -c.hem}).line("back", {deep, 0});
  out.line("boxing", {c.seat_depth(), 0}).line("seat", {0, 0}).line("front", {-flare, -c.hem});
  return piece(id, out);
}

void sew_chair_side(Garment& g, const std::string& side) {
  // Of pieces that face backwards the other edge lies there.
  const std::string behind = side == "right" ? "left" : "right";
  const std::string boxing = side + " boxing", skirt = side + " skirt";
  sew(g, side + "_seat", {{"seat", side}}, {{skirt, "seat"}});
  sew(g, side + "_boxing_foot", {{boxing, "bottom"}}, {{skirt, "boxing"}});
  sew(g, side + "_boxing_inside", {{"inside back", side}}, {{boxing, "front"}});
  sew(g, side + "_boxing_outside", {{"outside back", behind}}, {{boxing, "back"}});
  sew(g, side + "_boxing_top", {{"top boxing", side}}, {{boxing, "top"}});
  sew(g, side + "_front", {{"front skirt", side}}, {{skirt, "front"}});
  sew(g, side + "_back", {{"back skirt", behind}}, {{skirt, "back"}});
}

/// Each piece outside of where it comes to lie, none in another's way.
void place(Garment& g, const CoverSize& c) {
  const double tilt = degrees_from_radians(std::atan2(c.lean, c.back_height()));
  const auto at = [](double x, double y, double z) { return Vec3{x, y, z} * 1e-3; };
  const Vec3 up{0, kOutside, 0}, out{kOutside, 0, 0}, near{0, 0, kOutside};
  g.places = {{"seat", at(0, c.seat, c.front) + up, kLying},
              {"inside back", at(0, c.seat, c.inside) + near + up * 2, {-tilt, 0, 0}},
              {"outside back", at(0, c.seat, c.behind) - near + up, {tilt, 180, 0}},
              {"top boxing", at(0, c.top, c.inside - c.lean) + up * 2, kLying},
              {"right boxing", at(c.half, c.seat, c.inside) + out + up, {0, 90, 0}},
              {"left boxing", at(-c.half, c.seat, c.inside) - out + up, {0, -90, 0}},
              {"front skirt", at(0, c.seat, c.front) + near, {}},
              {"back skirt", at(0, c.seat, c.behind) - near, {0, 180, 0}},
              {"right skirt", at(c.half, c.seat, c.front) + out, {0, 90, 0}},
              {"left skirt", at(-c.half, c.seat, c.front) - out, {0, -90, 0}}};
}

}  // namespace

Garment draft_chair_cover(const ChairCoverStyle& s, const ChairSize& chair) {
  const CoverSize c = cover_of(s, chair);
  Garment g{.name = "chair-cover", .title = "Chair cover"};
  g.cloths = {{"canvas", "canvas", {0.17, 0.24, 0.29}},
              {"linen", "linen", {0.55, 0.50, 0.42}},
              {"velvet", "velvet", {0.06, 0.14, 0.12}}};
  const pattern::Panel boxing = side_boxing("right boxing", c), flank = side_skirt("right skirt", c, s.flare);
  g.pattern.panels = {rectangle("seat", 2 * c.half, c.seat_depth()),
                      rectangle("inside back", 2 * c.half, c.back_length()),
                      rectangle("outside back", 2 * c.half, c.back_length()),
                      rectangle("top boxing", 2 * c.half, c.boxing()),
                      boxing,
                      mirrored(boxing, "left boxing"),
                      skirt("front skirt", c, s.flare),
                      skirt("back skirt", c, s.flare),
                      flank,
                      mirrored(flank, "left skirt")};
  sew(g, "seat_back", {{"seat", "top"}}, {{"inside back", "bottom"}});
  sew(g, "seat_front", {{"seat", "bottom"}}, {{"front skirt", "top"}});
  sew(g, "back_waist", {{"outside back", "bottom"}}, {{"back skirt", "top"}});
  sew(g, "top_inside", {{"inside back", "top"}}, {{"top boxing", "bottom"}});
  sew(g, "top_outside", {{"outside back", "top"}}, {{"top boxing", "top"}});
  for (const std::string side : {"right", "left"}) sew_chair_side(g, side);
  place(g, c);
  g.solids = {{"chair", chair_solid(chair)}};
  g.particle_distance_mm = 17;
  lay_out(g);
  return g;
}

}  // namespace toile::draft
