#pragma once
// The golden messages of proto/fixtures/frames as the tests read them.

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/json/tree.h"
#include "proto/cpp/frame_codec.h"

namespace toile {

struct GoldenFrame {
  std::string file, bytes;
  proto::DecodedFrame frame;
  std::vector<std::int16_t> before;
};

struct GoldenTopology {
  std::string file, bytes;
  std::uint32_t epoch = 0;
  proto::FrameGrid grid;
  sewing::GarmentMesh garment;
  std::vector<proto::StreamPiece> pieces;
};

struct RefusedMessage {
  std::string why, code, bytes;
  std::vector<std::int16_t> before;
};

inline std::string golden_file(const std::string& name) {
  std::ifstream in(std::string(TOILE_SOURCE_DIR) + "/proto/fixtures/frames/" + name, std::ios::binary);
  if (!in) throw std::runtime_error("no golden file " + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline const json::JsonValue& golden_json() {
  static const json::JsonValue json = json::parse_json(golden_file("frames.json")).value();
  return json;
}

/// The elements of the list `key` of `object`.
inline const std::vector<json::JsonValue>& list_at(const json::JsonValue& object, std::string_view key) {
  return *object.find(key)->array();
}
inline double number_at(const json::JsonValue& object, std::string_view key) {
  return *object.find(key)->number();
}
inline std::string text_at(const json::JsonValue& object, std::string_view key) {
  return *object.find(key)->text();
}

template <typename T>
std::vector<T> numbers_at(const json::JsonValue& object, std::string_view key) {
  std::vector<T> numbers;
  for (const json::JsonValue& n : list_at(object, key)) numbers.push_back(static_cast<T>(*n.number()));
  return numbers;
}

inline std::vector<GoldenFrame> golden_frames() {
  std::vector<GoldenFrame> all;
  for (const json::JsonValue& json : list_at(golden_json(), "frames")) {
    GoldenFrame& golden = all.emplace_back();
    golden.file = text_at(json, "file");
    golden.bytes = golden_file(golden.file);
    golden.frame.key = *json.find("key")->boolean();
    golden.frame.header = {.epoch = static_cast<std::uint32_t>(number_at(json, "epoch")),
                           .seq = static_cast<std::uint32_t>(number_at(json, "seq")),
                           .step = static_cast<std::int32_t>(number_at(json, "step")),
                           .time = static_cast<float>(number_at(json, "time"))};
    golden.frame.grid = numbers_at<std::int16_t>(json, "grid");
    golden.before = numbers_at<std::int16_t>(json, "before");
  }
  return all;
}

/// `json` is a list of lists of as many indices as `Tuple` has.
template <typename Tuple>
std::vector<Tuple> tuples_at(const json::JsonValue& object, std::string_view key) {
  std::vector<Tuple> tuples;
  for (const json::JsonValue& list : list_at(object, key)) {
    Tuple& tuple = tuples.emplace_back();
    for (std::size_t i = 0; i < tuple.size(); ++i)
      tuple[i] = static_cast<Index>(*list.array()->at(i).number());
  }
  return tuples;
}

inline std::vector<GoldenTopology> golden_topologies() {
  std::vector<GoldenTopology> all;
  for (const json::JsonValue& json : list_at(golden_json(), "topologies")) {
    GoldenTopology& golden = all.emplace_back();
    golden.file = text_at(json, "file");
    golden.bytes = golden_file(golden.file);
    golden.epoch = static_cast<std::uint32_t>(number_at(json, "epoch"));
    const auto origin = numbers_at<double>(json, "origin");
    golden.grid = {.origin = {origin.at(0), origin.at(1), origin.at(2)}, .step = number_at(json, "step")};
    for (const json::JsonValue& p : list_at(json, "rest")) {
      golden.garment.rest.push_back({*p.array()->at(0).number(), *p.array()->at(1).number()});
    }
    golden.garment.triangles = tuples_at<Tri>(json, "triangles");
    golden.garment.sewn = tuples_at<std::array<Index, 2>>(json, "sewn");
    for (const json::JsonValue& p : list_at(json, "pieces")) {
      const auto colour = numbers_at<double>(p, "colour");
      golden.pieces.push_back({text_at(p, "id"),
                               static_cast<Index>(number_at(p, "first_vertex")),
                               static_cast<Index>(number_at(p, "vertex_count")),
                               {colour.at(0), colour.at(1), colour.at(2)}});
    }
  }
  return all;
}

inline std::string bytes_of_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// `key`: "refused_frames" or "refused_topologies".
inline std::vector<RefusedMessage> refused_messages(std::string_view key) {
  std::vector<RefusedMessage> all;
  for (const json::JsonValue& json : list_at(golden_json(), key)) {
    all.push_back({text_at(json, "why"), text_at(json, "code"), bytes_of_hex(text_at(json, "hex")),
                   std::vector<std::int16_t>(static_cast<std::size_t>(number_at(json, "numbers_before")))});
  }
  return all;
}

}  // namespace toile
