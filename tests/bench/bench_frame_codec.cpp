// Sizes and times of the stream's frames over a drape's trace (toile drape … --trace FILE), or over a waving
// sheet when no trace is given:
//   bench_frame_codec [FILE]
// One line a quantity. Times are the least of several runs, on one core.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
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
  if (bytes.size() < 24 || !bytes.starts_with(kTraceMagic)) return moves;
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

/// Microseconds that `work` takes a frame, over all frames; the least of nine rounds.
double microseconds(std::size_t frames, const std::function<void(std::size_t)>& work) {
  double least = 1e300;
  for (int round = 0; round < 9; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t f = 1; f < frames; ++f) work(f);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count() / static_cast<double>(frames - 1));
  }
  return least;
}

void print_sizes(const char* what, const std::vector<std::string>& messages) {
  std::vector<std::size_t> sizes;
  for (std::size_t f = 1; f < messages.size(); ++f) sizes.push_back(messages[f].size());
  std::sort(sizes.begin(), sizes.end());
  const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  std::printf("%-10s bytes: mean %.0f, median %zu, most %zu\n", what, sum / static_cast<double>(sizes.size()),
              sizes[sizes.size() / 2], sizes.back());
}

FrameGrid grid_of(const Moves& moves) {
  const Aabb3 box = bounding_box(moves.frames[0]);
  return grid_for(box.low, box.high);
}

void measure(const Moves& moves) {
  const FrameGrid grid = grid_of(moves);
  const std::size_t count = moves.frames.size();
  std::vector<std::vector<std::int16_t>> numbers(count);
  std::vector<std::string> keys(count), deltas(count);
  std::printf("%zu frames of %zu vertices, grid %g mm\n", count, moves.frames[0].size(), grid.step * 1e3);
  const double quantising =
      microseconds(count, [&](std::size_t f) { numbers[f] = quantise(moves.frames[f], grid); });
  numbers[0] = quantise(moves.frames[0], grid);
  const double key = microseconds(count, [&](std::size_t f) { keys[f] = encode_key({}, numbers[f]); });
  const double delta =
      microseconds(count, [&](std::size_t f) { deltas[f] = encode_delta({}, numbers[f], numbers[f - 1]); });
  bool same = true;
  const double decoding = microseconds(count, [&](std::size_t f) {
    same = same && decode_frame(deltas[f], numbers[f - 1])->grid == numbers[f];
  });
  GarmentMesh garment;
  for (const Vec3& p : moves.frames[0]) garment.rest.push_back({p.x, p.y});
  garment.triangles = moves.triangles;
  print_sizes("key", keys);
  print_sizes("delta", deltas);
  std::printf("topology   bytes: %zu (%zu triangles, no sewn pairs)\n",
              encode_topology(1, grid, garment, {}).size(), moves.triangles.size());
  std::printf("time       µs: quantise %.1f, encode key %.1f, encode delta %.1f, decode delta %.1f%s\n",
              quantising, key, delta, decoding, same ? "" : "  WRONG: decoded frames differ");
}

}  // namespace
}  // namespace toile

int main(int argc, char** argv) {
  const toile::Moves moves = argc > 1 ? toile::read_trace(argv[1]) : toile::waving_sheet();
  if (moves.frames.size() < 2 || moves.frames[0].empty()) {
    std::fprintf(stderr, "%s: no trace of two frames or more\n", argv[1]);
    return 2;
  }
  toile::measure(moves);
}
