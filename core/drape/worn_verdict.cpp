#include "core/drape/worn_verdict.h"

#include <algorithm>

#include "core/dressing/certificate.h"

namespace toile::drape {

namespace {

constexpr double kDropped = 0.01;  // m above the ankles: what lies under that all around has fallen

preflight::Concerns pieces_of(const DrapeInput& input, const sewing::GarmentMesh& garment,
                              const std::vector<Index>& ring) {
  preflight::Concerns pieces;
  for (const Index v : ring) {
    preflight::Concern piece = preflight::piece_named(input.pattern.panels[garment.panel_of_vertex[v]].id);
    if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end()) pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool is_whole(const DrapeInput& input, const std::vector<OpenSeam>& open) {
  return open.empty() && std::all_of(input.left_out.begin(), input.left_out.end(),
                                     [](const LeftOut& piece) { return piece.layer; });
}

}  // namespace

WornVerdict judge_worn(const DrapeInput& input, const std::optional<dressing::Person>& person,
                       const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                       const std::vector<OpenSeam>& open) {
  WornVerdict verdict;
  if (!person || garment.sewn.empty() || x.empty()) return verdict;
  verdict.worn = is_whole(input, open) ? Worn::kYes : Worn::kPartly;
  const auto add = [&](preflight::FindingKind kind, std::string message, preflight::Concerns about, Vec3 at) {
    verdict.findings.push_back(preflight::found(kind, std::move(message), std::move(about), at));
    verdict.worn = Worn::kNo;
  };
  const dressing::Skeleton skeleton = dressing::skeleton_of(person->figure);
  for (const dressing::WornRing& ring : dressing::worn_rings(garment, x, skeleton)) {
    if (ring.right) continue;
    add(preflight::FindingKind::kRingOff,
        "the ring of " + preflight::length_text(ring.girth) + " ended around no part of the body",
        pieces_of(input, garment, ring.vertices), x[ring.vertices.front()]);
  }
  const auto highest = std::max_element(x.begin(), x.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
  if (highest->y < person->figure.leg[0].ankle.y + kDropped)
    add(preflight::FindingKind::kOnGround, "the garment has fallen to the ground", {}, *highest);
  return verdict;
}

}  // namespace toile::drape
