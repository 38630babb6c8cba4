#include "server/movie/film_codec.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/hash.h"
#include "core/base/state_bytes.h"
#include "core/image/read_picture.h"
#include "core/sewing/assembly.h"

namespace toile::movie {
namespace {

constexpr std::string_view kMagic = "TOILEFM\n";
constexpr std::size_t kHashDigits = 32;
// Versions that are still read, and written where no body moves.
constexpr std::uint32_t kWithoutLooks = 1, kStandingStill = 2;
constexpr std::uint32_t kEpoch = 1;  // a film has one
constexpr double kFarthest = 1000;   // m; what can be drawn (render/scene.h)
constexpr double kLongest = 1e9;     // s

Error damaged() {
  return {"film.damaged", "this is no film of a drape, or it is cut off or has changed", "",
          ErrorKind::kInput};
}

void write_places(StateWriter& out, std::span<const Vec3> places) {
  out.size(places.size());
  for (const Vec3 p : places)
    for (const double c : {p.x, p.y, p.z}) out.value(static_cast<float>(c));
}

std::vector<Vec3> read_places(StateReader& in) {
  std::vector<Vec3> places(in.count(3 * sizeof(float)));
  for (Vec3& p : places) {
    for (double* c : {&p.x, &p.y, &p.z}) {
      float number = 0;
      in.value(number);
      *c = number;
    }
  }
  return places;
}

void write(StateWriter& out, const geometry::TriangleMesh& mesh) {
  write_places(out, mesh.vertices);
  out.size(mesh.triangles.size());
  for (const Tri& t : mesh.triangles)
    for (const Index v : t) out.value(v);
}

geometry::TriangleMesh read_mesh(StateReader& in) {
  geometry::TriangleMesh mesh;
  mesh.vertices = read_places(in);
  in.value(mesh.triangles);
  return mesh;
}

void write(StateWriter& out, const image::Textures& textures) {
  out.size(textures.images.size());
  for (const auto& image : textures.images) {
    out.value(image->name);
    out.value(image->bytes);
  }
  out.size(textures.of_panel.size());
  for (const std::optional<image::PanelTexture>& texture : textures.of_panel) {
    image::PanelTexture laid;
    laid.image = kNone;
    if (texture) laid = *texture;
    out.value(laid.image);
    for (const Vec2 v : {laid.origin, laid.across, laid.up}) out.value(v);
  }
}

Result<image::Textures> read_textures(StateReader& in) {
  image::Textures textures;
  const std::size_t images = in.count(2 * sizeof(std::uint32_t));
  for (std::size_t i = 0; i < images; ++i) {
    auto image = std::make_shared<image::TextureImage>();
    in.value(image->name);
    in.value(image->bytes);
    auto read = image::read_picture(image->bytes);
    if (!read) return damaged();
    image->read = std::move(read).value();
    textures.images.push_back(std::move(image));
  }
  textures.of_panel.resize(in.count(sizeof(Index) + 6 * sizeof(double)));
  for (std::optional<image::PanelTexture>& texture : textures.of_panel) {
    image::PanelTexture laid;
    in.value(laid.image);
    for (Vec2* v : {&laid.origin, &laid.across, &laid.up}) in.value(*v);
    if (laid.image == kNone) continue;
    const bool known = laid.image >= 0 && static_cast<std::size_t>(laid.image) < textures.images.size();
    if (!known || !is_finite(laid.origin) || !is_finite(laid.across) || !is_finite(laid.up)) return damaged();
    texture = laid;
  }
  return textures;
}

void write(StateWriter& out, const std::vector<render::ClothLook>& looks) {
  out.size(looks.size());
  for (const render::ClothLook& look : looks) {
    out.value(static_cast<std::uint8_t>(look.structure));
    for (const float number : {look.thickness, look.pitch, look.roughness, look.sheen, look.uneven})
      out.value(number);
  }
}

Result<std::vector<render::ClothLook>> read_looks(StateReader& in) {
  std::vector<render::ClothLook> looks(in.count(1 + 5 * sizeof(float)));
  for (render::ClothLook& look : looks) {
    std::uint8_t structure = 0;
    in.value(structure);
    if (structure >= render::kStructures) return damaged();
    look.structure = static_cast<render::Structure>(structure);
    for (float* number : {&look.thickness, &look.pitch, &look.roughness, &look.sheen, &look.uneven}) {
      in.value(*number);
      if (!(*number >= 0 && *number <= 1)) return damaged();
    }
    if (look.pitch <= 0) return damaged();
  }
  return looks;
}

void write(StateWriter& out, const Motion& motion) {
  out.value(motion.grid.origin);
  out.value(motion.grid.step);
  out.value(motion.stride);
  out.size(motion.frames.size());
  const FilmFrame* before = nullptr;
  for (const FilmFrame& frame : motion.frames) {
    const auto seq = static_cast<std::uint32_t>(&frame - motion.frames.data() + 1);
    const proto::FrameHeader header{kEpoch, seq, frame.step, frame.time};
    out.value(before ? proto::encode_delta(header, frame.grid, before->grid)
                     : proto::encode_key(header, frame.grid));
    before = &frame;
  }
}

/// s of the bodies' motion, one a frame.
void write_times(StateWriter& out, const Motion& motion) {
  out.size(motion.frames.size());
  for (const FilmFrame& frame : motion.frames) out.value(frame.bodies);
}

Status read_times(StateReader& in, Motion& motion) {
  if (in.count(sizeof(float)) != motion.frames.size()) return damaged();
  for (FilmFrame& frame : motion.frames) {
    in.value(frame.bodies);
    if (!(frame.bodies >= 0 && frame.bodies <= kLongest)) return damaged();
  }
  return {};
}

void write_ways(StateWriter& out, const Film& film) {
  out.size(film.ways.size());
  for (const BodyWay& way : film.ways) {
    out.value(way.body);
    write_places(out, way.start);
    out.size(way.keyframes.size());
    for (const body::Keyframe& keyframe : way.keyframes) {
      out.value(keyframe.at);
      write_places(out, keyframe.vertices);
    }
  }
}

std::vector<BodyWay> read_ways(StateReader& in) {
  std::vector<BodyWay> ways(in.count(sizeof(Index) + 2 * sizeof(std::uint32_t)));
  for (BodyWay& way : ways) {
    in.value(way.body);
    way.start = read_places(in);
    way.keyframes.resize(in.count(sizeof(double) + sizeof(std::uint32_t)));
    for (body::Keyframe& keyframe : way.keyframes) {
      in.value(keyframe.at);
      keyframe.vertices = read_places(in);
    }
  }
  return ways;
}

bool in_order(const Motion& motion) {
  return std::adjacent_find(motion.frames.begin(), motion.frames.end(),
                            [](const FilmFrame& a, const FilmFrame& b) {
                              return !(a.step < b.step && a.time < b.time);
                            }) == motion.frames.end();
}

Result<Motion> read_motion(StateReader& in) {
  Motion motion;
  in.value(motion.grid.origin);
  in.value(motion.grid.step);
  in.value(motion.stride);
  const std::size_t count = in.count(sizeof(std::uint32_t));
  for (std::size_t i = 0; i < count && in.ok(); ++i) {
    std::string message;
    in.value(message);
    const std::span<const std::int16_t> before =
        i == 0 ? std::span<const std::int16_t>() : motion.frames.back().grid;
    auto frame = proto::decode_frame(message, before);
    if (!frame || frame->key != (i == 0) || frame->header.step < 0) return damaged();
    motion.frames.push_back({frame->header.step, frame->header.time, std::move(frame->grid), 0});
  }
  const bool sound = is_finite(motion.grid.origin) && length(motion.grid.origin) < kFarthest / 2 &&
                     motion.grid.step > 0 && motion.grid.step < 1e-2 && motion.stride > 0;
  if (!in.ok() || !sound || !in_order(motion)) return damaged();
  return motion;
}

bool sound_positions(std::span<const Vec3> positions) {
  return std::all_of(positions.begin(), positions.end(), [](Vec3 p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <=
           kFarthest;  // false for what is no number
  });
}

bool sound_mesh(const geometry::TriangleMesh& mesh) {
  const auto known = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(); };
  return sound_positions(mesh.vertices) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const Tri& t) { return std::all_of(t.begin(), t.end(), known); });
}

/// Pieces follow each other and hold all vertices.
Status fill_garment(proto::DecodedTopology topology, Film& film) {
  sewing::GarmentMesh& garment = film.garment;
  garment.rest = std::move(topology.rest);
  garment.triangles = std::move(topology.triangles);
  garment.sewn = std::move(topology.sewn);
  film.pieces = std::move(topology.pieces);
  for (const proto::StreamPiece& piece : film.pieces) {
    if (piece.first_vertex != static_cast<Index>(garment.panel_of_vertex.size())) return damaged();
    const auto panel = static_cast<Index>(garment.first_vertex.size());
    garment.first_vertex.push_back(piece.first_vertex);
    garment.panel_of_vertex.resize(
        static_cast<std::size_t>(piece.first_vertex) + static_cast<std::size_t>(piece.vertex_count), panel);
  }
  if (garment.panel_of_vertex.size() != garment.rest.size()) return damaged();
  garment.first_vertex.push_back(garment.vertex_count());
  for (const Tri& t : garment.triangles) garment.panel_of_triangle.push_back(garment.panel_of_vertex[t[0]]);
  garment.weld = sewing::least_of_class(garment.vertex_count(), garment.sewn);
  return {};
}

bool sound_way(const BodyWay& way, const Film& film) {
  if (way.body < 0 || static_cast<std::size_t>(way.body) >= film.bodies.size() || way.keyframes.empty())
    return false;
  const std::size_t count = film.bodies[static_cast<std::size_t>(way.body)].vertices.size();
  double since = 0;
  for (const body::Keyframe& keyframe : way.keyframes) {
    const bool later = keyframe.at > std::exchange(since, keyframe.at) && keyframe.at <= kLongest;
    if (!later || keyframe.vertices.size() != count || !sound_positions(keyframe.vertices)) return false;
  }
  return way.start.size() == count && sound_positions(way.start);
}

Status check_film(const Film& film) {
  const std::size_t count = film.garment.rest.size();
  const bool whole = film.end.size() == count && sound_positions(film.end) &&
                     std::all_of(film.bodies.begin(), film.bodies.end(), sound_mesh) &&
                     std::all_of(film.ways.begin(), film.ways.end(),
                                 [&](const BodyWay& way) { return sound_way(way, film); }) &&
                     std::all_of(film.motion.frames.begin(), film.motion.frames.end(),
                                 [&](const FilmFrame& frame) { return frame.grid.size() == 3 * count; });
  return whole ? Status() : damaged();
}

}  // namespace

std::string encode_motion(const Motion& motion) {
  StateWriter out;
  write(out, motion);
  write_times(out, motion);
  return out.take();
}

Result<Motion> decode_motion(std::string_view bytes) {
  StateReader in(bytes);
  Motion motion = TRY(read_motion(in));
  TRY(read_times(in, motion));
  if (!in.ok() || !in.at_end()) return damaged();
  return motion;
}

std::string encode_film(const Film& film) {
  StateWriter out;
  out.raw(kMagic);
  out.value(film.ways.empty() ? kStandingStill : kFilmVersion);
  out.value(proto::encode_topology(kEpoch, film.motion.grid, film.garment, film.pieces));
  out.value(film.end);
  out.size(film.bodies.size());
  for (const geometry::TriangleMesh& body : film.bodies) write(out, body);
  write(out, film.textures);
  write(out, film.looks);
  write(out, film.motion);
  if (!film.ways.empty()) {
    write_ways(out, film);
    write_times(out, film.motion);
  }
  out.raw(hash_of(std::string_view(out.bytes())));
  return out.take();
}

Result<Film> decode_film(std::string_view bytes) {
  const std::size_t head = kMagic.size() + sizeof(kFilmVersion);
  if (bytes.size() < head + kHashDigits || !bytes.starts_with(kMagic)) return damaged();
  StateReader in(bytes.substr(kMagic.size(), bytes.size() - kMagic.size() - kHashDigits));
  std::uint32_t version = 0;
  in.value(version);
  if (version < kWithoutLooks || version > kFilmVersion)
    return Error{"film.version", "the film is of another version of this program; drape anew", "",
                 ErrorKind::kInput};
  const std::string_view all = bytes.substr(0, bytes.size() - kHashDigits);
  if (hash_of(all) != bytes.substr(all.size())) return damaged();
  Film film;
  std::string message;
  in.value(message);
  auto topology = proto::decode_topology(message);
  if (!topology) return damaged();
  TRY(fill_garment(std::move(topology).value(), film));
  in.value(film.end);
  film.bodies.resize(in.count(2 * sizeof(std::uint32_t)));
  for (geometry::TriangleMesh& body : film.bodies) body = read_mesh(in);
  film.textures = TRY(read_textures(in));
  if (version != kWithoutLooks) film.looks = TRY(read_looks(in));
  film.motion = TRY(read_motion(in));
  if (version > kStandingStill) {
    film.ways = read_ways(in);
    TRY(read_times(in, film.motion));
  }
  if (!in.ok() || !in.at_end()) return damaged();
  TRY(check_film(film));
  return film;
}

}  // namespace toile::movie
