// Writes the golden messages of proto/fixtures/frames: what each says goes into frames.json, its bytes into a
// file beside it. To be run by hand when the wire format changes, and never to make a test pass:
//   make_golden_frames proto/fixtures/frames

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/write_file.h"
#include "core/json/tree.h"
#include "proto/cpp/frame_codec.h"

namespace toile {
namespace {

using Numbers = std::vector<std::int16_t>;
using Members = std::vector<json::JsonMember>;
using Elements = std::vector<json::JsonValue>;

struct FrameCase {
  std::string name;
  bool key = true;
  proto::FrameHeader header;
  Numbers before, grid;
};

struct TopologyCase {
  std::string name;
  std::uint32_t epoch = 1;
  proto::FrameGrid grid;
  sewing::GarmentMesh garment;
  std::vector<proto::StreamPiece> pieces;
};

/// A message that must be refused.
struct RefusedCase {
  std::string why, code, bytes;
  std::size_t numbers_before = 0;  ///< length of the frame that the reader holds
};

std::int16_t wrapped(int number) {
  return std::bit_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<unsigned>(number)));
}

/// Three numbers for each of `vertices` vertices.
Numbers numbers_of(int vertices, const std::function<int(int vertex, int axis)>& number) {
  Numbers numbers;
  for (int v = 0; v < vertices; ++v) {
    for (int a = 0; a < 3; ++a) numbers.push_back(wrapped(number(v, a)));
  }
  return numbers;
}

/// Noise over all of int16: a linear congruential generator with the multiplier of C's old rand.
Numbers noise(int vertices, std::uint32_t seed) {
  std::uint32_t state = seed;
  return numbers_of(vertices, [&](int, int) {
    state = state * 1103515245u + 12345u;
    return static_cast<int>(state >> 16);
  });
}

std::vector<FrameCase> frame_cases() {
  const Numbers curve = numbers_of(37, [](int v, int a) { return 100 * a + 7 * v + v * v / (a + 1) - 400; });
  const Numbers moved =
      numbers_of(37, [](int v, int a) { return 100 * a + 8 * v + v * v / (a + 1) - 380 - v / 5; });
  const Numbers leapt = numbers_of(37, [](int v, int a) { return v % 3 == a ? 32767 - v : -32768 + 2 * v; });
  // One width a group: the numbers of group w stand 2^w apart around zero, so that their codes need w bits.
  const Numbers widths = numbers_of(17 * 16, [](int v, int a) {
    const int w = v / 16, top = w == 0 ? 0 : 1 << (w - 1);
    return (v + a) % 2 == 0 ? -top : (top == 0 ? 0 : top - 1);
  });
  const Numbers two = {100, -250, 3, 101, -250, 5};
  const Numbers two_later = {99, -252, 3, 101, -250, 5};
  return {
      {"example_key", true, {1, 1, 0, 0.0f}, {}, two},
      {"example_delta", false, {1, 2, 50, 0.25f}, two, two_later},
      {"key_curve", true, {1, 31, 1500, 0.5f}, {}, curve},
      {"delta_curve", false, {1, 32, 1550, 0.515625f}, curve, moved},
      {"delta_still", false, {2, 33, 1600, 0.53125f}, moved, moved},
      {"delta_leaps", false, {2, 34, 1650, 0.1f}, moved, leapt},
      {"delta_leaps_back", false, {2, 35, 1700, 0.2f}, leapt, moved},
      {"key_noise", true, {4294967295u, 4294967295u, -1, 1e6f}, {}, noise(40, 1)},
      {"delta_noise", false, {7, 8, 2147483647, 3.5f}, noise(40, 1), noise(40, 2)},
      {"key_widths", true, {1, 1, 0, 0.0f}, {}, widths},
      {"key_one_group", true, {1, 1, 0, 0.0f}, {}, noise(16, 3)},
      {"key_one_vertex", true, {1, 1, 0, 0.0f}, {}, {-32768, 32767, 0}},
      {"key_empty", true, {1, 1, 0, 0.0f}, {}, {}},
  };
}

/// A strip of `columns` squares in two pieces, the second with its vertices in falling order along the seam.
TopologyCase strip(int columns) {
  TopologyCase strip{.name = "topology_strip",
                     .epoch = 3,
                     .grid = {.origin = {0.25, 1.125, -0.1}, .step = 0.00012},
                     .garment = {},
                     .pieces = {}};
  const Index per_piece = 2 * (columns + 1);
  for (Index piece = 0; piece < 2; ++piece) {
    const Index first = piece * per_piece;
    for (Index c = 0; c <= columns; ++c) {
      strip.garment.rest.push_back({0.1 * c, 0.5 * piece});
      strip.garment.rest.push_back({0.1 * c, 0.5 * piece + 0.3});
    }
    for (Index c = 0; c < columns; ++c) {
      const Index v = first + 2 * c;
      strip.garment.triangles.push_back({v, v + 2, v + 1});
      strip.garment.triangles.push_back({v + 1, v + 2, v + 3});
    }
  }
  for (Index c = 0; c <= columns; ++c) strip.garment.sewn.push_back({2 * c, 2 * per_piece - 1 - 2 * c});
  strip.pieces = {{"front", 0, per_piece, {0.2, 0.4, 0.8}},
                  {"Rückenteil", per_piece, per_piece, {1, 0.5, 0.0625}}};
  return strip;
}

std::vector<TopologyCase> topology_cases() {
  TopologyCase example{.name = "example_topology",
                       .epoch = 1,
                       .grid = {.origin = {0, 1, 0}, .step = 0.0001},
                       .garment = {},
                       .pieces = {{"a", 0, 4, {1, 0.5, 0.25}}}};
  example.garment.rest = {{0, 0}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}};
  example.garment.triangles = {{0, 1, 2}, {1, 3, 2}};
  example.garment.sewn = {{0, 3}};
  TopologyCase bare{.name = "topology_bare", .epoch = 1, .grid = {}, .garment = {}, .pieces = {}};
  return {example, strip(40), bare};
}

/// `bytes` with those from `at` on replaced.
std::string patched(std::string bytes, std::size_t at, const std::string& by) {
  return bytes.replace(at, by.size(), by);
}

std::string bytes_of(const FrameCase& c) {
  return c.key ? proto::encode_key(c.header, c.grid) : proto::encode_delta(c.header, c.grid, c.before);
}
std::string bytes_of(const TopologyCase& c) {
  return proto::encode_topology(c.epoch, c.grid, c.garment, c.pieces);
}

std::vector<RefusedCase> refused_frames() {
  const auto cases = frame_cases();
  const std::string key = bytes_of(cases[0]), delta = bytes_of(cases[1]),
                    topology = bytes_of(topology_cases()[0]);
  const std::string none = "frame.malformed";
  return {
      {"no bytes", none, ""},
      {"seven bytes", none, key.substr(0, 7)},
      {"another magic", none, patched(key, 0, "RL")},
      {"version 2", "frame.version", patched(key, 2, "\x02")},
      {"type 0", none, patched(key, 3, std::string(1, '\0'))},
      {"type 4", none, patched(key, 3, "\x04")},
      {"a topology", none, topology},
      {"a header cut off", none, key.substr(0, 23)},
      {"heads cut off", none, key.substr(0, 26)},
      {"a body cut off", none, key.substr(0, key.size() - 1)},
      {"a byte too many", none, key + "x"},
      {"a width of 17 bits", none, patched(key, 24, "\x11")},
      {"an unknown flag in a head", none, patched(key, 24, "\x48")},
      {"four billion vertices", none, patched(key, 20, "\xff\xff\xff\xff")},
      {"no vertices, but blocks", none, patched(key, 20, std::string(4, '\0'))},
      {"a time that is no number", none, patched(key, 16, std::string("\x00\x00\xc0\x7f", 4))},
      {"an endless time", none, patched(key, 16, std::string("\x00\x00\x80\x7f", 4))},
      {"a delta without a base", "frame.wrong_base", delta, 0},
      {"a delta on a longer base", "frame.wrong_base", delta, 9},
      {"a broken delta on a wrong base", none, delta + "x", 9},
  };
}

std::vector<RefusedCase> refused_topologies() {
  const std::string whole = bytes_of(topology_cases()[0]), none = "frame.malformed";
  const std::size_t rest = 56, piece = rest + 4 * 8, triangles = piece + 8 + 12 + 2;
  const std::string infinite("\x00\x00\x80\x7f", 4);
  return {
      {"no bytes", none, ""},
      {"version 0", "frame.version", patched(whole, 2, std::string(1, '\0'))},
      {"a key frame", none, bytes_of(frame_cases()[0])},
      {"a header cut off", none, whole.substr(0, 55)},
      {"rest positions cut off", none, whole.substr(0, rest + 9)},
      {"triangles cut off", none, whole.substr(0, whole.size() - 3)},
      {"the last byte cut off", none, whole.substr(0, whole.size() - 1)},
      {"a byte too many", none, whole + std::string(1, '\0')},
      {"a step of zero", none, patched(whole, 32, std::string(8, '\0'))},
      {"a step below zero", none, patched(whole, 39, "\xbf")},
      {"an origin that is no number", none, patched(whole, 14, "\xf8\x7f")},
      {"an endless rest position", none, patched(whole, rest + 4, infinite)},
      {"an endless colour", none, patched(whole, piece + 8, infinite)},
      {"four billion vertices", none, patched(whole, 40, "\xff\xff\xff\xff")},
      {"four billion triangles", none, patched(whole, 44, "\xff\xff\xff\xff")},
      {"four billion pieces", none, patched(whole, 48, "\xff\xff\xff\xff")},
      {"four billion sewn pairs", none, patched(whole, 52, "\xff\xff\xff\xff")},
      {"a piece that begins past the end", none, patched(whole, piece, "\x05")},
      {"a piece that ends past the end", none, patched(whole, piece + 4, "\x05")},
      {"a name longer than the message", none, patched(whole, piece + 20, "\x7f")},
      {"a corner below zero", none, patched(whole, triangles, "\x01")},
      {"a corner past the last vertex", none, patched(whole, triangles, "\x08")},
      {"a sewn vertex past the last", none, patched(whole, whole.size() - 1, "\x08")},
      {"an index of more than 32 bits", none, patched(whole, triangles, "\xff\xff\xff\xff\x1f")},
      {"an index of six bytes", none, patched(whole, triangles, "\x80\x80\x80\x80\x80\x01")},
  };
}

template <typename Sequence>
json::JsonValue list_of(const Sequence& numbers) {
  Elements elements;
  for (const auto number : numbers) elements.emplace_back(static_cast<double>(number));
  return elements;
}

json::JsonValue number(double value) { return json::JsonValue(value); }

json::JsonValue json_of(const FrameCase& c) {
  return Members{{"file", c.name + ".bin"},         {"key", c.key},
                 {"epoch", number(c.header.epoch)}, {"seq", number(c.header.seq)},
                 {"step", number(c.header.step)},   {"time", number(c.header.time)},
                 {"before", list_of(c.before)},     {"grid", list_of(c.grid)}};
}

json::JsonValue json_of(const TopologyCase& c) {
  Elements rest, triangles, sewn, pieces;
  for (const Vec2& p : c.garment.rest) rest.push_back(list_of(std::vector{p.x, p.y}));
  for (const Tri& t : c.garment.triangles) triangles.push_back(list_of(t));
  for (const auto& pair : c.garment.sewn) sewn.push_back(list_of(pair));
  for (const proto::StreamPiece& p : c.pieces) {
    pieces.emplace_back(Members{{"id", p.id},
                                {"first_vertex", number(p.first_vertex)},
                                {"vertex_count", number(p.vertex_count)},
                                {"colour", list_of(p.colour)}});
  }
  return Members{{"file", c.name + ".bin"},
                 {"epoch", number(c.epoch)},
                 {"origin", list_of(std::vector{c.grid.origin.x, c.grid.origin.y, c.grid.origin.z})},
                 {"step", number(c.grid.step)},
                 {"pieces", pieces},
                 {"rest", rest},
                 {"triangles", triangles},
                 {"sewn", sewn}};
}

json::JsonValue json_of(const RefusedCase& c) {
  std::string hex;
  for (const char byte : c.bytes) {
    for (const int nibble : {(byte >> 4) & 15, byte & 15}) hex += "0123456789abcdef"[nibble];
  }
  return Members{{"why", c.why},
                 {"code", c.code},
                 {"hex", hex},
                 {"numbers_before", number(static_cast<double>(c.numbers_before))}};
}

/// `"name": [...]` with a case a line, so that a change shows which case it touches.
template <typename Case>
std::string json_list(const std::string& name, const std::vector<Case>& cases) {
  std::string text = "  \"" + name + "\": [";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    text += (i == 0 ? "\n    " : ",\n    ") + json::write_json_line(json_of(cases[i]));
  }
  return text + "\n  ]";
}

template <typename Case>
Status write_messages(const std::filesystem::path& folder, const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    if (const Status s = write_file(folder / (c.name + ".bin"), bytes_of(c)); !s) return s;
  }
  return {};
}

Status write_all(const std::filesystem::path& folder) {
  TRY(write_messages(folder, frame_cases()));
  TRY(write_messages(folder, topology_cases()));
  const std::string text = "{\n" + json_list("frames", frame_cases()) + ",\n" +
                           json_list("topologies", topology_cases()) + ",\n" +
                           json_list("refused_frames", refused_frames()) + ",\n" +
                           json_list("refused_topologies", refused_topologies()) + "\n}\n";
  return write_file(folder / "frames.json", text);
}

}  // namespace
}  // namespace toile

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_golden_frames FOLDER\n");
    return 2;
  }
  if (const toile::Status s = toile::write_all(argv[1]); !s) {
    std::fprintf(stderr, "%s\n", to_string(s.error()).c_str());
    return 1;
  }
}
