#pragma once
// The keys of maps.json, for its reader, its writer and its schema.

#include <string>
#include <vector>

#include "core/exports/map_file.h"
#include "core/json/fields/range.h"

namespace toile::exports {

struct MapPiece {
  std::string id;
  int first_vertex = 0, vertex_count = 0;
};

struct MapValues {
  std::string map, title, unit;
  std::vector<double> values;
};

struct MapFile {
  int toile_maps = 1;  ///< version of the format
  std::vector<MapPiece> pieces;
  std::vector<MapValues> maps;
};

}  // namespace toile::exports

namespace toile::fields {

template <typename Visitor>
void describe(Visitor& v, exports::MapPiece& piece) {
  v.object("piece", "Which vertices a piece has.");
  v.field("id", piece.id, "As in the document.", Need::kRequired);
  v.field("first_vertex", piece.first_vertex, "Number of its first vertex, from 0; as in final.obj, less 1.",
          Need::kRequired, Range{0});
  v.field("vertex_count", piece.vertex_count, "How many it has.", Need::kRequired, Range{0});
}

template <typename Visitor>
void describe(Visitor& v, exports::MapValues& map) {
  v.object("map", "One figure of the whole cloth.");
  v.field(
      "map", map.map,
      "Which: warp and weft (stretch along these threads), shear (by how much the angle between them is off "
      "90 "
      "degrees), ease (distance to the nearest skin; 150 stands for what is farther), curvature (the mean of "
      "both "
      "principal ones, positive where the cloth bends away from its right side), pressure (on the skin, by "
      "Laplace's law from "
      "tension and curvature; where the cloth is stretched beyond its fabric's limit it is more than that).",
      Need::kRequired);
  v.field("title", map.title, "The same for a person, in English.", Need::kRequired);
  v.field("unit", map.unit, "Of the values: %, °, mm, 1/m or kPa.", Need::kRequired);
  v.field("values", map.values, "One a vertex.");
}

template <typename Visitor>
void describe(Visitor& v, exports::MapFile& file) {
  v.object("", "What the cloth is measured for at each of its vertices, at the end of a drape.");
  v.field("toile_maps", file.toile_maps, "Version of this format.", Need::kRequired, Range{1, 1});
  v.field("pieces", file.pieces, "In the order of their vertices.");
  v.field("maps", file.maps, "Without a body there is neither ease nor pressure.", Need::kRequired);
}

}  // namespace toile::fields
