#pragma once
// A drape as it is shown: the garment with its looks, the bodies, and the cloth's way from start to end.

#include <cstdint>
#include <span>
#include <vector>

#include "core/body/body.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/image/texture.h"
#include "core/sewing/garment_mesh.h"
#include "proto/cpp/frame_codec.h"
#include "server/render/scene.h"

namespace toile::movie {

/// A moment of the cloth on the motion's grid.
struct FilmFrame {
  int step = 0;                    ///< substep of the solver
  float time = 0;                  ///< s of simulated time
  std::vector<std::int16_t> grid;  ///< three a vertex
  float bodies = 0;                ///< s of the bodies' motion
};

/// How a body of the film moved.
struct BodyWay {
  Index body = 0;                         ///< by its number
  std::vector<Vec3> start;                ///< m
  std::vector<body::Keyframe> keyframes;  ///< at least one
};

/// Frames of a drape, the first and the last among them, in order of steps.
struct Motion {
  proto::FrameGrid grid;
  int stride = 25;  ///< substeps: of each so many one frame is kept, and the last in any case
  std::vector<FilmFrame> frames;
};

struct Film {
  sewing::GarmentMesh garment;                 ///< without seam_of_sewn
  std::vector<proto::StreamPiece> pieces;      ///< one a panel
  std::vector<Vec3> end;                       ///< m, of the garment's vertices
  std::vector<geometry::TriangleMesh> bodies;  ///< at the end
  std::vector<BodyWay> ways;                   ///< of those that moved
  image::Textures textures;
  std::vector<render::ClothLook> looks;  ///< one a panel; none of films of older programs
  Motion motion;
};

/// How the fabrics of the panels look: those of the library as their files say, others as plain cloth.
std::vector<render::ClothLook> looks_of(const drape::DrapeInput& input);

/// What a drape of `input` leaves. REQUIRES one piece for each panel.
Film film_of(const drape::DrapeInput& input, const drape::DrapeResult& result,
             std::vector<proto::StreamPiece> pieces, image::Textures textures, Motion motion);

/// The film's things with the cloth at `positions` (m). Refers to both.
render::Scene scene_of(const Film& film, std::span<const Vec3> positions);
render::Scene scene_of(const Film& film, std::vector<Vec3>&& positions) = delete;  // they would be gone

/// The bodies so many s into their motion.
std::vector<geometry::TriangleMesh> bodies_at(const Film& film, double played);
/// s of the bodies' motion, at a time (s of simulated time): between those of the frames around it. REQUIRES
/// frames.
double played_at(const Motion& motion, double time);

/// The cloth at a time (s of simulated time), m: on the straight way between the frames around it.
/// REQUIRES frames.
std::vector<Vec3> positions_at(const Motion& motion, double time);

}  // namespace toile::movie
