#pragma once
// The sample that ships in samples/skirt, made anew around the body that lies there: its files can be
// compared with what the code gives.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/draft/skirt.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::draft {

struct SkirtSampleSettings {
  SkirtMeasures skirt;
  double particle_distance_mm = 16.2;  ///< gives about 3,120 particles
  double wrap_radius = 0.155;          ///< m, of the pieces around the waist before they are sewn
  double gap = 0.008;                  ///< m, between the band's lower edge and the skirt's waist
};

struct SampleFile {
  std::string name;
  std::string bytes;
};

/// skirt.dxf and project.json: the drafted skirt wrapped around `body` (the sample's body.obj), its bands at
/// the waist. Errors: those of draft_skirt, write_dxf and read_dxf.
Result<std::vector<SampleFile>> make_skirt_sample(const geometry::TriangleMesh& body,
                                                  const SkirtSampleSettings& settings = {});

}  // namespace toile::draft
