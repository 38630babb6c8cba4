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

constexpr std::size_t kMostOfWay = 1'000'000;  // vertices of a body's keyframes: 12 MB

/// Every other one goes, but the last, until they fit a film.
std::vector<body::Keyframe> thinned(std::vector<body::Keyframe> keyframes) {
  while (keyframes.size() > 1 && keyframes.size() * keyframes.front().vertices.size() > kMostOfWay) {
    std::vector<body::Keyframe> kept;
    for (std::size_t k = (keyframes.size() - 1) % 2; k < keyframes.size(); k += 2)
      kept.push_back(std::move(keyframes[k]));
    keyframes = std::move(kept);
  }
  return keyframes;
}

/// The frames around a time, and how far it is from the first to the second.
struct Around {
  const FilmFrame& from;
  const FilmFrame& to;
  double share;
};
Around around(const Motion& motion, double time) {
  const auto after = std::find_if(motion.frames.begin(), motion.frames.end(),
                                  [time](const FilmFrame& frame) { return frame.time >= time; });
  if (after == motion.frames.end()) return {motion.frames.back(), motion.frames.back(), 0};
  if (after == motion.frames.begin()) return {*after, *after, 0};
  const FilmFrame& before = *std::prev(after);
  return {before, *after, (time - before.time) / static_cast<double>(after->time - before.time)};
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
            .ways = {},
            .textures = std::move(textures),
            .looks = looks_of(input),
            .motion = std::move(motion)};
  for (const body::Body& body : result.bodies) film.bodies.push_back(body.mesh);
  for (std::size_t b = 0; b < input.bodies.size(); ++b) {
    const body::Body& body = input.bodies[b];
    if (body.motion.empty()) continue;
    film.ways.push_back({static_cast<Index>(b), body.mesh.vertices, thinned(body.motion)});
  }
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

std::vector<geometry::TriangleMesh> bodies_at(const Film& film, double played) {
  std::vector<geometry::TriangleMesh> bodies = film.bodies;
  for (const BodyWay& way : film.ways)
    bodies[static_cast<std::size_t>(way.body)].vertices = body::vertices_at(way.start, way.keyframes, played);
  return bodies;
}

double played_at(const Motion& motion, double time) {
  const auto [from, to, share] = around(motion, time);
  return from.bodies + (to.bodies - from.bodies) * share;
}

std::vector<Vec3> positions_at(const Motion& motion, double time) {
  const auto [before, after, share] = around(motion, time);
  std::vector<Vec3> positions = proto::dequantise(after.grid, motion.grid);
  if (&before == &after) return positions;
  const std::vector<Vec3> from = proto::dequantise(before.grid, motion.grid);
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = from[v] + (positions[v] - from[v]) * share;
  return positions;
}

}  // namespace toile::movie
