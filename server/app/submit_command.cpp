#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <utility>

#include "core/base/names.h"
#include "server/app/bring_home.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/interrupt.h"
#include "server/app/progress_bar.h"
#include "server/app/remote.h"
#include "server/app/send_project.h"
#include "server/store/job_state.h"

namespace toile::app {
namespace {

constexpr auto kPollOfJob = std::chrono::milliseconds(200);

Result<store::JobState> state_of(const json::JsonValue& job) {
  const std::string word = text_member(job, "state");
  const Result<store::JobState> state = store::job_state_from(word);
  if (state) return *state;
  return Error{"client.malformed", "the server names a state of the job that this program does not know",
               word, ErrorKind::kSystem};
}

void show(ProgressBar& bar, const json::JsonValue& job) {
  const json::JsonValue* progress = job.find("progress");
  if (!progress || !progress->object()) return;
  const std::string phase = text_member(*progress, "phase");
  const json::JsonValue* fraction = progress->find("fraction");
  bar.show({phase, fraction && fraction->number() ? *fraction->number() : 0});
}

/// Follows a job to its end. Ctrl-C cancels it.
Result<json::JsonValue> follow_job(Remote& remote, const std::string& id) {
  const std::atomic<bool>& interrupted = cancel_on_interrupt();
  ProgressBar bar;
  bool told = false;
  for (;;) {
    if (interrupted && !told) told = remote.cancel("jobs/" + id).ok();
    json::JsonValue job = TRY(remote.show("jobs/" + id));
    const store::JobState state = TRY(state_of(job));
    if (store::is_final(state)) return job;
    show(bar, job);
    std::this_thread::sleep_for(kPollOfJob);
  }
}

void print_end(const json::JsonValue& job, const SubmitOptions& options) {
  const json::JsonValue* report = job.find("report");
  if (options.json) {
    std::printf(
        "%s", report && report->object() ? json::write_json(*report).c_str() : json::write_json(job).c_str());
    return;
  }
  std::printf("%s: %s, %s (%s)\n", clipped(text_member(job, "name")).c_str(),
              text_member(job, "state").c_str(), clipped(text_member(job, "reason"), 300).c_str(),
              text_member(job, "reason_code").c_str());
  if (!options.out.empty()) std::printf("  results    %s\n", options.out.c_str());
}

/// With the way to go on where the server or the line was lost; the drape itself goes on without us.
ExitCode fail_on_the_way(Error error, const std::string& id, const SubmitOptions& options) {
  if (error.kind == ErrorKind::kUnavailable)
    error.message +=
        "; the server may go on by itself: toile submit --job " + id + " --watch takes it up again";
  return fail_remote(error, options.json);
}

ExitCode watch(Remote& remote, const std::string& id, const SubmitOptions& options) {
  const Result<json::JsonValue> job = follow_job(remote, id);
  if (!job) return fail_on_the_way(job.error(), id, options);
  if (text_member(*job, "state") == store::name_of(store::JobState::kFailed)) {
    return fail(told_by_server(text_member(*job, "reason_code"), text_member(*job, "reason"),
                               text_member(*job, "reason_where")),
                options.json);
  }
  if (!options.out.empty()) {
    if (Status home = bring_home(remote, id, options.out); !home)
      return fail_on_the_way(home.error(), id, options);
  }
  print_end(*job, options);
  return exit_code_of_end(text_member(*job, "state"), job->find("report"));
}

/// The job that the options ask for: made now, or one of before.
Result<json::JsonValue> asked_for(Remote& remote, const SubmitOptions& options) {
  if (!options.job.empty()) return remote.show("jobs/" + percent_encoded(options.job));
  const std::string project = TRY(send_project(remote, options.project));
  return remote.submit(project, options.watch ? store::JobPriority::kInteractive : store::JobPriority::kBatch,
                       !options.no_stills);
}

}  // namespace

ExitCode submit_command(const SubmitOptions& options) {
  Result<Remote> remote = Remote::make(options.remote);
  if (!remote) return fail(remote.error(), options.json);
  const Result<json::JsonValue> job = asked_for(*remote, options);
  if (!job) return fail_remote(job.error(), options.json);
  const std::string id = text_member(*job, "id");
  if (options.watch) return watch(*remote, id, options);
  if (options.json) {
    std::printf("%s", json::write_json(*job).c_str());
  } else {
    std::printf("%s\n", id.c_str());
  }
  return kDone;
}

}  // namespace toile::app
