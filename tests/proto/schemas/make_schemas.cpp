// Writes the JSON schemas that the program's own field descriptions make: make_schemas FOLDER.

#include <cstdio>
#include <filesystem>

#include "core/base/write_file.h"
#include "core/exports/map_file.h"
#include "core/exports/write_report.h"
#include "core/fabric/schema.h"
#include "core/manifest/manifest.h"
#include "core/manifest/touch_log.h"
#include "core/project/editing/edits.h"
#include "core/project/schema.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "make_schemas FOLDER, e.g. proto/schema\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const std::pair<const char*, toile::json::JsonValue> files[] = {
      {"project.schema.json", toile::project::project_schema()},
      {"edit.schema.json", toile::editing::edit_schema()},
      {"fabric.schema.json", toile::fabric::fabric_schema()},
      {"report.schema.json", toile::exports::report_schema()},
      {"manifest.schema.json", toile::manifest::manifest_schema()},
      {"maps.schema.json", toile::exports::map_schema()},
      {"drape_log.schema.json", toile::manifest::touch_log_schema()},
  };
  for (const auto& [name, schema] : files) {
    const toile::Status written = toile::write_file(folder / name, toile::json::write_json(schema));
    if (written) continue;
    std::fprintf(stderr, "%s\n", toile::to_string(written.error()).c_str());
    return 1;
  }
  return 0;
}
