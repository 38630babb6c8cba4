#pragma once
// Project documents of GarmentCode's garments, ready to be draped. For tests and trials only.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace toile::test {

/// Writes `out`/project.json from `data`/garmentcode/NAME_specification.json, with the body from
/// `data`/bodies beside it. Panels whose id starts with one of `held` are held at their height until a second
/// after gravity is full.
Status write_garmentcode_project(const std::filesystem::path& data, const std::string& name,
                                 const std::string& body, const std::vector<std::string>& held,
                                 double particle_distance_mm, const std::filesystem::path& out);

}  // namespace toile::test
