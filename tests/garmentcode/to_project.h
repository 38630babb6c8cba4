#pragma once
// Turns a GarmentCode garment (a DXF with its seams in a JSON beside it) into a project document. For tests
// and trials only: *.seams.json is no format of the product.

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "proto/cpp/project.h"

namespace toile::test {

/// Reads `folder`/NAME.seams.json. The document names NAME.dxf and `body_file`, and expects them beside
/// itself. Panels whose id starts with one of `held` are held at their height until a second after gravity is
/// full.
Result<Project> garmentcode_project(const std::filesystem::path& folder, const std::string& name,
                                    const std::string& body_file, const std::vector<std::string>& held);

/// The same, with its files copied beside it: writes `out`/project.json.
Status write_garmentcode_project(const std::filesystem::path& data, const std::string& name,
                                 const std::string& body, const std::vector<std::string>& held,
                                 double particle_distance_mm, const std::filesystem::path& out);

}  // namespace toile::test
