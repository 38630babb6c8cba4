#include "server/app/sweep_afar.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/write_file.h"
#include "core/project/bodies.h"
#include "server/app/bring_home.h"
#include "server/app/console.h"
#include "server/app/interrupt.h"
#include "server/app/progress_bar.h"
#include "server/app/remote.h"
#include "server/app/send_project.h"
#include "server/app/sweep_bodies.h"
#include "server/app/sweep_table.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;
using json::JsonMember;
using json::JsonValue;

constexpr auto kPollOfSweep = std::chrono::milliseconds(500);

Result<JsonValue> body_wish(Remote& remote, const std::string& said) {
  const BodyWord body = TRY(read_body_word(said));
  if (body.own) return JsonValue(std::vector<JsonMember>());
  if (body.mannequin)
    return JsonValue(std::vector<JsonMember>{{"mannequin", project::mannequin_json(*body.mannequin)}});
  const std::string bytes = TRY(read_upload(body.file, said));
  const std::string id = TRY(remote.upload("body", fs::path(body.file).filename().string(), bytes));
  return JsonValue(std::vector<JsonMember>{{"asset", id}});
}

/// The sweep that the options ask for: made now, or one of before.
Result<JsonValue> asked_for(Remote& remote, const SweepOptions& options) {
  if (!options.sweep.empty()) return remote.show("sweeps/" + percent_encoded(options.sweep));
  std::vector<JsonValue> bodies, fabrics;
  for (const std::string& said : options.bodies) {
    JsonValue body = TRY(body_wish(remote, said));
    bodies.push_back(std::move(body));
  }
  for (const std::string& said : options.fabrics)
    fabrics.push_back(said == "own" ? JsonValue(std::vector<JsonMember>()) : JsonValue(said));
  const std::string project = TRY(send_project(remote, options.project));
  return remote.submit_sweep(std::vector<JsonMember>{
      {"project_id", project}, {"bodies", std::move(bodies)}, {"fabrics", std::move(fabrics)}});
}

bool is_true(const JsonValue& in, std::string_view key) {
  const JsonValue* value = in.find(key);
  return value && value->boolean() && *value->boolean();
}

/// To its end. Ctrl-C cancels it.
Result<JsonValue> follow_sweep(Remote& remote, const std::string& id) {
  const std::atomic<bool>& interrupted = cancel_on_interrupt();
  ProgressBar bar;
  bool told = false;
  for (;;) {
    if (interrupted && !told) told = remote.cancel("sweeps/" + id).ok();
    JsonValue sweep = TRY(remote.show("sweeps/" + id));
    if (is_true(sweep, "ended")) return sweep;
    const JsonValue* fraction = sweep.find("fraction");
    bar.show({"sweep", fraction && fraction->number() ? *fraction->number() : 0});
    std::this_thread::sleep_for(kPollOfSweep);
  }
}

Error malformed(const std::string& id) {
  return {"client.malformed", "the server's answer is no sweep", id, ErrorKind::kSystem};
}

Result<sweep::Table> table_from(const JsonValue& shown, const std::string& id) {
  sweep::Table table;
  table.name = text_member(shown, "name");
  for (auto& [key, labels] : {std::pair{"bodies", &table.bodies}, std::pair{"fabrics", &table.fabrics}}) {
    const JsonValue* list = shown.find(key);
    if (!list || !list->array()) return malformed(id);
    for (const JsonValue& label : *list->array()) labels->push_back(label.text() ? *label.text() : "");
  }
  const JsonValue* cells = shown.find("cells");
  if (!cells || !cells->array() || cells->array()->size() != table.bodies.size() * table.fabrics.size())
    return malformed(id);
  for (const JsonValue& cell : *cells->array()) table.cells.push_back(sweep::cell_from(cell));
  return table;
}

/// What each drape has left, and over it table and sheet.
Status bring_all(Remote& remote, const sweep::Table& table, const fs::path& folder) {
  for (std::size_t body = 0; body < table.bodies.size(); ++body) {
    for (std::size_t fabric = 0; fabric < table.fabrics.size(); ++fabric) {
      const sweep::Cell& cell = table.at(body, fabric);
      if (cell.job.empty()) continue;
      TRY(bring_home(remote, cell.job, folder / cell_folder(table.bodies[body], table.fabrics[fabric])));
    }
  }
  return write_table(table, folder);
}

ExitCode fail_on_the_way(Error error, const std::string& id, const SweepOptions& options) {
  if (error.kind == ErrorKind::kUnavailable)
    error.message += "; the server may go on by itself: toile sweep --sweep " + id + " takes it up again";
  return fail_remote(error, options.json);
}

}  // namespace

ExitCode sweep_afar(const SweepOptions& options) {
  RemoteOptions where = options.remote;
  where.server = options.server_said;
  Result<Remote> remote = Remote::make(where);
  if (!remote) return fail(remote.error(), options.json);
  const Result<JsonValue> sweep = asked_for(*remote, options);
  if (!sweep) return fail_remote(sweep.error(), options.json);
  const std::string id = text_member(*sweep, "id");
  if (!options.json) std::fprintf(stderr, "sweep %s\n", id.c_str());
  const Result<JsonValue> ended = follow_sweep(*remote, id);
  if (!ended) return fail_on_the_way(ended.error(), id, options);
  const Result<sweep::Table> table = table_from(*ended, id);
  if (!table) return fail_remote(table.error(), options.json);
  if (Status home = bring_all(*remote, *table, options.out); !home)
    return fail_on_the_way(home.error(), id, options);
  options.json ? static_cast<void>(std::printf("%s", table_json(*table).c_str())) : print_table(*table);
  return exit_code_of(*table);
}

}  // namespace toile::app
