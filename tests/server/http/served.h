#pragma once
// A server on a free port over a real store, and the least project.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/json/tree.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/http/handlers/routes.h"
#include "server/http/identify.h"
#include "server/http/server.h"
#include "server/store/job_search.h"
#include "server/store/sqlite/open.h"
#include "tests/app/napkin.h"
#include "tests/server/http/wire.h"
#include "tests/server/owners.h"
#include "tests/server/store/update_job.h"

namespace toile::test {

/// Jobs that nobody drapes: their states change as they are told, and the test plays the worker.
class ScriptedJobs final : public jobs::JobService {
 public:
  explicit ScriptedJobs(documents::Documents& documents) : documents_(documents), store_(documents.store()) {}
  Status start() override { return {}; }
  void stop() override {}
  Result<store::Made<store::JobRow>> submit(const store::RequestContext& context,
                                            const std::string& project_id, const std::string& key,
                                            const jobs::JobWish& wish) override {
    const store::ProjectRow project = TRY(store_.project(context, project_id));
    store::JobRow row;
    row.project_id = project.id;
    row.project_revision = project.revision;
    row.name = project.name;
    row.document = project.document;
    row.files = project.files;
    row.priority = wish.priority;
    row.pictures = wish.pictures;
    row.tags = wish.tags;
    return store_.create_job(context, row, key);
  }
  Result<store::Made<store::SweptJobs>> submit_sweep(const store::RequestContext& context,
                                                     const jobs::SweepWish& wish,
                                                     const std::string& key) override {
    store::SweptJobs wanted = TRY(jobs::swept_jobs(documents_, context, wish));
    return store::sweeps_of(store_)->create_sweep(context, std::move(wanted), key);
  }
  Result<store::Made<store::JobRow>> retry(const store::RequestContext& context, const std::string& id,
                                           const std::string& key) override {
    store::JobRow row = TRY(store_.job(context, id));
    row.tags = TRY(store::tags_of_job(store_, context, id));
    row.state = store::JobState::kQueued;
    return store_.create_job(context, row, key);
  }
  Result<store::JobRow> pause(const store::RequestContext& context, const std::string& id) override {
    return become(context, id, store::JobState::kPaused);
  }
  Result<store::JobRow> resume(const store::RequestContext& context, const std::string& id) override {
    return become(context, id, store::JobState::kQueued);
  }
  Result<store::JobRow> cancel(const store::RequestContext& context, const std::string& id) override {
    return become(context, id, store::JobState::kCancelled);
  }
  Result<store::JobRow> step(const store::RequestContext& context, const std::string& id) override {
    return become(context, id, store::JobState::kQueued);
  }
  Result<store::Made<store::JobRow>> go_on(const store::RequestContext& context, const std::string& id,
                                           const std::string& key) override {
    return retry(context, id, key);
  }
  Status touch(const store::RequestContext& context, const std::string& id, jobs::LiveTouch touch) override {
    TRY(store_.job(context, id));
    const std::lock_guard lock(touches_mutex_);
    touches_.push_back(std::move(touch));
    return {};
  }
  /// What hands did so far.
  std::vector<jobs::LiveTouch> touches() {
    const std::lock_guard lock(touches_mutex_);
    return touches_;
  }
  Status remove(const store::RequestContext& context, const std::string& id) override {
    return store_.remove_job(context, id);
  }
  Result<jobs::JobProgress> progress(const store::RequestContext& context, const std::string& id) override {
    const store::JobRow row = TRY(store_.job(context, id));
    jobs::JobProgress progress;
    progress.state = row.state;
    return progress;
  }
  Counts counts() const override { return {}; }

  Result<store::JobRow> become(const store::RequestContext& context, const std::string& id,
                               store::JobState state) {
    store::JobRow row = TRY(store_.job(context, id));
    if (row.state == store::JobState::kSucceeded || row.state == store::JobState::kCancelled ||
        row.state == state) {
      return Error{"jobs.state", "the job is " + std::string(store::name_of(row.state)), id,
                   ErrorKind::kConflict};
    }
    row.state = state;
    TRY(update_job(store_, context, row));
    return row;
  }

 private:
  documents::Documents& documents_;
  store::Store& store_;
  std::mutex touches_mutex_;
  std::vector<jobs::LiveTouch> touches_;
};

class Served : public testing::Test {
 protected:
  /// `settings` are those of the server but for the port and the gate, which is there when `with_accounts`.
  void serve(http::ServerSettings settings = {}, bool real_jobs = false, bool with_accounts = false) {
    folder = std::filesystem::path(testing::TempDir()) / ("toile_http_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "data");
    Result<std::unique_ptr<store::Store>> opened = sqlite::open_sqlite_store((folder / "data").string());
    ASSERT_TRUE(opened) << to_string(opened.error());
    store = std::move(*opened);
    documents = std::make_unique<documents::Documents>(*store);
    if (real_jobs) {
      jobs::JobServiceSettings two;
      two.workers = 2;
      jobs = jobs::make_job_service(*documents, hub, two);
    } else {
      jobs = std::make_unique<ScriptedJobs>(*documents);
    }
    ASSERT_TRUE(jobs->start());
    movies = std::make_unique<jobs::Movies>(*store);
    stills = std::make_unique<jobs::JobStills>(*store);
    settings.port = 0;
    if (with_accounts) {
      doors = std::make_unique<handlers::Doors>(*store->accounts(), http::cookie_name(settings.secure()));
      settings.gate = &doors->gate;
    }
    link_door = std::make_unique<handlers::LinkDoor>(*store->links(), with_accounts, settings.secure());
    settings.links = &link_door->gate;
    settings.most_connections = 64;
    server = std::make_unique<http::HttpServer>(*store, *jobs, hub, settings, log);
    handlers::add_routes(server->router(),
                         {*documents, *store, *jobs, *movies, *stills, hub, server->metrics(),
                          server->ready(), doors.get(), link_door.get()});
    if (more_routes) more_routes(server->router());
    const Status started = server->start();
    ASSERT_TRUE(started) << to_string(started.error());
    port = server->port();
  }
  void TearDown() override {
    if (jobs) jobs->stop();
    let_go();
    std::filesystem::remove_all(folder);
  }
  /// Of all that serves, in its order; the folder stays.
  void let_go() {
    server.reset();
    doors.reset();
    link_door.reset();
    movies.reset();
    stills.reset();
    jobs.reset();
    documents.reset();
    store.reset();
  }

  Answer get(const std::string& target, const std::string& headers = "") {
    return ask(port, "GET", target, "", headers);
  }
  Answer send_json(const std::string& method, const std::string& target, const std::string& body,
                   const std::string& headers = "") {
    return ask(port, method, target, body, "Content-Type: application/json\r\n" + headers);
  }
  Answer upload(const std::string& kind, const std::string& name, const std::string& bytes) {
    return ask(port, "POST", "/api/v1/assets?kind=" + kind + "&name=" + name, bytes,
               "Content-Type: application/octet-stream\r\n");
  }

  static std::string member(const Answer& answer, const std::string& key) {
    const Result<json::JsonValue> tree = json::parse_json(answer.body, {.depth = 64});
    const json::JsonValue* found = tree ? tree->find(key) : nullptr;
    return found && found->text() ? *found->text() : "";
  }

  std::string post_asset() { return member(upload("body", "post.obj", kPost), "id"); }
  /// A request's body for the napkin, in which the first place of `from` is changed to `to`.
  static std::string napkin_request(const std::string& asset, const std::string& from = "",
                                    const std::string& to = "") {
    std::string text = kNapkin;
    const std::size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return "{\"document\": " + text + ", \"files\": {\"post.obj\": \"" + asset + "\"}}";
  }
  std::string make_project() {
    return member(send_json("POST", "/api/v1/projects", napkin_request(post_asset())), "id");
  }
  std::string make_job() {
    return member(send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + make_project() + "\"}"), "id");
  }

  std::filesystem::path folder;
  // What a test may set before it serves.
  Log log;  ///< silent else
  std::function<void(http::Router&)> more_routes;

  ws::Hub hub;
  std::unique_ptr<store::Store> store;
  std::unique_ptr<documents::Documents> documents;
  std::unique_ptr<jobs::JobService> jobs;
  std::unique_ptr<jobs::Movies> movies;
  std::unique_ptr<jobs::JobStills> stills;
  std::unique_ptr<handlers::Doors> doors;
  std::unique_ptr<handlers::LinkDoor> link_door;
  std::unique_ptr<http::HttpServer> server;
  int port = 0;
};

#define EXPECT_PROBLEM(answer, wanted_status, wanted_code)                                 \
  do {                                                                                     \
    const Answer& got = (answer);                                                          \
    EXPECT_EQ(got.status, wanted_status) << got.body.substr(0, 500);                       \
    EXPECT_EQ(got.headers.count("content-type") ? got.headers.at("content-type") : "none", \
              "application/problem+json");                                                 \
    EXPECT_TRUE(member(got, "code").starts_with(wanted_code)) << got.body.substr(0, 500);  \
    EXPECT_LT(got.body.size(), 6000u);                                                     \
  } while (false)

}  // namespace toile::test
