#include "server/jobs/end_bodies.h"

#include "server/movie/film_codec.h"

namespace toile::jobs {

bool has_end_bodies(const store::JobRow& job) { return job.results.contains(movie::kFilmFile); }

Result<std::vector<geometry::TriangleMesh>> end_bodies(store::Store& store,
                                                       const store::RequestContext& context,
                                                       const store::JobRow& job) {
  const std::string bytes = TRY(store.result_bytes(context, job.id, movie::kFilmFile));
  movie::Film film = TRY(movie::decode_film(bytes));
  return std::move(film.bodies);
}

}  // namespace toile::jobs
