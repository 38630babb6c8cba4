// /api/v1/admin: who uses the service, what it is doing, and for whom. For keys of scope admin, and for the
// single user.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

using Members = std::vector<json::JsonMember>;

/// Those that there are; without accounts the single user, who has no name.
Result<std::vector<store::AccountRow>> accounts_of(const Api& api) {
  if (api.doors) return api.store.accounts()->accounts();
  store::AccountRow single;
  single.id = store::kSingleUser;
  single.admin = true;
  return std::vector{single};
}

json::JsonValue name_or_null(const std::string& name) {
  return name.empty() ? json::JsonValue() : json::JsonValue(name);
}

Result<Members> members_of(const Api& api, const store::AccountRow& account) {
  const store::Usage usage = TRY(api.store.usage(store::RequestContext(account.id)));
  return Members{{"id", account.id},
                 {"name", name_or_null(account.name)},
                 {"admin", account.admin},
                 {"locked", account.locked},
                 {"created_ms", static_cast<double>(account.created_ms)},
                 {"bytes", static_cast<double>(usage.bytes)},
                 {"assets", static_cast<double>(usage.assets)},
                 {"projects", static_cast<double>(usage.projects)},
                 {"jobs", static_cast<double>(usage.jobs)},
                 {"unfinished_jobs", static_cast<double>(usage.unfinished_jobs)}};
}

http::HttpResponse list_accounts(const Api& api, const store::RequestContext&, const http::HttpRequest&) {
  const Result<std::vector<store::AccountRow>> accounts = accounts_of(api);
  if (!accounts) return http::problem(accounts.error());
  std::vector<json::JsonValue> list;
  for (const store::AccountRow& account : *accounts) {
    Result<Members> members = members_of(api, account);
    if (!members) return http::problem(members.error());
    list.emplace_back(std::move(*members));
  }
  return json_answer(200, {{"accounts", std::move(list)}});
}

http::HttpResponse load(const Api& api, const store::RequestContext&, const http::HttpRequest&) {
  const jobs::JobService::Counts counts = api.jobs.counts();
  const store::StoreFigures figures = api.store.figures();
  Members failures;
  for (const auto& [code, count] : figures.failures) failures.push_back({code, static_cast<double>(count)});
  return json_answer(200, {{"ready", api.ready.load()},
                           {"jobs_queued", static_cast<double>(counts.queued)},
                           {"jobs_running", static_cast<double>(counts.running)},
                           {"jobs_paused", static_cast<double>(counts.paused)},
                           {"viewers", static_cast<double>(api.hub.viewers())},
                           {"disk_bytes", static_cast<double>(figures.disk_bytes)},
                           {"disk_free_bytes", static_cast<double>(figures.disk_free_bytes)},
                           {"store_failures", std::move(failures)}});
}

json::JsonValue members_of(const store::Store::OwnedJob& owned, const std::string& name) {
  const store::JobRow& job = owned.job;
  return Members{{"id", job.id},
                 {"owner", owned.owner},
                 {"account", name_or_null(name)},
                 {"name", job.name},
                 {"state", std::string(store::name_of(job.state))},
                 {"priority", std::string(store::name_of(job.priority))},
                 {"holder", job.lease.holder},
                 {"attempt", static_cast<double>(job.attempt)},
                 {"created_ms", static_cast<double>(job.created_ms)},
                 {"started_ms", static_cast<double>(job.started_ms)},
                 {"worked_s", static_cast<double>(job.worked_ms) / 1000}};
}

/// What is under way or waits, of everybody, the oldest first.
http::HttpResponse list_all_jobs(const Api& api, const store::RequestContext&, const http::HttpRequest&) {
  const Result<std::vector<store::AccountRow>> accounts = accounts_of(api);
  if (!accounts) return http::problem(accounts.error());
  std::map<store::OwnerId, std::string> names;
  for (const store::AccountRow& account : *accounts) names[account.id] = account.name;
  const Result<std::vector<store::Store::OwnedJob>> jobs = api.store.unfinished_jobs();
  if (!jobs) return http::problem(jobs.error());
  std::vector<json::JsonValue> list;
  for (const store::Store::OwnedJob& owned : *jobs) list.push_back(members_of(owned, names[owned.owner]));
  return json_answer(200, {{"jobs", std::move(list)}});
}

/// Nobody locks themselves out: there might be nobody left to let them in.
http::HttpResponse set_lock(const Api& api, const store::RequestContext& context,
                            const http::HttpRequest& request, bool locked) {
  const std::string& id = request.captures[0];
  if (locked && id == context.owner)
    return http::problem(409,
                         {"auth.own_account", "this is your own account; another admin may lock it", id});
  const Result<std::vector<store::AccountRow>> accounts = accounts_of(api);
  if (!accounts) return http::problem(accounts.error());
  for (store::AccountRow account : *accounts) {
    if (account.id != id || !api.doors) continue;
    account.locked = locked;
    const Status done = api.store.accounts()->change_account(account);
    return done ? no_content() : http::problem(done.error());
  }
  return http::problem({"store.not_found", "there is no such account", id, ErrorKind::kNotFound});
}

http::HttpResponse lock(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  return set_lock(api, context, request, true);
}

http::HttpResponse unlock(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  return set_lock(api, context, request, false);
}

}  // namespace

ApiRoutes admin_routes() {
  constexpr http::Access kAdmin = http::Access::kAdmin;
  return {
      {.pattern = "/api/v1/admin/accounts", .handler = list_accounts, .access = kAdmin},
      {.method = "POST", .pattern = "/api/v1/admin/accounts/{id}/lock", .handler = lock, .access = kAdmin},
      {.method = "POST",
       .pattern = "/api/v1/admin/accounts/{id}/unlock",
       .handler = unlock,
       .access = kAdmin},
      {.pattern = "/api/v1/admin/jobs", .handler = list_all_jobs, .access = kAdmin},
      {.pattern = "/api/v1/admin/load", .handler = load, .access = kAdmin},
  };
}

}  // namespace toile::handlers
