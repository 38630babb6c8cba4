#pragma once
// The table of a sweep as files and as lines for a person.

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/sweep/table.h"
#include "server/app/exit_code.h"

namespace toile::app {

/// The folder of a cell's results within the sweep's: "eu36_denim-10oz", of letters, digits, dots, hyphens.
std::string cell_folder(const std::string& body, const std::string& fabric);

/// table.csv, table.json and, where ffmpeg is installed, sheet.png into `folder`; the cells' stills lie in
/// their folders. Error: export.write.
Status write_table(const sweep::Table& table, const std::filesystem::path& folder);

/// The sweep as JSON, with its cells.
std::string table_json(const sweep::Table& table);

/// A line for each cell on stdout.
void print_table(const sweep::Table& table);

/// That of the cell that came out worst: kBadInput, kCancelled, kNotWorn, kUnsettled, kDone, in this order.
ExitCode exit_code_of(const sweep::Table& table);

}  // namespace toile::app
