#pragma once
// The program's verbs. Each takes what the command line said, does its work, prints, and returns an exit
// code.

#include <string>

#include "server/app/config.h"
#include "server/app/exit_code.h"

namespace toile {

struct DrapeOptions {
  std::string project;  ///< path of the document
  std::string out;      ///< folder for the results
  bool check_data = false;
  std::string trace;    ///< path; empty: no trace
  int trace_every = 1;  ///< frames
  bool json = false;
  bool stills = true;
  int width = 1024, height = 1280;  ///< of the stills, pixels
};

ExitCode drape_command(const DrapeOptions& options);

struct CheckOptions {
  std::string project;
  bool json = false;
};

ExitCode check_command(const CheckOptions& options);

struct BodyOptions {
  std::string out;  ///< path of an .obj
  double height_cm = 170, bust_cm = 90, waist_cm = 72, hip_cm = 96;
  int triangles = 3300;
  bool json = false;
};

ExitCode body_command(const BodyOptions& options);

/// Serves until SIGTERM or SIGINT.
ExitCode serve_command(const ServeOptions& options);

struct SubmitOptions {
  std::string project;  ///< path of the document
  std::string server = "http://127.0.0.1:8460";
  bool watch = false;  ///< follow the drape to its end
  std::string out;     ///< folder for the results; empty: they stay on the server
  bool json = false;
};

ExitCode submit_command(const SubmitOptions& options);

struct PatternImportOptions {
  std::string file;  ///< path of a DXF file
  std::string size;  ///< of a graded file; empty: its sample size
  std::string unit;  ///< mm, cm or inch; empty: decided
  bool json = false;
};

ExitCode pattern_import_command(const PatternImportOptions& options);

struct PatternExportOptions {
  std::string project;  ///< path of the document
  std::string out;      ///< path of the DXF file
  bool json = false;
};

ExitCode pattern_export_command(const PatternExportOptions& options);

}  // namespace toile
