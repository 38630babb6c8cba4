#pragma once
// The program's verbs. Each takes what the command line said, does its work, prints, and returns an exit
// code.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/body/measure/measures.h"
#include "server/app/config.h"
#include "server/app/exit_code.h"
#include "server/app/remote.h"

namespace toile::app {

/// More threads than these find too little to do side by side in one drape.
inline constexpr int kMostThreads = 16;

struct DrapeOptions {
  std::string project;  ///< path of the document
  std::string out;      ///< folder for the results
  std::string from;     ///< final.hung of another drape, or the folder where it lies; empty: from the pieces
  std::string replay;   ///< drape.log, whose hands are on the cloth again; empty: none
  bool check_data = false;
  int threads = 0;      ///< that drape; 0: as many as the machine has
  std::string trace;    ///< path; empty: no trace
  int trace_every = 1;  ///< frames
  bool json = false;
  bool quiet = false;  ///< prints nothing but errors
  bool stills = true;
  int width = 1024, height = 1280;  ///< of the stills, pixels
};

ExitCode drape_command(const DrapeOptions& options);

struct CheckOptions {
  std::string project;
  bool json = false;
};

ExitCode check_command(const CheckOptions& options);

struct BodyMakeOptions {
  std::string out;     ///< path of an .obj
  std::string sex;     ///< female, male or child; empty: the preset's, or female
  std::string preset;  ///< name of a size; empty: none
  std::array<std::optional<double>, measure::kMeasureCount> measures_cm;  ///< what is asked for, by Measure
  std::string pose = "a";                                                 ///< a or t
  double arm_angle = 45;  ///< degrees from the vertical, of pose a
  int triangles = 4562;
  bool json = false;
};

ExitCode body_make_command(const BodyMakeOptions& options);

struct BodyMeasureOptions {
  std::string file;  ///< path of a mesh
  bool json = false;
};

ExitCode body_measure_command(const BodyMeasureOptions& options);

struct BodyPresetsOptions {
  bool json = false;
};

ExitCode body_presets_command(const BodyPresetsOptions& options);

struct FabricListOptions {
  bool json = false;
};

ExitCode fabric_list_command(const FabricListOptions& options);

struct FabricShowOptions {
  std::string name;  ///< of the library
  bool json = false;
};

ExitCode fabric_show_command(const FabricShowOptions& options);

struct FabricTestOptions {
  std::string name;                 ///< of the library
  std::string out;                  ///< folder for the figure sheet; empty: none
  int drapes = 6;                   ///< of the Cusick test, 1 to 6
  double particle_distance_mm = 0;  ///< of its triangles; 0: what fits the fabric
  bool json = false;
};

ExitCode fabric_test_command(const FabricTestOptions& options);

/// What a laboratory measured (core/trials/calibrate.h).
struct FabricCalibrateOptions {
  double mass = 0;                                            ///< kg/m²
  std::optional<double> drape;                                ///< 0 to 1
  std::optional<double> warp_length, weft_length, thickness;  ///< mm
  std::optional<double> kes_b_warp, kes_b_weft, kes_g, kes_emt_warp, kes_emt_weft;
  std::optional<double> fast_e100_warp, fast_e100_weft, fast_eb5;
  int drapes = 2;                   ///< a test, 1 to 6
  double particle_distance_mm = 0;  ///< of their triangles; 0: what fits the fabric
  bool json = false;
};

/// kUnsettled where the drape is not within a point.
ExitCode fabric_calibrate_command(const FabricCalibrateOptions& options);

/// Serves until SIGTERM or SIGINT.
ExitCode serve_command(const ServeOptions& options);

struct WorkerOptions {
  std::string store = "data";         ///< folder of a server's store
  int workers = 0;                    ///< drapes at once; 0: one for each core, at most kMostWorkers
  double checkpoint_every_s = 5;      ///< by the clock: what a crash can cost a drape
  jobs::JobLimits limits;             ///< of each drape
  std::optional<log::LogFormat> log;  ///< nothing: text on a terminal, else JSON
};

/// Drapes jobs of a store beside its server until SIGTERM or SIGINT.
ExitCode worker_command(const WorkerOptions& options);

struct SubmitOptions {
  std::string project;  ///< path of the document
  std::string job;      ///< id of one that was submitted before, in place of a project
  RemoteOptions remote;
  bool watch = false;      ///< follow the drape to its end
  std::string out;         ///< folder for the results; empty: they stay on the server
  bool no_stills = false;  ///< no pictures are drawn
  bool json = false;
};

ExitCode submit_command(const SubmitOptions& options);

struct SweepOptions {
  std::string project;                                     ///< path of the document
  std::vector<std::string> bodies{"own"}, fabrics{"own"};  ///< as people say them (sweep_bodies.h)
  std::string out;                                         ///< folder
  std::string server_said;  ///< address of a server; empty: this machine drapes
  RemoteOptions remote;     ///< but for the address
  std::string sweep;        ///< id of one that a server has, in place of a project
  bool json = false;
};

/// Drapes a garment on several bodies and of several fabrics; leaves a folder for each, a table and a sheet.
ExitCode sweep_command(const SweepOptions& options);

struct PatternImportOptions {
  std::string file;                 ///< path of a DXF file
  std::string size;                 ///< of a graded file; empty: its sample size
  std::string unit;                 ///< mm, cm or inch; empty: decided
  std::vector<std::string> layers;  ///< "3=sew": what layers stand for
  bool json = false;
  bool no_seams = false;  ///< leave out the search for seams, which may take seconds
};

ExitCode pattern_import_command(const PatternImportOptions& options);

struct PatternLayersOptions {
  std::string file;                 ///< path of a DXF file
  std::vector<std::string> layers;  ///< as of an import
  bool json = false;
};

/// Tells the layers of a DXF file, also of one in which no piece can be found.
ExitCode pattern_layers_command(const PatternLayersOptions& options);

struct PatternExportOptions {
  std::string project;       ///< path of the document
  std::string out;           ///< path of the file: .dxf, .svg or .pdf
  std::string paper = "a4";  ///< of a .pdf
  bool json = false;
};

ExitCode pattern_export_command(const PatternExportOptions& options);

struct ProjectNewOptions {
  std::string pattern;              ///< path of a DXF file or a GarmentCode specification
  std::string body;                 ///< path of a mesh
  std::string out;                  ///< path of the document
  double accept_seams = 0.8;        ///< least confidence of proposals that become seams (create::kSure)
  bool no_seams = false;            ///< no proposal becomes a seam
  std::vector<std::string> layers;  ///< as of an import
  bool json = false;
};

ExitCode project_new_command(const ProjectNewOptions& options);

struct ProjectArrangeOptions {
  std::string project;        ///< path of the document
  std::string out;            ///< path of the document to write; empty: the same
  std::string as = "matrix";  ///< or "box": sheets are told by the boxes of the body's parts
  bool json = false;
};

ExitCode project_arrange_command(const ProjectArrangeOptions& options);

struct MovieOptions {
  std::string source;                  ///< folder that toile drape left, its drape.film, or a trace
  std::string out;                     ///< the file
  std::string kind = "drape", format;  ///< format: empty: as the file's name ends
  std::string size;                    ///< "720x900"
  int fps = 25;
  std::optional<double> seconds;
  std::string trace;   ///< whose frames are shown instead of the film's; empty: the film's
  std::string stills;  ///< folder for pictures; empty: none
  int stills_every = 1;
  bool json = false;
};

/// Makes a movie of what a drape has left.
ExitCode movie_command(const MovieOptions& options);

struct RenderOptions {
  std::string source;  ///< as of a movie
  std::string out;     ///< the file
  std::string view = "three-quarter";
  std::string map;              ///< word of what the cloth is coloured by; empty: as it looks
  std::string size;             ///< "1024x1280"
  std::string eye, target;      ///< "x,y,z", m; an own camera, empty: the view's
  std::optional<double> angle;  ///< degrees, upright, of an own camera
  int samples = 4;
  bool transparent = false, json = false;
};

/// Takes a still of what a drape has left.
ExitCode render_command(const RenderOptions& options);

struct ExportOptions {
  std::string source;        ///< as of a movie
  std::string out;           ///< the file; its name tells the format
  std::string unit;          ///< mm, cm or m; empty: as suits the format
  std::optional<double> at;  ///< s of simulated time; nothing: the end
  bool body = false;         ///< with the bodies
  bool welded = false;       ///< one surface, sewn vertices once
  bool json = false;
};

/// Writes the model of a drape for other programs.
ExitCode export_command(const ExportOptions& options);

struct VerifyOptions {
  std::string source;   ///< folder of results, or its manifest.json
  std::string project;  ///< path of the document; empty: where the manifest says
  std::string from;     ///< as of a drape; empty: where the manifest says
  bool files_only = false, json = false;
};

/// Compares a drape's inputs and results with its manifest, drapes again and compares that. kNotSame where
/// anything differs.
ExitCode verify_command(const VerifyOptions& options);

struct SampleOptions {
  std::string name;  ///< empty: list what there is
  std::string out;   ///< folder
  std::string body;  ///< path of a mesh; empty: a mannequin
  std::string preset, sex;
  std::array<std::optional<double>, measure::kMeasureCount> measures_cm;  ///< of the mannequin, by Measure
  std::string cloth;  ///< one of the sample's; empty: the first
  bool json = false;
};

/// Drafts a garment for a body: a DXF file and a project beside it, ready to be draped.
ExitCode sample_command(const SampleOptions& options);

}  // namespace toile::app
