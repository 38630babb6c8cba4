#pragma once
// Small drawings in the dialects that pattern programs write, for tests that change them at random.

#include <string>

#include "tests/core/pattern/dxf/dxf_text.h"

namespace toile::dxf_text {

/// Pieces in blocks, each in two sizes, with folds, sew lines, notches and statements.
inline std::string graded_blocks() {
  std::string blocks, inserts;
  for (int size = 42; size <= 44; size += 2) {
    const std::string name = "FR_" + std::to_string(size);
    blocks += block(name, open_sides({0, 0}, 200 + size, 600, "1") + line({0, 0}, {0, 600}, "6") +
                              open_sides({10, 10}, 180 + size, 580, "14") + line({50, 100}, {50, 300}, "7") +
                              groups({{0, "POINT"}, {8, "4"}, {10, "0"}, {20, "30"}, {30, "6"}, {50, "90"}}) +
                              text({9, 9}, "SIZE: " + std::to_string(size), "1") +
                              text({9, 19}, "Piece Name: FR", "1") + text({9, 29}, "Quantity:1,1", "1"));
    inserts += insert(name, {0, 0});
  }
  return "999\ncomment\n" + section("BLOCKS", blocks) +
         entities(text({0, 0}, "Sample Size: 42") + text({0, 0}, "Units: METRIC") + inserts);
}

/// Free layers: lines, arcs, splines and ellipses.
inline std::string free_lines() {
  return header(4) +
         entities(
             line({0, 0}, {300, 0}) + line({300, 400}, {300, 0}) +
             groups({{0, "ARC"}, {8, "0"}, {10, "150"}, {20, "400"}, {40, "150"}, {50, "0"}, {51, "180"}}) +
             line({0, 400}, {0, 0}) +
             groups({{0, "SPLINE"},
                     {8, "a"},
                     {71, "2"},
                     {40, "0"},
                     {40, "0"},
                     {40, "0"},
                     {40, "1"},
                     {40, "1"},
                     {40, "1"},
                     {10, "500"},
                     {20, "0"},
                     {10, "700"},
                     {20, "300"},
                     {10, "900"},
                     {20, "0"}}) +
             line({500, 0}, {900, 0}, "a") +
             groups({{0, "LWPOLYLINE"},
                     {8, "b"},
                     {70, "1"},
                     {10, "1000"},
                     {20, "0"},
                     {42, "0.5"},
                     {10, "1200"},
                     {20, "0"},
                     {10, "1200"},
                     {20, "300"}}) +
             groups({{0, "ELLIPSE"},
                     {8, "c"},
                     {10, "1500"},
                     {20, "0"},
                     {11, "200"},
                     {21, "9"},
                     {40, "0.5"},
                     {41, "0"},
                     {42, "6.283185307179586"}}) +
             text({150, 100}, "FRONT \xC7\xB0") + rectangle({100, 100}, 30, 30));
}

/// Blocks in blocks, in themselves, mirrored, and two of one name.
inline std::string nested_blocks() {
  const std::string mirrored = groups({{0, "INSERT"},
                                       {2, "A"},
                                       {10, "10"},
                                       {20, "5"},
                                       {41, "-1"},
                                       {42, "2"},
                                       {50, "30"},
                                       {66, "1"},
                                       {0, "ATTRIB"},
                                       {1, "x"},
                                       {0, "SEQEND"}});
  return section("TABLES", groups({{0, "TABLE"}, {2, "LAYER"}, {0, "ENDTAB"}})) +
         section("BLOCKS", block("A", rectangle({0, 0}, 90, 200, "CUT") + rectangle({5, 5}, 80, 190, "SEW")) +
                               block("B", mirrored + insert("B", {1, 1})) +
                               block("A", rectangle({0, 0}, 9, 9))) +
         entities(insert("B", {0, 0}) + insert("A", {500, 0}) + insert("A", {900, 0}));
}

}  // namespace toile::dxf_text
