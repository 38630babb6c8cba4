#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/base/write_file.h"
#include "core/exports/model_file.h"
#include "core/json/tree.h"
#include "core/mesh/vertex_normals.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/read_film.h"
#include "server/movie/film.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<double, 3> kBodyColour{0.55, 0.52, 0.49};  // linear, as in final.glb

Result<const exports::ModelFormat*> model_format_of(const std::string& file) {
  const std::string ending = lower_case(fs::path(file).extension().string());
  if (!ending.empty())
    if (const auto* format = exports::model_format_named(ending.substr(1))) return format;
  std::string all;
  for (const exports::ModelFormat& format : exports::model_formats())
    all += std::string(all.empty() ? "." : ", .") + format.ending;
  return Error{"export.format", "the file's name tells the format; it ends in one of " + all, file};
}

double units_per_metre(const ExportOptions& options, const exports::ModelFormat& format) {
  if (options.unit.empty()) return format.units_per_metre;
  return options.unit == "m" ? 1 : options.unit == "cm" ? 100 : 1000;
}

Result<std::vector<Vec3>> cloth_at(const movie::Film& film, const ExportOptions& options) {
  if (!options.at) return film.end;
  const std::vector<movie::FilmFrame>& frames = film.motion.frames;
  if (frames.empty())
    return Error{"export.no_motion", "this film has no frames, only an end", options.source};
  const double last = static_cast<double>(frames.back().time);
  if (*options.at >= 0 && *options.at <= last) return movie::positions_at(film.motion, *options.at);
  return Error{"export.time", "the drape lasts from 0 to " + fixed_text(last, 3) + " s", "--at"};
}

/// Each piece by itself. Normals run smoothly across seams all the same.
std::vector<exports::ModelPart> pieces_of(const movie::Film& film, const std::vector<Vec3>& cloth) {
  const sewing::GarmentMesh& garment = film.garment;
  const std::vector<Vec3> normals = mesh::vertex_normals(cloth, garment.triangles, garment.weld);
  std::vector<exports::ModelPart> parts;
  for (const proto::StreamPiece& piece : film.pieces) {
    exports::ModelPart part;
    part.name = piece.id;
    part.colour = piece.colour;
    const auto first = static_cast<std::ptrdiff_t>(piece.first_vertex),
               count = std::ptrdiff_t{piece.vertex_count};
    part.positions.assign(cloth.begin() + first, cloth.begin() + first + count);
    part.normals.assign(normals.begin() + first, normals.begin() + first + count);
    if (!garment.rest.empty())
      part.coordinates.assign(garment.rest.begin() + first, garment.rest.begin() + first + count);
    parts.push_back(std::move(part));
  }
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const auto p = static_cast<std::size_t>(garment.panel_of_triangle[t]);
    Tri triangle = garment.triangles[t];
    for (Index& v : triangle) v -= film.pieces[p].first_vertex;
    parts[p].triangles.push_back(triangle);
  }
  return parts;
}

/// The whole cloth as one surface, in which sewn vertices are one.
exports::ModelPart welded(const movie::Film& film, const std::vector<Vec3>& cloth) {
  const sewing::GarmentMesh& garment = film.garment;
  const std::vector<Vec3> normals = mesh::vertex_normals(cloth, garment.triangles, garment.weld);
  exports::ModelPart part;
  part.name = "garment";
  if (!film.pieces.empty()) part.colour = film.pieces.front().colour;
  std::vector<Index> place(cloth.size(), kNone);
  const auto placed = [&](Index v) {
    const Index least = garment.weld.empty() ? v : garment.weld[static_cast<std::size_t>(v)];
    Index& at = place[static_cast<std::size_t>(least)];
    if (at != kNone) return at;
    at = static_cast<Index>(part.positions.size());
    part.positions.push_back(cloth[static_cast<std::size_t>(least)]);
    part.normals.push_back(normals[static_cast<std::size_t>(least)]);
    return at;
  };
  for (const Tri& t : garment.triangles) {
    const Tri triangle{placed(t[0]), placed(t[1]), placed(t[2])};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    part.triangles.push_back(triangle);
  }
  return part;
}

Result<std::vector<exports::ModelPart>> parts_of(const ExportOptions& options) {
  const movie::Film film = TRY(read_film(options.source));
  const std::vector<Vec3> cloth = TRY(cloth_at(film, options));
  std::vector<exports::ModelPart> parts;
  if (options.welded) {
    parts.push_back(welded(film, cloth));
  } else {
    parts = pieces_of(film, cloth);
  }
  if (!options.body) return parts;
  const std::vector<geometry::TriangleMesh> bodies =
      options.at ? movie::bodies_at(film, movie::played_at(film.motion, *options.at)) : film.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const geometry::TriangleMesh& mesh = bodies[b];
    exports::ModelPart part;
    part.name = "body" + (b == 0 ? std::string() : std::to_string(b + 1));
    part.colour = kBodyColour;
    part.positions = mesh.vertices;
    part.triangles = mesh.triangles;
    part.normals = mesh::vertex_normals(part.positions, part.triangles);
    parts.push_back(std::move(part));
  }
  return parts;
}

Result<std::vector<std::string>> write_all(const ExportOptions& options) {
  const exports::ModelFormat* format = TRY(model_format_of(options.out));
  const fs::path out = options.out;
  const std::vector<exports::ModelPart> parts = TRY(parts_of(options));
  const auto files =
      TRY(exports::model_files(parts, *format, out.stem().string(), units_per_metre(options, *format)));
  std::vector<std::string> written;
  for (const exports::ModelFile& file : files) {
    // The first by the name that was told, however that spells its ending.
    const fs::path path = written.empty() ? out : out.parent_path() / file.name;
    TRY(write_file(path, file.bytes));
    written.push_back(path.string());
  }
  return written;
}

}  // namespace

ExitCode export_command(const ExportOptions& options) {
  const Result<std::vector<std::string>> written = write_all(options);
  if (!written) return fail(written.error(), options.json);
  if (options.json) {
    std::vector<json::JsonValue> files(written->begin(), written->end());
    std::printf("%s", json::write_json(std::vector<json::JsonMember>{{"files", std::move(files)}}).c_str());
    return kDone;
  }
  for (const std::string& file : *written) std::printf("%s\n", file.c_str());
  return kDone;
}

}  // namespace toile::app
