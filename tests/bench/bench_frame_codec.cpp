// Sizes and times of the stream's frames over a drape's trace (toile drape … --trace FILE), or over a waving
// sheet when no trace is given:
//   bench_frame_codec [FILE]
// One line a quantity; options of Google Benchmark are taken (--benchmark_repetitions=9).

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/aabb.h"
#include "proto/cpp/frame_codec.h"
#include "proto/cpp/trace_file.h"

namespace toile {
namespace {

struct Moves {
  std::vector<Tri> triangles;
  std::vector<std::vector<Vec3>> frames;
};

template <typename T>
T number_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// Layout: proto/trace.md. Empty when the file is none.
Moves read_trace(const char* path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Moves moves;
  if (bytes.size() < 24 || !bytes.starts_with(proto::kTraceMagic)) return moves;
  const std::size_t vertices = number_at<std::uint32_t>(bytes, 12);
  const std::size_t first_frame = 24 + 12 * std::size_t{number_at<std::uint32_t>(bytes, 16)};
  for (std::size_t t = 24; t + 12 <= std::min(first_frame, bytes.size()); t += 12) {
    moves.triangles.push_back(
        {number_at<Index>(bytes, t), number_at<Index>(bytes, t + 4), number_at<Index>(bytes, t + 8)});
  }
  for (std::size_t at = first_frame; at + 16 + 12 * vertices <= bytes.size(); at += 16 + 12 * vertices) {
    auto& frame = moves.frames.emplace_back(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      const std::size_t p = at + 16 + 12 * v;
      frame[v] = {number_at<float>(bytes, p), number_at<float>(bytes, p + 4), number_at<float>(bytes, p + 8)};
    }
  }
  return moves;
}

/// A sheet of 64 × 64 vertices under travelling waves.
Moves waving_sheet() {
  Moves moves;
  for (int f = 0; f < 100; ++f) {
    auto& frame = moves.frames.emplace_back();
    for (int i = 0; i < 64 * 64; ++i) {
      const double x = 0.01 * (i % 64), y = 0.01 * (i / 64), t = f / 60.0;
      frame.push_back({x, 1 + y, 0.05 * std::sin(9 * x + 5 * t) * std::cos(7 * y - 3 * t)});
    }
  }
  return moves;
}

void print_sizes(const char* what, const std::vector<std::string>& messages) {
  std::vector<std::size_t> sizes;
  for (std::size_t f = 1; f < messages.size(); ++f) sizes.push_back(messages[f].size());
  std::sort(sizes.begin(), sizes.end());
  const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  std::printf("%-10s bytes: mean %.0f, median %zu, most %zu\n", what, sum / static_cast<double>(sizes.size()),
              sizes[sizes.size() / 2], sizes.back());
}

proto::FrameGrid grid_of(const Moves& moves) {
  const Aabb3 box = bounding_box(moves.frames[0]);
  return proto::grid_for(box.low, box.high);
}

/// The frames on their grid, and as messages.
struct Encoded {
  proto::FrameGrid grid;
  std::vector<std::vector<std::int16_t>> numbers;
  std::vector<std::string> keys, deltas;  ///< the first delta is empty
};

Encoded encode(const Moves& moves) {
  Encoded all{grid_of(moves), {}, {}, {}};
  for (const std::vector<Vec3>& frame : moves.frames) {
    all.numbers.push_back(proto::quantise(frame, all.grid));
    all.keys.push_back(proto::encode_key({}, all.numbers.back()));
    const bool first = all.numbers.size() == 1;
    all.deltas.push_back(first ? "" : proto::encode_delta({}, all.numbers.back(), all.numbers.end()[-2]));
  }
  return all;
}

/// Every frame but the first is `work`ed on in turn; times are of one frame.
template <typename Work>
void each_frame(benchmark::State& state, std::size_t frames, Work work) {
  std::size_t f = 0;
  for (auto _ : state) {
    f = f % (frames - 1) + 1;
    benchmark::DoNotOptimize(work(f));
  }
}

void register_times(const Moves& moves, const Encoded& all) {
  const std::size_t count = moves.frames.size();
  benchmark::RegisterBenchmark("quantise", [&, count](benchmark::State& state) {
    each_frame(state, count, [&](std::size_t f) { return proto::quantise(moves.frames[f], all.grid); });
  });
  benchmark::RegisterBenchmark("encode_key", [&, count](benchmark::State& state) {
    each_frame(state, count, [&](std::size_t f) { return proto::encode_key({}, all.numbers[f]); });
  });
  benchmark::RegisterBenchmark("encode_delta", [&, count](benchmark::State& state) {
    each_frame(state, count,
               [&](std::size_t f) { return proto::encode_delta({}, all.numbers[f], all.numbers[f - 1]); });
  });
  benchmark::RegisterBenchmark("decode_delta", [&, count](benchmark::State& state) {
    each_frame(state, count,
               [&](std::size_t f) { return proto::decode_frame(all.deltas[f], all.numbers[f - 1]).ok(); });
  });
}

void print_all_sizes(const Moves& moves, const Encoded& all) {
  std::printf("%zu frames of %zu vertices, grid %g mm\n", moves.frames.size(), moves.frames[0].size(),
              all.grid.step * 1e3);
  print_sizes("key", all.keys);
  print_sizes("delta", all.deltas);
  sewing::GarmentMesh garment;
  for (const Vec3& p : moves.frames[0]) garment.rest.push_back({p.x, p.y});
  garment.triangles = moves.triangles;
  std::printf("topology   bytes: %zu (%zu triangles, no sewn pairs)\n",
              proto::encode_topology(1, all.grid, garment, {}).size(), moves.triangles.size());
}

}  // namespace
}  // namespace toile

int main(int count, char** words) {
  benchmark::Initialize(&count, words);
  const toile::Moves moves = count > 1 ? toile::read_trace(words[1]) : toile::waving_sheet();
  if (moves.frames.size() < 2 || moves.frames[0].empty()) {
    std::fprintf(stderr, "%s: no trace of two frames or more\n", words[1]);
    return 2;
  }
  const toile::Encoded all = toile::encode(moves);
  toile::print_all_sizes(moves, all);
  toile::register_times(moves, all);
  benchmark::RunSpecifiedBenchmarks();
}
