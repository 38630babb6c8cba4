#pragma once
// Sewing as a problem of shape: no time, gravity or contact of cloth with itself. Each pass lets every
// triangle say what shape it wants, then solves for the vertices that please all best: projective dynamics
// (Bouaziz et al. 2014), whose system stays the same from pass to pass and is factored once.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/dressing/figure.h"

namespace toile::dressing {

/// The cloth whose shape is asked for.
struct ShapeMesh {
  Index vertex_count = 0;
  std::vector<Tri> triangles;
  std::vector<std::array<Vec2, 3>> rest;  ///< m, corners of each triangle in the flat
  double spacing = 0.02;                  ///< m, mean edge
  /// Edges about which the cloth lies turned over: it does not resist bending there.
  std::vector<std::array<Index, 2>> turned = {};
};

/// How much each wish counts; the membrane's is 1.
struct ShapeWishes {
  double least_stretch = 0.3;  ///< a triangle may be this short without complaint,
  double most_stretch = 1.03;  ///< and this long
  double bending = 0.1;        ///< against curvature
  double threads = 1;          ///< for threads to be as long as they should
  double stay = 0.05;          ///< for vertices to stay where they are
  double hang = 0;             ///< m, for vertices to be lower
};

/// Two vertices and the distance at which they start.
struct Thread {
  Index a = kNone, b = kNone;
  double start_length = 0;  ///< m
  bool late = false;        ///< pulls only once the others have drawn their pieces together
};

/// How long threads are, as a share of their first length. Late ones that do not pull yet leave things be.
struct Shrunk {
  double early = 0;
  std::optional<double> late = 0;
};

class ShapeSolver {
 public:
  ShapeSolver(const ShapeMesh& mesh, std::vector<Thread> threads, const ShapeWishes& wishes);
  ~ShapeSolver();
  ShapeSolver(const ShapeSolver&) = delete;
  ShapeSolver& operator=(const ShapeSolver&) = delete;

  /// One pass over `x` (m): threads are `shrunk` (1 to 0). No vertex goes farther than
  /// 2 cm, nor into the figure.
  void pass(std::vector<Vec3>& x, const Shrunk& shrunk, const SlimFigure* figure);

 private:
  struct System;
  struct Element;
  void add_membrane();
  void add_bending();
  void wish(const std::vector<Vec3>& x, const Shrunk& shrunk);
  void keep_out(std::vector<Vec3>& x, const SlimFigure& figure) const;

  const ShapeMesh& mesh_;
  std::vector<Thread> threads_;
  ShapeWishes wishes_;
  std::vector<Element> elements_;
  std::unique_ptr<System> system_;
};

}  // namespace toile::dressing
