#pragma once
// What a person or a program reads of this program.

#include <string>

#include "core/base/result.h"
#include "server/app/exit_code.h"

namespace toile::app {

/// One line on stderr: "toile: code: message (where)", or {"error": {"code", "message", "where"}} as JSON.
void print_error(const Error& error, bool json);

/// kInternal for what is no fault of the input (code "internal", drawing, writing), else kBadInput.
ExitCode exit_code_of(const Error& error);

/// Prints the error; returns its exit code.
ExitCode fail(const Error& error, bool json);

}  // namespace toile::app
