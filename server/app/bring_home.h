#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/app/exit_code.h"
#include "server/app/remote.h"

namespace toile::app {

/// Every result of a job into `folder`, made when it is not there. What lies there already with the right
/// bytes is not fetched again, so that who comes back after a break goes on. Errors: usage.out, client.*,
/// client.other_bytes when what arrives is not what the server has kept; export.write.
Status bring_home(Remote& remote, const std::string& job_id, const std::filesystem::path& folder);

/// How a job that has ended came out, as toile drape says it. REQUIRES a job as GET /api/v1/jobs/{id} gives
/// it, or a cell of a sweep with "figures" in place of the report.
ExitCode exit_code_of_end(const std::string& state, const json::JsonValue* report);

/// What went wrong afar: a fault of the server or of the line is none of the input.
ExitCode fail_remote(const Error& error, bool json);

}  // namespace toile::app
