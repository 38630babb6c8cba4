#include "server/app/result_verbs.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "core/analysis/cloth_map.h"
#include "server/app/exit_codes_text.h"
#include "server/render/camera.h"

namespace toile::app {
namespace {

CLI::App* add_movie(CLI::App& app, MovieOptions& movie) {
  CLI::App* verb =
      app.add_subcommand("movie", "Make a movie of a drape: how it came about, or its end turned");
  verb->add_option("result", movie.source, "Folder that toile drape has left, its drape.film, or a trace")
      ->required();
  verb->add_option("-o,--out", movie.out, "File to write; .mp4 (H.264) or .avi (Motion JPEG)")->required();
  verb->add_option("--of", movie.kind, "drape: from the pieces to the end; turntable: the end, turned once")
      ->check(CLI::IsMember({"drape", "turntable"}))
      ->capture_default_str();
  verb->add_option("--format", movie.format, "mp4 or avi (default: as the file's name ends)")
      ->check(CLI::IsMember({"mp4", "avi"}));
  verb->add_option("--size", movie.size, "Pixels, even, 64 to 4096 each (default: 720x900)")
      ->type_name("WxH");
  verb->add_option("--fps", movie.fps, "Pictures a second, 1 to 60")->capture_default_str();
  verb->add_option("--seconds", movie.seconds,
                   "How long it lasts (default: a drape as long as it did, but 20 s at most; a turn 8 s)");
  verb->add_option("--trace", movie.trace, "Show the frames of this trace: drape --trace keeps every one");
  CLI::Option* stills =
      verb->add_option("--stills", movie.stills, "Also write its pictures as PNG into this folder");
  verb->add_option("--stills-every", movie.stills_every, "Of each so many pictures write one")->needs(stills);
  verb->add_flag("--json", movie.json, "Print as JSON, errors as well");
  verb->footer(
      std::string("Needs ffmpeg (Debian's package ffmpeg). Ctrl-C ends it and leaves no file.\n\n"
                  "Examples:\n"
                  "  toile movie out/skirt --out skirt.mp4\n"
                  "  toile movie out/skirt --of turntable --size 1080x1350 --out turn.mp4\n"
                  "  toile movie out/skirt --out skirt.avi --stills out/frames --stills-every 5\n\n") +
      kExitCodes);
  return verb;
}

std::vector<std::string> map_words() {
  std::vector<std::string> words;
  for (const analysis::MapTrait& trait : analysis::map_traits()) words.emplace_back(trait.word);
  return words;
}

CLI::App* add_render(CLI::App& app, RenderOptions& still) {
  CLI::App* verb = app.add_subcommand("render", "Take a still of a drape, from any side and in any size");
  verb->add_option("result", still.source, "Folder that toile drape has left, its drape.film, or a trace")
      ->required();
  verb->add_option("-o,--out", still.out, "PNG file to write")->required();
  CLI::Option* view = verb->add_option("--view", still.view, "From where; the body faces the front")
                          ->check(CLI::IsMember(render::view_words()))
                          ->capture_default_str();
  verb->add_option("--map", still.map, "Colour the cloth by what it is measured for, with a legend")
      ->check(CLI::IsMember(map_words()));
  verb->add_option("--size", still.size, "Pixels, 16 to 4096 each (default: 1024x1280)")->type_name("WxH");
  CLI::Option* eye =
      verb->add_option("--eye", still.eye, "Where the camera stands, m; +y is up, +z the front")
          ->type_name("X,Y,Z")
          ->excludes(view);
  verb->add_option("--target", still.target, "What it looks at, m (default: the middle of the cloth)")
      ->type_name("X,Y,Z")
      ->needs(eye);
  verb->add_option("--angle", still.angle,
                   "How much it sees from top to bottom, degrees, 1 to 120 (default: 21.5)")
      ->needs(eye);
  verb->add_flag("--transparent", still.transparent,
                 "Without ground and backdrop: PNG with an alpha channel");
  verb->add_option("--samples", still.samples, "Of each pixel: 1, 4 or 16")
      ->check(CLI::IsMember({1, 4, 16}))
      ->capture_default_str();
  verb->add_flag("--json", still.json, "Print as JSON, errors as well");
  verb->footer(std::string("Examples:\n"
                           "  toile render out/skirt --view back --out back.png\n"
                           "  toile render out/skirt --map pressure --out pressure.png\n"
                           "  toile render out/skirt --size 4096x4096 --transparent --out large.png\n"
                           "  toile render out/skirt --eye 0.5,1.1,0.9 --target 0,1,0 --out waist.png\n\n") +
               kExitCodes);
  return verb;
}

CLI::App* add_export(CLI::App& app, ExportOptions& model) {
  CLI::App* verb = app.add_subcommand("export", "Write the model of a drape for other programs");
  verb->add_option("result", model.source, "Folder that toile drape has left, its drape.film, or a trace")
      ->required();
  verb->add_option("-o,--out", model.out, "File to write: .ply, .stl, .obj (a .mtl comes with it) or .dae")
      ->required();
  verb->add_flag("--body", model.body, "With the body");
  verb->add_flag("--welded", model.welded, "One surface, sewn edges joined, instead of one a piece");
  verb->add_option("--unit", model.unit, "Of the numbers in the file (default: m, of STL mm)")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  verb->add_option("--at", model.at, "How it was at this time of the drape, s (default: at its end)");
  verb->add_flag("--json", model.json, "Print as JSON, errors as well");
  verb->footer(
      std::string("final.glb has pictures and normals; this is for what does not take it. y is up.\n\n"
                  "Examples:\n"
                  "  toile export out/skirt --out skirt.ply\n"
                  "  toile export out/skirt --welded --body --out print.stl\n"
                  "  toile export out/skirt --at 0.5 --out sewing.obj\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_verify(CLI::App& app, VerifyOptions& verify) {
  CLI::App* verb = app.add_subcommand(
      "verify", "Drape again what results were made of, and see that the bytes are the same");
  verb->add_option("result", verify.source, "Folder with manifest.json, as a drape or a job has left it")
      ->required();
  verb->add_option("--project", verify.project, "The project document (default: where the manifest says)");
  verb->add_option("--from", verify.from, "What the drape went on from (default: where the manifest says)");
  verb->add_flag("--files-only", verify.files_only, "Compare the files; do not drape again");
  verb->add_flag("--json", verify.json, "Print as JSON, errors as well");
  verb->footer(std::string("Examples:\n"
                           "  toile verify out/skirt\n"
                           "  toile verify out/remote --project samples/skirt/project.json\n\n") +
               kExitCodes);
  return verb;
}

}  // namespace

ResultVerbs::ResultVerbs(CLI::App& app)
    : movie_(add_movie(app, movie_options_)),
      render_(add_render(app, render_options_)),
      export_(add_export(app, export_options_)),
      verify_(add_verify(app, verify_options_)) {}

std::optional<ExitCode> ResultVerbs::run() const {
  if (movie_->parsed()) return movie_command(movie_options_);
  if (render_->parsed()) return render_command(render_options_);
  if (export_->parsed()) return export_command(export_options_);
  if (verify_->parsed()) return verify_command(verify_options_);
  return std::nullopt;
}

}  // namespace toile::app
