#include "tests/core/preflight/broken_starts.h"

#include "tests/core/drape/garments.h"

namespace toile::test {

namespace {

constexpr double kHalfTurn = 3.14159265358979;

sewing::RigidPlacement& placed(drape::DrapeInput& input, std::size_t piece) {
  return std::get<sewing::RigidPlacement>(input.placements[piece]);
}

drape::DrapeInput with_front_at(double z) {
  drape::DrapeInput input = tube();
  placed(input, 0).translation.z = z;
  return input;
}

drape::DrapeInput with_sheet_at(double y) {
  drape::DrapeInput input = tablecloth();
  placed(input, 0).translation.y = y;
  return input;
}

/// The tube and a loose patch.
drape::DrapeInput with_patch(Vec3 at, Vec3 rotation = {}, double size = 60, const std::string& id = "patch",
                             drape::DrapeInput input = tube()) {
  input.pattern.panels.push_back(rectangle(id, size, size));
  input.placements.push_back(sewing::RigidPlacement{at, rotation, false});
  input.fabric_of_panel.push_back(0);
  return input;
}

drape::DrapeInput with_pieces(double front_width, double front_height, double back_width,
                              double back_height) {
  drape::DrapeInput input = tube();
  input.pattern.panels = {rectangle("front", front_width, front_height),
                          rectangle("back", back_width, back_height)};
  return input;
}

drape::DrapeInput with_sides_of(double front, double back) { return with_pieces(260, front, 260, back); }

drape::DrapeInput with_reversed(std::vector<std::size_t> seams) {
  drape::DrapeInput input = tube();
  for (const std::size_t s : seams) input.pattern.seams[s].same_direction = false;
  return input;
}

drape::DrapeInput turned_left_to_right() {
  drape::DrapeInput input = tube();
  placed(input, 1).rotation = {0, kHalfTurn, 0};
  return input;
}

drape::DrapeInput turned_upside_down() {
  drape::DrapeInput input = tube();
  placed(input, 1).rotation = {0, 0, kHalfTurn};
  placed(input, 1).translation.y = 0.27;
  return input;
}

drape::DrapeInput huge() {
  drape::DrapeInput input = with_pieces(2600, 1200, 2600, 1200);
  input.settings.particle_distance = 0.2;
  return input;
}

drape::DrapeInput with_short_edge() {
  drape::DrapeInput input = tube();
  pattern::Panel& panel = input.pattern.panels[0];
  panel.outline.edges[2].curves = {line({130, 120}, {-126, 120})};
  panel.outline.edges[3].curves = {line({-130, 116}, {-130, 0})};
  panel.outline.edges.push_back({"e4", {line({-126, 120}, {-130, 116})}});
  std::swap(panel.outline.edges[3], panel.outline.edges[4]);  // the corner comes before the left side
  panel.outline.edges[3].id = "corner";
  input.pattern.seams[0].a[0].edge = 4;
  return input;
}

/// Narrow strips before and behind the column, sewn right through it.
drape::DrapeInput sewn_through() { return with_pieces(20, 120, 20, 120); }

/// Strips whose threads pass 12 mm beside a slim post.
drape::DrapeInput beside_a_limb() {
  drape::DrapeInput input = with_pieces(84, 120, 84, 120);
  input.bodies = {column(0.03, 0, 0.3)};
  return input;
}

/// Two pieces joined over the column's head, threads 8 mm under it.
drape::DrapeInput over_a_shoulder() {
  drape::DrapeInput input = tube();
  input.pattern.seams = {{"shoulder", {{0, 2, false}}, {{1, 2, false}}, true}};
  input.pattern.panels = {rectangle("front", 60, 120), rectangle("back", 60, 120)};
  for (std::size_t p : {0, 1}) placed(input, p).translation.y = 0.172;
  return input;
}

drape::DrapeInput beside_the_body() {
  drape::DrapeInput input = tube();
  for (std::size_t p : {0, 1}) placed(input, p).translation.x = 0.4;
  return input;
}

drape::DrapeInput rolled_onto_itself() {
  drape::DrapeInput input = tube();
  input.pattern.seams.clear();
  sewing::WrappedPlacement roll;
  roll.axis = {0.4, 0, 0};
  roll.radius = 0.03;
  roll.height = 0.1;  // 188 mm around for 260 mm of cloth
  input.placements[0] = roll;
  return input;
}

/// Left and right lie in one plane and overlap at the middle, as the crotch tips of trousers do.
drape::DrapeInput overlapping_tips() {
  drape::DrapeInput input = with_patch({-0.027, 0.15, -0.16}, {}, 60, "left");
  return with_patch({0.027, 0.15, -0.16}, {}, 60, "right", input);
}

drape::DrapeInput stack_of_three() {
  drape::DrapeInput input = with_patch({0.02, 0.16, 0.2}, {}, 60, "one");
  input = with_patch({0, 0.18, 0.2}, {}, 50, "two", input);
  return with_patch({-0.02, 0.17, 0.2}, {}, 40, "three", input);
}

drape::DrapeInput twisted_series() {
  drape::DrapeInput input = tube();
  // The left side of the front in two edges.
  pattern::Panel& panel = input.pattern.panels[0];
  panel.outline.edges[3].curves = {line({-130, 120}, {-130, 50})};
  panel.outline.edges.push_back({"e4", {line({-130, 50}, {-130, 0})}});
  input.pattern.seams[0] = {"left", {{0, 3, false}, {0, 4, false}}, {{1, 3, false}}, false};
  return input;
}

drape::DrapeInput out_of_sight() {
  drape::DrapeInput input = tube();
  placed(input, 1).translation = {30, 0, 0};
  return input;
}

/// A patch beside the column, between the front's and the back's side edges.
drape::DrapeInput with_patch_between() { return with_patch({0.13, 0.16, 0}, {}, 60); }

/// A strip sewn on around the tube's upper edge, across both of its side seams.
drape::DrapeInput with_collar() {
  drape::DrapeInput input = tube();
  input.pattern.panels.push_back(rectangle("collar", 520, 40));
  input.pattern.seams.push_back({"neck", {{2, 0, false}}, {{0, 2, true}, {1, 2, false}}, true});
  input.fabric_of_panel.push_back(0);
  sewing::WrappedPlacement around;
  around.radius = 0.13;
  around.height = 0.32;
  around.angle = kHalfTurn / 2;
  input.placements.push_back(around);
  return input;
}

/// Two legs of trousers about one leg of two.
drape::DrapeInput both_about_one_leg() {
  drape::DrapeInput input = tube();
  input.pattern.panels.push_back(rectangle("front_2", 260, 120));
  input.pattern.panels.push_back(rectangle("back_2", 260, 120));
  input.pattern.seams.push_back({"left_2", {{2, 3, false}}, {{3, 3, false}}, true});
  input.pattern.seams.push_back({"right_2", {{2, 1, false}}, {{3, 1, false}}, true});
  input.fabric_of_panel = {0, 0, 0, 0};
  for (const double y : {0.12, 0.25}) {
    for (const double z : {0.1, -0.1}) {
      const std::size_t p = (y > 0.2 ? 2 : 0) + (z < 0 ? 1 : 0);
      if (p >= input.placements.size()) input.placements.resize(p + 1, sewing::RigidPlacement{});
      placed(input, p).translation = {0.2, y, z};
    }
  }
  body::Body legs = column(0.07, 0, 0.6);
  const body::Body other = column(0.07, 0, 0.6);
  for (Vec3& v : legs.mesh.vertices) v.x += 0.2;
  const auto first = static_cast<Index>(legs.mesh.vertices.size());
  for (const Vec3& v : other.mesh.vertices) legs.mesh.vertices.push_back({v.x - 0.2, v.y, v.z});
  for (const Tri& t : other.mesh.triangles)
    legs.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  input.bodies = {legs};
  return input;
}

/// The tube's back is cut as if seen from the front: sewn, its wrong side lies beside the front's right side.
drape::DrapeInput wound_the_other_way() { return tube(); }

drape::DrapeInput tilted_into_the_body() {
  drape::DrapeInput input = tube();
  placed(input, 0).rotation = {0.3, 0, 0};
  placed(input, 0).translation.z = 0.055;
  return input;
}

drape::DrapeInput both_in_the_body() {
  drape::DrapeInput input = tube();
  placed(input, 0).translation.z = 0.062;
  placed(input, 1).translation.z = -0.062;
  return input;
}

/// A slit in one sheet through which another passes.
drape::DrapeInput crossed_patches() {
  drape::DrapeInput input = with_patch({0, 0.15, 0.2}, {0, 0.3, 0}, 60, "one");
  return with_patch({0.025, 0.16, 0.2}, {0, -0.3, 0}, 60, "two", input);
}

}  // namespace

const std::vector<BrokenStart>& broken_starts() {
  static const std::vector<BrokenStart> all{
      {"front 1 cm into the body", preflight::FindingKind::kCrossesBody, true,
       [] { return with_front_at(0.06); }},
      {"front 3 cm into the body", preflight::FindingKind::kCrossesBody, true,
       [] { return with_front_at(0.04); }},
      {"front through the middle of the body", preflight::FindingKind::kCrossesBody, false,
       [] { return with_front_at(0.003); }},
      {"front on the skin", preflight::FindingKind::kTouches, true, [] { return with_front_at(0.07); }},
      {"front half a millimetre from the skin", preflight::FindingKind::kGap, true,
       [] { return with_front_at(0.0705); }},
      {"sheet 2 cm in the head", preflight::FindingKind::kCrossesBody, true,
       [] { return with_sheet_at(0.28); }},
      {"sheet on the head", preflight::FindingKind::kTouches, true, [] { return with_sheet_at(0.3); }},
      {"sheet 1 cm in the head", preflight::FindingKind::kCrossesBody, true,
       [] { return with_sheet_at(0.29); }},
      {"sheet 0.3 mm over the head", preflight::FindingKind::kGap, true,
       [] { return with_sheet_at(0.3003); }},
      {"sheet 10 cm in the head", preflight::FindingKind::kCrossesBody, false,
       [] { return with_sheet_at(0.2); }},
      {"patch in the front's plane", preflight::FindingKind::kTouches, true,
       [] {
         return with_patch({0.05, 0.2, 0.1});
       }},
      {"patch 0.4 mm before the front", preflight::FindingKind::kGap, true,
       [] {
         return with_patch({0.05, 0.2, 0.1004});
       }},
      {"patch through the front", preflight::FindingKind::kCrossesCloth, true,
       [] {
         return with_patch({0, 0.18, 0.09}, {0.4, 0, 0});
       }},
      {"patch upright through the front", preflight::FindingKind::kCrossesCloth, false,
       [] {
         return with_patch({0, 0.1, 0.1}, {0, kHalfTurn / 2, 0}, 200);
       }},
      {"patch in the body, near the skin", preflight::FindingKind::kInsideBody, true,
       [] {
         return with_patch({0, 0.05, 0.045}, {}, 30);
       }},
      {"patch in the middle of the body", preflight::FindingKind::kInsideBody, false,
       [] {
         return with_patch({0, 0.12, 0}, {}, 30);
       }},
      {"patch under the skin of the head", preflight::FindingKind::kInsideBody, true,
       [] {
         return with_patch({0, 0.27, 0}, {}, 20);
       }},
      {"left and right overlap in one plane", preflight::FindingKind::kTouches, true, overlapping_tips},
      {"three patches in one plane", preflight::FindingKind::kTouches, true, stack_of_three},
      {"piece rolled onto itself", preflight::FindingKind::kCrossesCloth, false, rolled_onto_itself},
      {"one seam reversed", preflight::FindingKind::kTwisted, true, [] { return with_reversed({0}); }},
      {"both seams reversed", preflight::FindingKind::kTwisted, true,
       [] {
         return with_reversed({0, 1});
       }},
      {"series reversed", preflight::FindingKind::kTwisted, false, twisted_series},
      {"back turned left to right", preflight::FindingKind::kTurned, true, turned_left_to_right},
      {"back turned in its plane", preflight::FindingKind::kTurned, true, turned_upside_down},
      {"ten times too large", preflight::FindingKind::kScale, false, huge},
      {"back in inches", preflight::FindingKind::kScale, false,
       [] { return with_pieces(260, 120, 660, 304.8); }},
      {"back in another place", preflight::FindingKind::kFar, false, out_of_sight},
      {"gather of 1:4", preflight::FindingKind::kLengthRatio, false, [] { return with_sides_of(40, 160); }},
      {"gather of 1:2", preflight::FindingKind::kLengthDifference, false,
       [] { return with_sides_of(80, 160); }},
      {"5 % of ease", preflight::FindingKind::kLengthDifference, false,
       [] { return with_sides_of(120, 126); }},
      {"edge of 6 mm", preflight::FindingKind::kShortEdge, false, with_short_edge},
      {"girth under the body's", preflight::FindingKind::kTightRing, false,
       [] { return with_pieces(200, 120, 200, 120); }},
      {"threads through the body", preflight::FindingKind::kThreadThroughBody, false, sewn_through},
      {"threads over a shoulder", preflight::FindingKind::kThreadThroughBody, false, over_a_shoulder},
      {"threads beside a limb", preflight::FindingKind::kThreadNearLimb, false, beside_a_limb},
      {"tube beside the body", preflight::FindingKind::kRingAroundNothing, false, beside_the_body},
      {"threads through a third piece", preflight::FindingKind::kThreadThroughCloth, false,
       with_patch_between},
      {"collar across open side seams", preflight::FindingKind::kOnOpenRing, false, with_collar},
      {"both hems about one leg", preflight::FindingKind::kRingOnWrongLimb, false, both_about_one_leg},
      {"back wound the other way", preflight::FindingKind::kWindsOtherWay, false, wound_the_other_way},
      {"front tilted into the body", preflight::FindingKind::kCrossesBody, true, tilted_into_the_body},
      {"front and back in the body", preflight::FindingKind::kCrossesBody, true, both_in_the_body},
      {"two patches through each other", preflight::FindingKind::kCrossesCloth, true, crossed_patches},
      {"patch 0.2 mm under the skin", preflight::FindingKind::kInsideBody, true,
       [] {
         return with_patch({0, 0.05, 0.0655}, {}, 10);
       }},
  };
  return all;
}

}  // namespace toile::test
