#include "server/movie/film.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/fabric/library.h"

namespace toile::movie {
namespace {

/// Of the library: a document's fabric that is like one of it keeps its title.
const fabric::FabricCard* card_of(const material::Fabric& fabric) {
  const std::vector<fabric::FabricCard>& cards = fabric::library();
  const auto found = std::find_if(cards.begin(), cards.end(), [&](const fabric::FabricCard& card) {
    return card.name == fabric.id || card.title == fabric.name;
  });
  return found == cards.end() ? nullptr : &*found;
}

render::ClothLook look_of(const material::Fabric& fabric) {
  const fabric::FabricCard* const card = card_of(fabric);
  if (card == nullptr) return render::look_from("", "", "", fabric.thickness);
  std::string words =
      card->name + " " + card->title + " " + card->fibre + " " + card->weave + " " + card->construction;
  for (char& letter : words)
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
  return render::look_from(card->construction, card->weave, words, fabric.thickness);
}

}  // namespace

std::vector<render::ClothLook> looks_of(const drape::DrapeInput& input) {
  std::vector<render::ClothLook> looks;
  for (const Index fabric : input.fabric_of_panel)
    looks.push_back(look_of(input.fabrics[static_cast<std::size_t>(fabric)]));
  return looks;
}

Film film_of(const drape::DrapeInput& input, const drape::DrapeResult& result,
             std::vector<proto::StreamPiece> pieces, image::Textures textures, Motion motion) {
  Film film{.garment = result.garment,
            .pieces = std::move(pieces),
            .end = result.positions,
            .bodies = {},
            .textures = std::move(textures),
            .looks = looks_of(input),
            .motion = std::move(motion)};
  for (const body::Body& body : input.bodies) film.bodies.push_back(body.mesh);
  return film;
}

render::Scene scene_of(const Film& film, std::span<const Vec3> positions) {
  render::Scene scene;
  scene.cloth.positions = positions;
  scene.cloth.triangles = film.garment.triangles;
  scene.cloth.panel_of_triangle = film.garment.panel_of_triangle;
  scene.cloth.weld = film.garment.weld;
  scene.cloth.rest = film.garment.rest;
  scene.cloth.textures = &film.textures;
  for (const proto::StreamPiece& piece : film.pieces) scene.cloth.colour_of_panel.push_back(piece.colour);
  scene.cloth.look_of_panel = film.looks;
  for (const geometry::TriangleMesh& body : film.bodies) scene.bodies.push_back({.mesh = &body});
  return scene;
}

std::vector<Vec3> positions_at(const Motion& motion, double time) {
  const auto after = std::find_if(motion.frames.begin(), motion.frames.end(),
                                  [time](const FilmFrame& frame) { return frame.time >= time; });
  if (after == motion.frames.end()) return proto::dequantise(motion.frames.back().grid, motion.grid);
  std::vector<Vec3> positions = proto::dequantise(after->grid, motion.grid);
  if (after == motion.frames.begin()) return positions;
  const FilmFrame& before = *std::prev(after);
  const double share = (time - before.time) / static_cast<double>(after->time - before.time);
  const std::vector<Vec3> from = proto::dequantise(before.grid, motion.grid);
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = from[v] + (positions[v] - from[v]) * share;
  return positions;
}

}  // namespace toile::movie
