#pragma once
// A drafted garment as a project of its own: a DXF file and the document that names it.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/draft/garment.h"
#include "core/project/project.h"

namespace toile::sample {

struct SampleProject {
  std::string dxf_name;  ///< as the document names it
  std::string dxf;       ///< its bytes
  project::Project project;
};

/// The garment's pieces as DXF, and a document with its edges' names, seams, cloths and notions around
/// `body`, or over its own solids (files ID.obj in metres, which whoever writes the document writes as well).
/// Pieces of what is worn have no places yet: they are arranged on the resolved document. `cloth` is the id
/// of one of the garment's cloths; empty: the first. Errors: those of write_dxf and read_dxf, "sample.cloth".
Result<SampleProject> sample_project(const draft::Garment& garment,
                                     const std::optional<project::ProjectBody>& body,
                                     const std::string& cloth = {});

}  // namespace toile::sample
