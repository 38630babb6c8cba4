#include "server/app/read_film.h"

#include <system_error>
#include <utility>

#include "core/base/read_file.h"
#include "proto/cpp/trace_file.h"
#include "server/movie/film_codec.h"
#include "server/movie/film_recorder.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

/// A trace is shown whole, as far as memory goes.
constexpr movie::MotionLimits kOfTrace{.frames = 100'000, .bytes = std::size_t{1} << 30};

/// Records the frames and remembers the cloth.
class TraceReader final : public drape::FrameSink {
 public:
  void begin(const sewing::GarmentMesh& garment) override {
    garment_ = garment;
    recorder_.begin(garment);
  }
  void frame(const drape::Frame& frame) override {
    recorder_.frame(frame);
    end_ = frame.positions;
  }
  movie::Film film() && {
    movie::Film film;
    const Index count = garment_.vertex_count();
    film.garment = std::move(garment_);
    film.garment.panel_of_vertex.assign(static_cast<std::size_t>(count), 0);
    film.garment.panel_of_triangle.assign(film.garment.triangles.size(), 0);
    film.garment.first_vertex = {0, count};
    film.garment.rest.clear();  // not in a trace
    film.pieces = {{"cloth", 0, count, render::kClothColour}};
    film.end = std::move(end_);
    film.motion = recorder_.motion();
    return film;
  }

 private:
  sewing::GarmentMesh garment_;
  std::vector<Vec3> end_;
  movie::FilmRecorder recorder_{kOfTrace};
};

Result<movie::Film> film_of_trace(const fs::path& path) {
  TraceReader reader;
  TRY(proto::read_trace(path, reader));
  movie::Film film = std::move(reader).film();
  if (film.motion.frames.empty()) return Error{"trace.damaged", "the trace has no frames", path.string()};
  return film;
}

}  // namespace

Result<movie::Film> read_film(fs::path path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) path /= movie::kFilmFile;
  const std::optional<std::string> bytes = read_file(path);
  if (!bytes)
    return Error{"usage.film", "cannot read the film that toile drape leaves; drape anew", path.string()};
  if (bytes->starts_with(proto::kTraceMagic)) return film_of_trace(path);
  Result<movie::Film> film = movie::decode_film(*bytes);
  if (!film) return placed_at(film.error(), path.string());
  return film;
}

Result<movie::Motion> read_motion(const fs::path& trace) {
  movie::Film film = TRY(film_of_trace(trace));
  return std::move(film.motion);
}

}  // namespace toile::app
