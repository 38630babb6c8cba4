#include "core/warm/carried_pins.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "core/mesh/flat_locator.h"
#include "core/warm/flat_map.h"

namespace toile::warm {

namespace {

/// A pin that is no farther beside the cloth holds its border: cuts move by that much when they are meshed.
constexpr double kBeside = 5e-3;  // m

/// A piece that is there now, and before.
struct Piece {
  std::vector<Vec2> places;  ///< where each vertex of now lay before, m
  const std::vector<Tri>* triangles = nullptr;
  Index first_triangle = 0;  ///< in the garment
};

std::optional<Piece> piece_of(const std::string& id, const HungGarment& hung, const pattern::Pattern& pattern,
                              const mesh::PanelMeshes& meshes) {
  const auto before =
      std::find_if(hung.pieces.begin(), hung.pieces.end(), [&](const HungPiece& p) { return p.id == id; });
  Index first = 0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const mesh::PanelMesh& now = meshes.panels[p];
    if (pattern.panels[p].id == id && before != hung.pieces.end()) {
      std::vector<std::string> edges;
      for (const pattern::PanelEdge* edge : pattern::edges_of(pattern.panels[p])) edges.push_back(edge->id);
      const bool same = before->rest == now.rest && before->triangles == now.triangles;
      return Piece{same ? now.rest : places_before(*before, now, edges), &now.triangles, first};
    }
    first += static_cast<Index>(now.triangles.size());
  }
  return std::nullopt;
}

/// The point of `piece` that lay at `at` before, or beside it.
std::optional<CarriedPin> point_at(Vec2 at, const Piece& piece) {
  const mesh::FlatPlace found = mesh::FlatLocator(piece.places, *piece.triangles).at(at);
  if (found.triangle == kNone) return std::nullopt;
  CarriedPin pin{piece.first_triangle + found.triangle, found.share};
  double sum = 0;
  for (double& share : pin.share) sum += share = std::max(0.0, share);
  const Tri& corners = (*piece.triangles)[static_cast<std::size_t>(found.triangle)];
  Vec2 place;
  for (std::size_t k = 0; k < 3; ++k) {
    pin.share.at(k) /= sum;
    place = place + piece.places[static_cast<std::size_t>(corners.at(k))] * pin.share.at(k);
  }
  if (length(place - at) > kBeside) return std::nullopt;
  return pin;
}

}  // namespace

std::vector<CarriedPin> carried_pins(const HungGarment& hung, const pattern::Pattern& pattern,
                                     const mesh::PanelMeshes& meshes) {
  std::map<std::string, std::optional<Piece>> pieces;  // each is laid over the one of before once
  std::vector<CarriedPin> carried;
  for (const HungPin& pin : hung.pins) {
    const auto [found, anew] = pieces.try_emplace(pin.piece);
    if (anew) found->second = piece_of(pin.piece, hung, pattern, meshes);
    const std::optional<CarriedPin> point = found->second ? point_at(pin.at, *found->second) : std::nullopt;
    if (point) carried.push_back(*point);
  }
  return carried;
}

}  // namespace toile::warm
