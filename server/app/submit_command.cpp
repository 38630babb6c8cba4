#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/names.h"
#include "core/base/write_file.h"
#include "core/project/project.h"
#include "core/project/resolve/resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/interrupt.h"
#include "server/app/progress_bar.h"
#include "server/app/read_token.h"
#include "server/app/remote.h"
#include "server/documents/assets.h"
#include "server/documents/used_files.h"
#include "server/store/job_state.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kPoll = std::chrono::milliseconds(200);
constexpr auto kPatience = std::chrono::seconds(30);  // with a server that does not answer while a drape runs

/// A file beside the document, as it goes to the server.
Result<std::string> read_file(const fs::path& path, const std::string& where) {
  std::error_code failure;
  const auto size = fs::is_regular_file(path, failure) ? fs::file_size(path, failure) : 0;
  if (!failure && size > documents::kMostBodyBytes) {
    return Error{"project.too_large", "the file has more than the 100 MiB that are allowed", where,
                 ErrorKind::kTooLarge};
  }
  std::ifstream in(path, std::ios::binary);
  if (failure || !fs::is_regular_file(path, failure) || !in) {
    return Error{"project.file", "cannot read " + in_quotes(path.filename().string()), where};
  }
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

/// Sends the document and what it names; the new project's id.
Result<std::string> send_project(Remote& remote, const std::string& path) {
  const std::string document = TRY(resolve::read_project_text(path));
  const project::Project project = TRY(project::parse_project(document));
  std::vector<std::pair<std::string, std::string>> files;
  std::map<std::string, std::string> sent;
  for (const documents::UsedFile& used : documents::used_files(project)) {
    if (sent.contains(used.name)) continue;
    if (Status name = resolve::check_file_name(used.name); !name) return placed_at(name.error(), used.where);
    const std::string bytes = TRY(read_file(fs::path(path).parent_path() / used.name, used.where));
    const std::string id = TRY(remote.upload(used.kind, fs::path(used.name).filename().string(), bytes));
    sent[used.name] = id;
    files.emplace_back(used.name, id);
  }
  return remote.create_project(document, files);
}

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

/// Follows a job to its end. Ctrl-C cancels it. A server that is away for a moment is waited for.
Result<json::JsonValue> follow(Remote& remote, const std::string& id) {
  const std::atomic<bool>& interrupted = cancel_on_interrupt();
  ProgressBar bar;
  bool cancelled = false;
  Clock::time_point heard = Clock::now();
  for (;;) {
    if (interrupted && !cancelled) cancelled = remote.cancel(id).ok();
    Result<json::JsonValue> job = remote.job(id);
    if (job) {
      heard = Clock::now();
      const store::JobState state = TRY(state_of(*job));
      if (store::is_final(state)) return job;
      show(bar, *job);
    } else if (job.error().kind != ErrorKind::kUnavailable || Clock::now() - heard > kPatience) {
      return job;
    }
    std::this_thread::sleep_for(kPoll);
  }
}

/// Every result of the job into `folder`.
Status bring_home(Remote& remote, const json::JsonValue& job, const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) {
    return Error{"usage.out", "cannot make the folder for the results", folder.string()};
  }
  const json::JsonValue* results = job.find("results");
  if (!results || !results->object()) return {};
  for (const json::JsonMember& file : *results->object()) {
    if (file.key.find('/') != std::string::npos || !resolve::check_file_name(file.key).ok()) {
      return Error{"client.malformed", "the server names a result " + in_quotes(file.key), "",
                   ErrorKind::kSystem};
    }
    const std::string bytes = TRY(remote.result(text_member(job, "id"), file.key));
    TRY(write_file(folder / file.key, bytes));
  }
  return {};
}

ExitCode exit_code_of(store::JobState end, const json::JsonValue& job) {
  if (end == store::JobState::kCancelled) return kCancelled;
  const json::JsonValue* report = job.find("report");
  const json::JsonValue* settled = report ? report->find("settled") : nullptr;
  return settled && settled->boolean() && *settled->boolean() ? kDone : kUnsettled;
}

ExitCode fail_remote(const Error& error, bool json) {
  print_error(error, json);
  const bool ours = error.kind == ErrorKind::kSystem || error.kind == ErrorKind::kUnavailable;
  return ours ? kInternal : app::exit_code_of(error);
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

ExitCode watch(Remote& remote, const std::string& id, const SubmitOptions& options) {
  const Result<json::JsonValue> job = follow(remote, id);
  if (!job) return fail_remote(job.error(), options.json);
  const Result<store::JobState> end = state_of(*job);
  if (!end) return fail_remote(end.error(), options.json);
  if (*end == store::JobState::kFailed) {
    return fail(told_by_server(text_member(*job, "reason_code"), text_member(*job, "reason"),
                               text_member(*job, "reason_where")),
                options.json);
  }
  if (!options.out.empty()) {
    if (Status home = bring_home(remote, *job, options.out); !home)
      return fail_remote(home.error(), options.json);
  }
  print_end(*job, options);
  return exit_code_of(*end, *job);
}

}  // namespace

ExitCode submit_command(const SubmitOptions& options) {
  Result<http::HttpClient> client = http::HttpClient::make(options.server, options.roots);
  if (!client) return fail(client.error(), options.json);
  const Result<std::string> token = read_token(options.token_file);
  if (!token) return fail(token.error(), options.json);
  if (!token->empty() && client->tells_others()) {
    return fail(
        {"usage.token", "a token goes to other machines by https only, or everybody on the way has it",
         options.server},
        options.json);
  }
  Remote remote(std::move(*client), *token);
  const Result<std::string> project = send_project(remote, options.project);
  if (!project) return fail_remote(project.error(), options.json);
  const Result<json::JsonValue> job =
      remote.submit(*project, options.watch ? store::JobPriority::kInteractive : store::JobPriority::kBatch);
  if (!job) return fail_remote(job.error(), options.json);
  const std::string id = text_member(*job, "id");
  if (options.watch) return watch(remote, id, options);
  if (options.json) {
    std::printf("%s", json::write_json(*job).c_str());
  } else {
    std::printf("%s\n", id.c_str());
  }
  return kDone;
}

}  // namespace toile::app
