#pragma once
// What is sewn to a garment besides its seams: buttons, elastic, creases pressed in, and air filled in.

#include <string>
#include <vector>

#include "core/base/types.h"

namespace toile::sewing {

/// A point of a flat panel.
struct PanelPoint {
  Index panel = kNone;
  Vec2 at;  ///< m, flat
};

/// Ties a point to another by a short thread. It is closed together with the seams.
struct Button {
  std::string id;
  PanelPoint a, b;
  double distance = 2e-3;  ///< m, the thread's length; the thickness of the layers keeps them apart besides
};

/// A band along edges and lines of a panel that is shorter (or longer) than the cloth and pulls.
struct Elastic {
  std::string id;
  Index panel = kNone;
  std::vector<Index> edges;  ///< of the panel, as edges_of counts
  std::vector<Index> lines;  ///< of the panel
  double factor = 1;         ///< its length without load, per length of the flat cloth
  double stiffness = 20;     ///< N per strain of the band
};

/// Lines along which cloth is pressed to an angle, and edges along which it is pressed to what they are sewn
/// to: a collar's fall onto its stand.
struct Crease {
  std::string id;
  Index panel = kNone;
  std::vector<Index> edges;  ///< of the panel, as edges_of counts
  std::vector<Index> lines;  ///< of the panel
  double angle = 0;  ///< radians, −π to π; positive: the side that is up in the flat panel stays outside
  double stiffness = 0.02;  ///< N·m per radian and metre of line
};

/// Pieces that hold air together, closed or nearly so. The side of the first one that is up in the flat panel
/// is the outside; the others are turned as they are sewn.
struct Cushion {
  std::string id;
  std::vector<Index> panels;
  double pressure = 100;   ///< Pa above that of the air outside
  double full_volume = 0;  ///< m³ at which the air has this pressure, if its amount is fixed; 0: it is pumped
};

struct Notions {
  std::vector<Button> buttons;
  std::vector<Elastic> elastics;
  std::vector<Crease> creases;
  std::vector<Cushion> cushions;
};

}  // namespace toile::sewing
