#include "server/app/service_verbs.h"

#include <map>
#include <string>

#include "server/app/exit_codes_text.h"

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
                  "drapes go back to the queue, and the next start goes on where they stood.\n\n"
                  "Examples:\n"
                  "  toile serve\n"
                  "  toile serve --port 0 --data /tmp/toile --workers 1\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_submit(CLI::App& app, SubmitOptions& submit) {
  CLI::App* verb = app.add_subcommand("submit", "Have a project draped by a server");
  verb->add_option("project", submit.project, "Project document; the files that it names lie beside it")
      ->required();
  verb->add_option("--server", submit.server, "Address of the server")->capture_default_str();
  CLI::Option* watch =
      verb->add_flag("--watch", submit.watch, "Follow the drape to its end; Ctrl-C cancels it");
  verb->add_option("-o,--out", submit.out, "Folder for the results, as toile drape leaves them")
      ->needs(watch);
  verb->add_option("--roots", submit.roots,
                   "PEM file of who may vouch for an https server (default: as this machine has it)");
  verb->add_option("--token-file", submit.token_file,
                   "File with the token to be known by (default: what TOILE_TOKEN says)");
  verb->add_flag("--json", submit.json, "Print the report (without --watch the job) as JSON, errors as well");
  verb->footer(
      std::string(
          "Without --watch the job's id is printed and the server goes on by itself, when it has time.\n\n"
          "Examples:\n"
          "  toile submit samples/skirt/project.json --watch --out out/skirt\n"
          "  toile submit project.json --server http://127.0.0.1:9000\n\n") +
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
      submit_verb_(add_submit(app, submit_)) {}

std::optional<ExitCode> ServiceVerbs::run() const {
  if (serve_verb_->parsed()) return serve_command(serve_);
  if (worker_verb_->parsed()) return worker_command(worker_);
  if (submit_verb_->parsed()) return submit_command(submit_);
  return std::nullopt;
}

}  // namespace toile::app
