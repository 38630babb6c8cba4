// CPU time that a mannequin takes, by size and number of triangles:
//   bench_mannequin [--benchmark_filter=eu38 …]

#include <benchmark/benchmark.h>

#include <string>

#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"

namespace toile {
namespace {

void make_one(benchmark::State& state, const mannequin::BodyPreset& preset) {
  mannequin::MannequinSettings settings;
  settings.sex = preset.sex;
  settings.asked = preset.measures();
  settings.triangle_count = static_cast<Index>(state.range(0));
  for (auto _ : state) {
    if (!mannequin::make_mannequin(settings)) return state.SkipWithError("not made");
  }
}

}  // namespace
}  // namespace toile

int main(int count, char** words) {
  using namespace toile;
  for (const std::string size : {"eu38", "eu48", "m50", "child116"}) {
    benchmark::RegisterBenchmark(size.c_str(), make_one, *mannequin::find_preset(size))
        ->ArgName("triangles")
        ->Arg(2204)
        ->Arg(3304)
        ->Arg(4562)
        ->Arg(5624)
        ->Arg(20000)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
