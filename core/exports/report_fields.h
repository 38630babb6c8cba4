#pragma once
// report.json's fields, said once: for the writer and for proto/schema/report.schema.json.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/json/fields/schema.h"

namespace toile::exports {

/// Text that may be empty and of any length: nobody reads it back.
struct FreeText {
  std::string text;
};

/// 32 hex digits.
struct HexHash {
  std::string digits;
};

// What a report says, in the form of its JSON; units stand with the fields below.

struct ReportFrame {
  int step = 0, cloth_body = 0, cloth_cloth = 0;
};

struct ReportCrossings {
  int cloth_body = 0, cloth_cloth = 0;
  ReportFrame worst_frame;
  int frames_checked = 0;
};

struct ReportAttachment {
  FreeText id;
  bool released = false;
  double off_mm = 0;
  std::optional<double> released_s;
};

struct ReportFigures {
  double mean = 0, p99 = 0, max = 0;
};

struct ReportStretch {
  ReportFigures all, tension, compression;
};

struct ReportStrain {
  ReportStretch warp, weft;
  ReportFigures shear;
};

struct ReportConcern {
  std::string thing;
  FreeText id;
};

struct ReportFinding {
  FreeText code;
  std::string severity;
  FreeText message, where;
  std::vector<ReportConcern> about;
  std::array<double, 3> place{};
  bool repaired = false;
};

struct ReportSeam {
  FreeText id;
  double gap_mm = 0;
};

struct ReportFit {
  FreeText at;
  std::string fit;
  FreeText text;
  double body_mm = 0, garment_mm = 0, ease_mm = 0, worn_mm = 0, tight_by_mm = 0, shifted_mm = 0;
  std::vector<FreeText> pieces;
  std::array<double, 3> place{};
};

struct ReportDocument {
  FreeText name;
  bool settled = false;
  FreeText stop_reason;
  double cpu_s = 0, wall_s = 0;
  int resumed = 0, steps = 0;
  double simulated_s = 0;
  int particles = 0, sewn_particles = 0, triangles = 0, body_triangles = 0;
  ReportCrossings intersections;
  double seam_gap_max_mm = 0;
  std::vector<ReportSeam> open_seams;
  std::string worn;
  std::vector<ReportAttachment> attachments;
  ReportStrain strain;
  std::vector<ReportFit> fit;
  double rms_speed = 0, max_speed = 0, lowest_m = 0, highest_m = 0;
  std::vector<ReportFinding> findings;
  HexHash hash;
};

}  // namespace toile::exports

namespace toile::fields {

inline constexpr Range kNotNegative{0};

inline json::JsonValue schema_of(const exports::FreeText&, Range, Definitions&) {
  return std::vector<json::JsonMember>{{"type", std::string("string")}};
}
inline json::JsonValue schema_of(const exports::HexHash&, Range, Definitions&) {
  return std::vector<json::JsonMember>{{"type", std::string("string")},
                                       {"pattern", std::string("^[0-9a-f]{32}$")}};
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportFrame& frame) {
  v.object("", "The frame with the most crossings.");
  v.field("step", frame.step, "Its substep.", Need::kRequired, kNotNegative);
  v.field("cloth_body", frame.cloth_body, "Of cloth with bodies.", Need::kRequired, kNotNegative);
  v.field("cloth_cloth", frame.cloth_cloth, "Of cloth with cloth.", Need::kRequired, kNotNegative);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportCrossings& counts) {
  v.object("",
           "Crossings, counted exactly: an edge of one triangle through the inside of another. At the end, "
           "and in the worst of the frames that were checked.");
  v.field("cloth_body", counts.cloth_body, "Of cloth with bodies, at the end.", Need::kRequired,
          kNotNegative);
  v.field("cloth_cloth", counts.cloth_cloth, "Of cloth with cloth, at the end.", Need::kRequired,
          kNotNegative);
  v.field("worst_frame", counts.worst_frame, "The frame with the most crossings.", Need::kRequired);
  v.field("frames_checked", counts.frames_checked, "How many frames were checked.", Need::kRequired,
          kNotNegative);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportSeam& seam) {
  v.object("", "");
  v.field("id", seam.id, "Its name; empty where it has none.", Need::kRequired);
  v.field("gap_mm", seam.gap_mm, "mm; how far it is open, at most.", Need::kRequired, kNotNegative);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportAttachment& attachment) {
  v.object("", "");
  v.field("id", attachment.id, "Its name; empty where it has none.", Need::kRequired);
  v.field("released", attachment.released, "Whether it has let go.", Need::kRequired);
  v.field("off_mm", attachment.off_mm,
          "mm; how far what it holds was from where it should be, at most: when it was released, or else at "
          "the end.",
          Need::kRequired, kNotNegative);
  v.field("released_s", attachment.released_s, "s of simulated time; absent while it holds.", Need::kOptional,
          kNotNegative);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportFigures& figures) {
  v.object("figures", "");
  v.field("mean", figures.mean, "Mean.", Need::kRequired, kNotNegative);
  v.field("p99", figures.p99, "99th percentile.", Need::kRequired, kNotNegative);
  v.field("max", figures.max, "Maximum.", Need::kRequired, kNotNegative);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportStretch& stretch) {
  v.object("stretch_figures",
           "Magnitudes; stretch and squeeze apart in tension and compression, where what is not stretched "
           "(squeezed) counts as 0. A fabric's strain limits speak of tension.");
  v.field("mean", stretch.all.mean, "Mean.", Need::kRequired, kNotNegative);
  v.field("p99", stretch.all.p99, "99th percentile.", Need::kRequired, kNotNegative);
  v.field("max", stretch.all.max, "Maximum.", Need::kRequired, kNotNegative);
  v.field("tension", stretch.tension, "Of stretch alone.", Need::kRequired);
  v.field("compression", stretch.compression, "Of squeeze alone.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportStrain& strain) {
  v.object("", "Magnitudes of strain over the triangles at the end: stretch as a ratio, shear in radians.");
  v.field("warp", strain.warp, "Along the warp.", Need::kRequired);
  v.field("weft", strain.weft, "Along the weft.", Need::kRequired);
  v.field("shear", strain.shear, "Between warp and weft.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportFit& line) {
  v.object("",
           "A girth of body and garment in one plane: the body's as a tape takes it, over hollows; the "
           "garment's as its flat pieces measure along the shortest way around.");
  v.field("at", line.at, "\"bust\", \"waist\", \"hip\", \"thigh_left\", \"upper_arm_right\", …",
          Need::kRequired);
  v.choice(
      "fit", line.fit,
      "stretched: narrower than the body, and the cloth gives without pressing; too_tight: narrower than "
      "it gives.",
      {"fits", "stretched", "too_tight"}, Need::kRequired);
  v.field("text", line.text, "The line in words: \"waist 2.1 cm too tight\".", Need::kRequired);
  v.field("body_mm", line.body_mm, "mm; of the body.", Need::kRequired, kNotNegative);
  v.field("garment_mm", line.garment_mm, "mm; of the flat pieces.", Need::kRequired, kNotNegative);
  v.field("ease_mm", line.ease_mm, "mm; the garment's girth less the body's.", Need::kRequired);
  v.field("worn_mm", line.worn_mm, "mm; of the cloth as it hangs, stretch included.", Need::kRequired,
          kNotNegative);
  v.field("tight_by_mm", line.tight_by_mm, "mm that it should be wider; 0 where it is not too tight.",
          Need::kRequired, kNotNegative);
  v.field("shifted_mm", line.shifted_mm,
          "mm, how far above (along limbs towards the trunk) where that girth is usually taken: the nearest "
          "place that the garment goes around.",
          Need::kRequired);
  v.field("pieces", line.pieces, "Those that the way goes through.", Need::kRequired);
  v.field("place", line.place, "m; x, y, z of the body's middle there.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportConcern& concern) {
  v.object("concern", "A thing of the garment or the scene that a finding is about.");
  v.choice("thing", concern.thing, "\"edge\": of the piece before it.", {"piece", "edge", "seam", "body"},
           Need::kRequired);
  v.field("id", concern.id, "Its id in the document.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportFinding& finding) {
  v.object("finding", "");
  v.field("code", finding.code, "Stable, for programs, e.g. \"start.crosses_body\".", Need::kRequired);
  v.choice("severity", finding.severity, "\"note\", \"warning\" or \"error\".", {"note", "warning", "error"},
           Need::kRequired);
  v.field("message", finding.message, "What it is, in words, and the way out.", Need::kRequired);
  v.field("where", finding.where, "The piece, edge or seam, in words.", Need::kRequired);
  v.field("about", finding.about, "The same for programs, what has to be seen to first; bodies last.",
          Need::kRequired);
  v.field("place", finding.place, "m; x, y, z of the spot, at the start.", Need::kRequired);
  v.field("repaired", finding.repaired, "Whether the start was changed so that it is gone.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, exports::ReportDocument& report) {
  v.object("", "The figures of one drape, as `toile drape` leaves them in report.json.");
  v.field("name", report.name, "The project's name.", Need::kRequired);
  v.field("settled", report.settled, "Whether the cloth came to rest.", Need::kRequired);
  v.field("stop_reason", report.stop_reason,
          "Why the drape ended: \"settled\", \"time\", \"cancelled\" or what else stopped it.",
          Need::kRequired);
  v.field("cpu_s", report.cpu_s, "s of processor time, all threads together.", Need::kRequired, kNotNegative);
  v.field("wall_s", report.wall_s, "s by the clock.", Need::kRequired, kNotNegative);
  v.field("resumed", report.resumed,
          "How often the drape went on from a checkpoint after a stop or a crash; the bytes are the same.",
          Need::kRequired, kNotNegative);
  v.field("steps", report.steps, "Substeps of the solver.", Need::kRequired, kNotNegative);
  v.field("simulated_s", report.simulated_s, "s of simulated time.", Need::kRequired, kNotNegative);
  v.field("particles", report.particles, "Vertices of the flat pieces.", Need::kRequired, kNotNegative);
  v.field("sewn_particles", report.sewn_particles,
          "Vertices of the garment: what is sewn together counts once.", Need::kRequired, kNotNegative);
  v.field("triangles", report.triangles, "Triangles of the cloth.", Need::kRequired, kNotNegative);
  v.field("body_triangles", report.body_triangles, "Triangles of all bodies.", Need::kRequired, kNotNegative);
  v.field("intersections", report.intersections,
          "Crossings, counted exactly: an edge of one triangle through the inside of another. At the end, "
          "and in the worst of the frames that were checked.",
          Need::kRequired);
  v.field("seam_gap_max_mm", report.seam_gap_max_mm,
          "mm; the widest distance between two sewn vertices at the end.", Need::kRequired, kNotNegative);
  v.field("open_seams", report.open_seams, "The seams that did not close.", Need::kRequired);
  v.choice(
      "worn", report.worn,
      "Whether the body wears the garment: every ring around the limb that it is for, and nothing fallen. "
      "partly: but for a seam that is open. Absent where nobody stands there, and where cloth without seams "
      "stays on the body.",
      {"yes", "partly", "no"});
  v.field("attachments", report.attachments, "What the document's attachments did, in their order.",
          Need::kRequired);
  v.field("strain", report.strain,
          "Magnitudes of strain over the triangles at the end: stretch as a ratio, shear in radians.",
          Need::kRequired);
  v.field("fit", report.fit,
          "Girths of body and garment and the ease between, as far as somebody stands there and the garment "
          "goes around.",
          Need::kOptional);
  v.field("rms_speed", report.rms_speed, "m/s; root mean square over the particles at the end.",
          Need::kRequired, kNotNegative);
  v.field("max_speed", report.max_speed, "m/s; of the fastest particle at the end.", Need::kRequired,
          kNotNegative);
  v.field("lowest_m", report.lowest_m, "m; height of the cloth's lowest point.", Need::kRequired);
  v.field("highest_m", report.highest_m, "m; height of the cloth's highest point.", Need::kRequired);
  v.field("findings", report.findings, "What the look at the start found, worst first.", Need::kRequired);
  v.field("hash", report.hash,
          "128-bit XXH3 of the final positions, 32 hex digits: the same input gives the same hash.",
          Need::kRequired);
}

}  // namespace toile::fields
