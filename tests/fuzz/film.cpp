// Films of drapes (proto/film.md).

#include "server/movie/film_codec.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/sealed.h"
#include "tests/server/movie/napkin_film.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  return {unsealed(movie::encode_film(test::napkin_film())),
          unsealed(movie::encode_film(test::napkin_film(1)))};
}

void try_input(std::string_view bytes) {
  const std::string file = sealed(bytes);
  const Result<movie::Film> film = movie::decode_film(file);
  if (!film) {
    expect(film.error().code.starts_with("film."), "a file that is refused is told to be no film");
    return;
  }
  const std::size_t count = film->garment.rest.size();
  expect(film->end.size() == count, "every vertex has its end");
  for (const movie::FilmFrame& frame : film->motion.frames)
    expect(frame.grid.size() == 3 * count, "every frame holds every vertex");
  expect(movie::decode_film(movie::encode_film(*film)).ok(), "what is written is read again");
}

}  // namespace toile::fuzz
