#pragma once

#include <filesystem>
#include <string>

#include "core/analysis/report.h"
#include "core/base/result.h"
#include "core/json/tree.h"

namespace toile::exports {

/// The report as JSON text, keys as proto/schema/report.schema.json lists them.
std::string report_json(const analysis::Report& report);

/// Those keys as JSON Schema: what that file holds.
json::JsonValue report_schema();

/// Writes report_json to `path` through a temporary file. Error: export.write with path and reason.
Status write_report(const std::filesystem::path& path, const analysis::Report& report);

}  // namespace toile::exports
