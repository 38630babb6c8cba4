// Runs the tasks that other cloth simulators were given:
//   bench_peers T1|T2|T3|T4 --tasks DIR --out DIR [--mode drape|dynamic] [--time-step S] [--turn DEGREES]
//               [--shuffle SEED] [--flip] [--bend-factor F] [--csv FILE --label TEXT]
// and some settings for trials: [--settle-speed M/S] [--viscosity 1/S] [--friction F]. Writes final.obj,
// after.obj (one second of true motion later), prev.obj (0.04 s before that), most_contact.obj and info.json.
// --csv adds a line to a table of figures (tests/bench/peers.csv is the one that is kept), with a label of
// one's own. Ends with 0 when no frame has a crossing and the cloth is at rest. See README.md beside this.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/write_file.h"
#include "core/exports/write_obj.h"
#include "tests/bench/peer_run.h"

namespace toile::peers {
namespace {

struct Options {
  std::string task, tasks, out;
  std::string csv, label;  ///< a table to add the figures to, and what this run is called there
  Disguise disguise;
  RunSettings run;
};

Error bad_option(const std::string& what) { return {"bench.usage", "see the head of bench_peers.cpp", what}; }

bool parse_number(const std::string& text, double& number) {
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

Status set_number(Options& o, const std::string& key, double value) {
  const std::map<std::string, double*> numbers{
      {"--time-step", &o.run.time_step},          {"--turn", &o.disguise.turn_degrees},
      {"--bend-factor", &o.run.bend_factor},      {"--settle-speed", &o.run.settle_speed},
      {"--viscosity", &o.run.viscosity},          {"--friction", &o.run.friction},
      {"--stretch-factor", &o.run.stretch_factor}};
  const auto found = numbers.find(key);
  if (key == "--shuffle") {
    o.disguise.shuffle = static_cast<std::uint64_t>(value);
  } else if (found != numbers.end()) {
    *found->second = value;
  } else {
    return bad_option(key);
  }
  if (key != "--turn" && value < 0) return bad_option(key + " below zero");
  return {};
}

Result<Options> parse(int count, char** words) {
  Options o;
  for (int i = 1; i < count; ++i) {
    const std::string key = words[i];
    if (key == "--flip") {
      o.disguise.flip = true;
    } else if (key == "--trace") {
      o.run.trace = true;
    } else if (!key.starts_with("--")) {
      o.task = key;
    } else if (++i == count) {
      return bad_option(key + " without a value");
    } else if (key == "--tasks") {
      o.tasks = words[i];
    } else if (key == "--out") {
      o.out = words[i];
    } else if (key == "--csv") {
      o.csv = words[i];
    } else if (key == "--label") {
      o.label = words[i];
    } else if (key == "--mode") {
      o.run.dynamic = std::string(words[i]) == "dynamic";
      if (!o.run.dynamic && std::string(words[i]) != "drape") return bad_option(words[i]);
    } else {
      double value = 0;
      if (!parse_number(words[i], value)) return bad_option(key + " " + words[i]);
      TRY(set_number(o, key, value));
    }
  }
  if (o.task.empty() || o.tasks.empty() || o.out.empty())
    return bad_option("task, --tasks and --out are needed");
  return o;
}

std::string info_json(const Options& o, const PeerEnd& end) {
  const material::Fabric f = fabric_of(o.run);
  std::string text = "{\n";
  const auto word = [&](const char* key, const std::string& value) {
    text += std::string("  \"") + key + "\": \"" + value + "\",\n";
  };
  const auto number = [&](const char* key, double value) {
    char line[96];
    std::snprintf(line, sizeof line, "  \"%s\": %.9g,\n", key, value);
    text += line;
  };
  word("peer", "toile");
  word("task", o.task);
  word("mode", o.run.dynamic ? "dynamic" : "drape");
  char fabric[320];
  std::snprintf(fabric, sizeof fabric,
                "  \"fabric\": {\"areal_mass\": %g, \"stretch_warp\": %.6g, \"stretch_weft\": %.6g, "
                "\"stretch_coupling\": %.6g, \"stretch_shear\": %.6g, \"bend\": %g, \"thickness\": %g, "
                "\"friction\": %g, \"strain_limit\": null},\n",
                f.areal_mass, f.stretch_warp, f.stretch_weft, f.stretch_coupling, f.stretch_shear,
                f.bend_warp, f.thickness, f.friction);
  text += fabric;
  number("cpu_s", end.cpu_s);
  number("user_s", end.cpu_s);
  number("wall_s", end.wall_s);
  number("steps", end.steps);
  number("time_step", end.time_step);
  number("rest_at_s", end.rest_at);
  number("simulated_s", end.steps * end.time_step);
  number("dt_out", 0.04);
  word("stop_reason", end.stop_reason);
  number("detections", static_cast<double>(end.detections));
  number("measured", static_cast<double>(end.measured));  // vertices, in all of them
  number("bounded", static_cast<double>(end.bounded));
  number("most_bounded", end.most_bounded);
  number("frames_checked", end.worst.frames);
  number("worst_body_crossings", end.worst.body_crossings);
  number("worst_self_crossings", end.worst.self_crossings);
  number("weld_gap_mm", 1e3 * end.weld_gap);
  number("seam_gap_mm", 1e3 * end.final_gap);
  char rest[256];
  std::snprintf(rest, sizeof rest,
                "  \"rest\": {\"passes\": %s, \"moved_over_5mm\": %.6g, \"largest_move_mm\": %.4g, "
                "\"rms_speed\": %.4g, \"max_speed\": %.4g}\n}\n",
                end.rest.passes() ? "true" : "false", end.rest.moved_share, 1e3 * end.rest.largest_move,
                end.rest.rms_speed, end.rest.max_speed);
  return text + rest;
}

/// One line a run, so that figures of one task stand below each other from change to change.
Status add_to_table(const Options& o, const PeerEnd& end) {
  const bool is_new = !std::filesystem::exists(o.csv);
  std::FILE* table = std::fopen(o.csv.c_str(), "a");
  if (table == nullptr)
    return Error{"bench.csv", "the table cannot be written; name one in a folder of yours", o.csv};
  if (is_new) {
    std::fputs(
        "label,task,cpu_s,steps,rest_at_s,frames_checked,crossings,seam_gap_mm,moved_over_5mm,largest_move_"
        "mm\n",
        table);
  }
  std::fprintf(table, "%s,%s,%.3f,%d,%.4f,%d,%d,%.4f,%.5f,%.3f\n", o.label.c_str(), o.task.c_str(), end.cpu_s,
               end.steps, end.rest_at, end.worst.frames, end.worst.body_crossings + end.worst.self_crossings,
               1e3 * end.final_gap, end.rest.moved_share, 1e3 * end.rest.largest_move);
  if (std::fclose(table) != 0) return Error{"bench.csv", "the table could not be written to its end", o.csv};
  return {};
}

Status write_all(const Options& o, const DisguisedTask& put, const PeerTask& task, const PeerEnd& end) {
  std::error_code ignored;  // a folder that cannot be made shows at the first file
  std::filesystem::create_directories(o.out, ignored);
  const std::filesystem::path out = o.out;
  const std::pair<const char*, const std::vector<Vec3>*> files[] = {{"final.obj", &end.final_positions},
                                                                    {"after.obj", &end.rest.end},
                                                                    {"prev.obj", &end.rest.before},
                                                                    {"most_contact.obj", &end.most_contact}};
  for (const auto& [name, positions] : files) {
    if (positions->empty()) continue;
    TRY(exports::write_obj(out / name, put.undo(*positions), task.cloth.triangles));
  }
  return write_file(out / "info.json", info_json(o, end));
}

int run(int count, char** words) {
  const auto fail = [](const Error& error) {
    std::fprintf(stderr, "%s\n", to_string(error).c_str());
    return 2;
  };
  const Result<Options> options = parse(count, words);
  if (!options) return fail(options.error());
  const Result<PeerTask> task = read_task(options->tasks, options->task);
  if (!task) return fail(task.error());
  const DisguisedTask put = put_on(*task, options->disguise);
  const PeerEnd end = run_task(put.task, options->run);
  if (const Status status = write_all(*options, put, *task, end); !status) return fail(status.error());
  if (!options->csv.empty()) {
    if (const Status status = add_to_table(*options, end); !status) return fail(status.error());
  }
  std::fputs(info_json(*options, end).c_str(), stdout);
  const bool clean = end.worst.body_crossings + end.worst.self_crossings == 0;
  return clean && end.rest.passes() ? 0 : 1;
}

}  // namespace
}  // namespace toile::peers

int main(int count, char** words) { return toile::peers::run(count, words); }
