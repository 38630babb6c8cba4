#pragma once
// A square of cloth of two triangles that sinks, over a tetrahedron: the least that a film can show.

#include <vector>

#include "core/drape/drape_result.h"
#include "server/movie/film_recorder.h"

namespace toile::test {

inline sewing::GarmentMesh square() {
  sewing::GarmentMesh garment;
  garment.rest = {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
  garment.triangles = {{0, 1, 2}, {0, 2, 3}};
  garment.panel_of_vertex = {0, 0, 0, 0};
  garment.panel_of_triangle = {0, 0};
  garment.first_vertex = {0, 4};
  garment.weld = {0, 1, 2, 3};
  return garment;
}

/// `step` substeps after the start, a millimetre lower for each 50.
inline drape::Frame sunk(int step) {
  const double y = 1 - 1e-3 * step / 50;
  return {step, step / 3000.0, "drape", {{0, y, 0}, {0.5, y, 0}, {0.5, y, 0.5}, {0, y, 0.5}}};
}

inline movie::Film napkin_film(int frames = 10) {
  movie::FilmRecorder recorder;
  recorder.begin(square());
  for (int i = 0; i < frames; ++i) recorder.frame(sunk(50 * i));
  movie::Film film;
  film.garment = square();
  film.pieces = {{"napkin", 0, 4, {0.5, 0.1, 0.1}}};
  film.end = sunk(50 * (frames - 1)).positions;
  film.bodies = {{{{0.2, 0, 0.2}, {0.3, 0, 0.2}, {0.2, 0, 0.3}, {0.2, 0.1, 0.2}},
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}}};
  film.motion = recorder.motion();
  return film;
}

}  // namespace toile::test
