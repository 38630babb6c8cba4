// CPU time that the mesh of one flat piece takes, by particle distance:
//   bench_triangulate

#include <benchmark/benchmark.h>

#include <vector>

#include "core/mesh/triangulate.h"

namespace toile {
namespace {

/// A sheet of 1.0 m by 0.98 m whose border points lie `step` m apart.
mesh::Polygon sheet(double step) {
  const std::vector<Vec2> corners{{0, 0}, {1, 0}, {1, 0.98}, {0, 0.98}};
  mesh::Polygon border;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = corners[i], to = corners[(i + 1) % corners.size()];
    const int parts = static_cast<int>(length(to - from) / step);
    for (int k = 0; k < parts; ++k) border.push_back(from + (double(k) / parts) * (to - from));
  }
  return border;
}

void mesh_a_sheet(benchmark::State& state) {
  const double step = 1e-3 * static_cast<double>(state.range(0));
  const std::vector<mesh::Polygon> loops{sheet(step)};
  std::size_t particles = 0;
  for (auto _ : state) {
    const Result<mesh::FlatMesh> made = mesh::triangulate(loops, step, {});
    if (!made) return state.SkipWithError("not made");
    particles = made->points.size();
  }
  state.counters["particles"] = static_cast<double>(particles);
}
BENCHMARK(mesh_a_sheet)->ArgName("mm")->Arg(30)->Arg(15)->Arg(7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toile

BENCHMARK_MAIN();
