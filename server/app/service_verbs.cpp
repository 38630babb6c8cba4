#include "server/app/service_verbs.h"

#include <map>
#include <string>

#include "server/app/exit_codes_text.h"
#include "server/app/file_kinds.h"

namespace toile::app {
namespace {

constexpr double kMost = 1e12;

template <typename Number>
void add_limit(CLI::App& verb, const char* name, Number& value, const char* words) {
  verb.add_option(name, value, words)->check(CLI::Range(0.0, kMost))->group("Limits (0: none)");
}

/// What a drape may take, how it is kept, and how it is told: of whoever drapes.
void add_work(CLI::App& verb, int& workers, double& checkpoint_every_s, jobs::JobLimits& limits,
              std::optional<log::LogFormat>& log) {
  verb.add_option("--workers", workers, "Drapes at once (default: one for each core)")
      ->check(CLI::Range(1, kMostWorkers));
  verb.add_option("--checkpoint-every", checkpoint_every_s,
                  "Seconds between two checkpoints of a running drape: what a crash can cost it")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  add_limit(verb, "--most-seconds", limits.work_s, "Processor time of a drape, without its pictures");
  add_limit(verb, "--most-steps", limits.steps, "Steps of a drape");
  add_limit(verb, "--most-particles", limits.particles, "Particles of a garment");
  const std::map<std::string, log::LogFormat> formats{{"text", log::LogFormat::kText},
                                                      {"json", log::LogFormat::kJson}};
  verb.add_option("--log", log, "text or json (default: text on a terminal, else json)")
      ->transform(CLI::CheckedTransformer(formats, CLI::ignore_case));
}

/// What users may take, and how long things are kept.
void add_serve_limits(CLI::App& verb, ServeOptions& serve) {
  verb.add_option_function<double>(
          "--quota-mb",
          [&serve](double megabytes) { serve.quotas.bytes = static_cast<std::int64_t>(megabytes * 1e6); },
          "What a user may keep: uploads, documents and results, in MB")
      ->check(CLI::Range(0.0, kMost))
      ->group("Limits (0: none)");
  add_limit(verb, "--quota-jobs", serve.quotas.unfinished_jobs, "Drapes of a user that have not ended");
  add_limit(verb, "--keep-jobs", serve.retention.jobs_days,
            "Days after which a drape that has ended is removed");
  add_limit(verb, "--keep-uploads", serve.retention.uploads_days,
            "Days after which a file that nothing uses is removed");
}

CLI::App* add_serve(CLI::App& app, ServeOptions& serve) {
  CLI::App* verb = app.add_subcommand("serve", "Drape for programs and browsers of this machine, over HTTP");
  verb->add_option("--port", serve.port, "Port; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  verb->add_option("--data", serve.data, "Folder of projects, files and jobs; made when it is not there")
      ->capture_default_str();
  verb->add_flag("--no-workers", serve.no_workers, "Drape nothing here: toile worker does, beside it");
  verb->add_option("--address", serve.address,
                   "Address to listen on; any but the loopback's wants accounts, and TLS or a proxy")
      ->capture_default_str();
  CLI::Option* key =
      verb->add_option("--tls-key", serve.tls_key, "PEM file of the certificate's private key");
  verb->add_option("--tls-certificate", serve.tls_certificate,
                   "Speak TLS, with the certificate (and those between it and its root) of this PEM file")
      ->needs(key);
  key->needs("--tls-certificate");
  verb->add_flag(
      "--behind-proxy", serve.behind_proxy,
      "A proxy speaks TLS to others; it passes Host on and says X-Forwarded-For, and nobody else gets here");
  verb->add_flag(
      "--accounts", serve.accounts,
      "Let in only who is known (toile account). So it is once there is an account, also without this");
  verb->add_flag(
      "--container", serve.container,
      "Listen on any address, within a container whose port is published on the machine's loopback");
  verb->add_flag(
      "--webhooks-to-private", serve.webhooks_to_private,
      "Tell webhooks on the loopback and in private networks as well: users reach what this machine does");
  verb->add_option("--web", serve.web, "Folder of the built page (default: web/dist)");
  verb->add_option("--sample", serve.sample,
                   "Folder of the project that a new store begins with (default: samples/skirt)");
  verb->add_flag("--no-sample", serve.no_sample, "Begin a new store empty");
  add_work(*verb, serve.workers, serve.checkpoint_every_s, serve.limits, serve.log);
  add_serve_limits(*verb, serve);
  verb->footer(
      std::string("Prints its address once it answers. SIGTERM and Ctrl-C end it in good order: running\n"
                  "drapes go back to the queue, and the next start goes on where they stood. A certificate\n"
                  "that is renewed is taken up by itself, and at once at SIGHUP.\n\n"
                  "Examples:\n"
                  "  toile serve\n"
                  "  toile serve --port 0 --data /tmp/toile --workers 1\n\n") +
      kExitCodes);
  return verb;
}

/// How a server is asked, beside its address.
void add_remote(CLI::App& verb, RemoteOptions& remote) {
  verb.add_option("--roots", remote.roots,
                  "PEM file of who may vouch for an https server (default: as this machine has it)");
  verb.add_option("--token-file", remote.token_file,
                  "File with the token to be known by (default: what TOILE_TOKEN says)");
  verb.add_option("--patience", remote.patience_s,
                  "Seconds for which a server that has answered before is waited for")
      ->check(CLI::Range(0.0, 86400.0))
      ->capture_default_str();
}

CLI::App* add_submit(CLI::App& app, SubmitOptions& submit) {
  CLI::App* verb = app.add_subcommand("submit", "Have a project draped by a server");
  CLI::Option* project =
      verb->add_option("project", submit.project, "Project document; the files that it names lie beside it")
          ->check(not_a_project);
  CLI::Option* job =
      verb->add_option("--job", submit.job, "Id of a drape that was submitted before, in place of a project");
  job->excludes(project);
  verb->add_option("--server", submit.remote.server, "Address of the server")->capture_default_str();
  CLI::Option* watch =
      verb->add_flag("--watch", submit.watch, "Follow the drape to its end; Ctrl-C cancels it");
  verb->add_option("-o,--out", submit.out, "Folder for the results, as toile drape leaves them")
      ->needs(watch);
  verb->add_flag("--no-stills", submit.no_stills, "Draw no pictures");
  add_remote(*verb, submit.remote);
  verb->callback([project, job] {
    if (!project->count() && !job->count()) throw CLI::RequiredError("project");
  });
  verb->add_flag("--json", submit.json, "Print the report (without --watch the job) as JSON, errors as well");
  verb->footer(
      std::string(
          "Files that the server has are not sent again. Without --watch the job's id is printed and the\n"
          "server goes on by itself, when it has time. A line that breaks is waited for; --job takes a\n"
          "drape up again, and what of its results is here already is not fetched again.\n\n"
          "Examples:\n"
          "  toile submit samples/skirt/project.json --watch --out out/skirt\n"
          "  toile submit project.json --server http://127.0.0.1:9000\n"
          "  toile submit --job j_1qedqq1nd5hfbjxpm78j --watch --out out/skirt\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_sweep(CLI::App& app, SweepOptions& sweep) {
  CLI::App* verb = app.add_subcommand("sweep", "Drape a project on several bodies and of several fabrics");
  CLI::Option* project =
      verb->add_option("project", sweep.project, "Project document; the files that it names lie beside it")
          ->check(not_a_project);
  verb->add_option(
      "--body", sweep.bodies,
      "A row: a preset with measures over it (eu40,waist=80), measures (bust=92,waist=74), a mesh\n"
      "file, or own, the project's (default)");
  verb->add_option(
      "--fabric", sweep.fabrics,
      "A column: a fabric of the library or of the document for what most pieces are cut of, or\n"
      "own, as the project has it (default)");
  verb->add_option("-o,--out", sweep.out, "Folder for the table, the sheet and a folder of each drape")
      ->required();
  CLI::Option* server = verb->add_option("--server", sweep.server_said,
                                         "Address of a server that drapes them (default: this machine does)");
  CLI::Option* id =
      verb->add_option("--sweep", sweep.sweep, "Id of a sweep that the server has, in place of a project");
  id->needs(server)->excludes(project);
  add_remote(*verb, sweep.remote);
  verb->callback([project, id] {
    if (!project->count() && !id->count()) throw CLI::RequiredError("project");
  });
  verb->add_flag("--json", sweep.json, "Print the table as JSON, errors as well");
  verb->footer(
      std::string(
          "Leaves table.csv, table.json, sheet.png (small stills in rows of bodies and columns of fabrics)\n"
          "and BODY_FABRIC/ with each drape's project and results, as toile drape leaves them. Here they "
          "are\n"
          "draped one after the other; Ctrl-C ends them all. The exit code is that of the worst.\n\n"
          "Examples:\n"
          "  toile sweep samples/skirt/project.json --body eu36 --body eu40 --fabric poplin --fabric twill "
          "-o out/sweep\n"
          "  toile sweep project.json --body own eu40,waist=82 --fabric own single-jersey -o out/sweep "
          "--server http://127.0.0.1:8460\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_worker(CLI::App& app, WorkerOptions& worker) {
  CLI::App* verb =
      app.add_subcommand("worker", "Drape for a server of this machine, in a process of its own");
  verb->add_option("--store", worker.store, "Folder of the server's store: its --data")
      ->capture_default_str();
  add_work(*verb, worker.workers, worker.checkpoint_every_s, worker.limits, worker.log);
  verb->footer(
      std::string(
          "Any number of them may work beside a server and each other. Each drape has one holder at a\n"
          "time; what a process leaves that breaks down, the others go on with from its last checkpoint.\n\n"
          "Examples:\n"
          "  toile serve --no-workers & toile worker --store data\n"
          "  toile worker --store /srv/toile --workers 4\n\n") +
      kExitCodes);
  return verb;
}

}  // namespace

ServiceVerbs::ServiceVerbs(CLI::App& app)
    : serve_verb_(add_serve(app, serve_)),
      worker_verb_(add_worker(app, worker_)),
      submit_verb_(add_submit(app, submit_)),
      sweep_verb_(add_sweep(app, sweep_)) {}

std::optional<ExitCode> ServiceVerbs::run() const {
  if (serve_verb_->parsed()) return serve_command(serve_);
  if (worker_verb_->parsed()) return worker_command(worker_);
  if (submit_verb_->parsed()) return submit_command(submit_);
  if (sweep_verb_->parsed()) return sweep_command(sweep_);
  return std::nullopt;
}

}  // namespace toile::app
