#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "core/body/body.h"
#include "core/drape/stop_reason.h"
#include "core/drape/touch.h"
#include "core/preflight/finding.h"
#include "core/sewing/garment_mesh.h"
#include "core/warm/hung_garment.h"

namespace toile::drape {

/// A moment of a drape.
struct Frame {
  int step = 0;
  double time = 0;              ///< s of simulated time
  std::string phase;            ///< "sew", "drape", "move"
  std::vector<Vec3> positions;  ///< m, of GarmentMesh's vertices
  double bodies = 0;            ///< s of the bodies' motion that have been played
};

/// Crossings of triangles, counted exactly (a triangle's edge through another's interior).
struct CrossingCount {
  int cloth_body = 0;
  int cloth_cloth = 0;
};

/// What became of an attachment.
struct HoldFigures {
  bool released = false;
  double released_at = 0;  ///< s of simulated time
  double off = 0;          ///< m, from where it should be, at most: when it was released, or else at the end
};

/// What became of the bodies' motion.
struct MotionFigures {
  bool whole = true;    ///< played to its end, or there was none
  double share = 1;     ///< of its time that was played
  double played = 0;    ///< s, that time
  double waited = 0;    ///< s, for cloth that could not give way
  Index panel = kNone;  ///< that was too tight where it was stopped
  double way_left = 0;  ///< m, that the body still had to go there
  Vec3 place;           ///< m, where that is
};

/// A seam that did not close.
struct OpenSeam {
  std::string id;
  double gap = 0;  ///< m, the widest
};

/// Whether the body wears what was draped.
enum class Worn : std::uint8_t {
  kNobody,  ///< there is no standing person, or nothing that is sewn and nothing fell
  kYes,
  kPartly,  ///< a seam is open
  kNo,      ///< a ring is not around the limb that it is for, or what is worn came down
};
/// "", "yes", "partly", "no".
std::string_view word_of(Worn worn);

struct DrapeResult {
  sewing::GarmentMesh garment;
  std::vector<Vec3> positions;  ///< m, at the end
  StopReason stop_reason;       ///< kCancelled also when it never began
  int steps = 0;
  double simulated_time = 0;  ///< s
  double cpu_s = 0, wall_s = 0;
  int resumed = 0;                      ///< how often it went on from a checkpoint
  double rms_speed = 0, max_speed = 0;  ///< m/s at the end
  CrossingCount at_end;
  CrossingCount worst;  ///< of all recorded frames
  int worst_frame_step = 0;
  int frames_checked = 0;
  preflight::Findings findings;  ///< of the look at the start, worst first
  double seam_gap_max = 0;       ///< m
  std::vector<OpenSeam> open_seams;
  Worn worn = Worn::kNobody;
  std::vector<HoldFigures> holds;  ///< one for each attachment
  std::vector<body::Body> bodies;  ///< of the input, as they stand at the end
  std::vector<Touch> touches;      ///< of hands on the cloth, in their order
  warm::HungGarment hung;          ///< for another drape to go on from

  bool settled() const { return stop_reason.kind == Stop::kSettled; }
};

}  // namespace toile::drape
