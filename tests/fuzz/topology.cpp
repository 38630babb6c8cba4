// Topology messages of the stream.

#include "proto/cpp/frame_codec.h"
#include "tests/fuzz/fuzz.h"
#include "tests/proto/golden_frames.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const GoldenTopology& golden : golden_topologies()) all.push_back(golden.bytes);
  for (const RefusedMessage& refused : refused_messages("refused_topologies")) all.push_back(refused.bytes);
  return all;
}

void try_input(std::string_view bytes) {
  const Result<proto::DecodedTopology> topology = proto::decode_topology(bytes);
  if (!topology) return;
  const auto is_vertex = [&](Index v) { return v >= 0 && v < topology->vertex_count(); };
  for (const Vec2 p : topology->rest) expect(is_finite(p), "places are finite");
  for (const Tri& tri : topology->triangles)
    for (const Index v : tri) expect(is_vertex(v), "corners are vertices");
  for (const auto& pair : topology->sewn)
    for (const Index v : pair) expect(is_vertex(v), "sewn ends are vertices");
}

}  // namespace toile::fuzz
