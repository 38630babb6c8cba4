#pragma once
// A server that lets in only who is known: Anna, who has something of everything, and Ben.

#include <map>
#include <string>

#include "server/accounts/secrets.h"
#include "server/store/webhooks.h"
#include "tests/core/image/pictures.h"
#include "tests/server/http/contract_routes.h"
#include "tests/server/http/dressed.h"
#include "tests/server/http/served.h"

namespace toile::test {

inline constexpr const char* kStreamed =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

class Accounts : public Served {
 protected:
  void SetUp() override {
    http::ServerSettings settings;
    settings.stream.check_every = std::chrono::milliseconds(50);
    serve(settings, false, true);
    anna = account("anna", true);
    ben = account("ben", false);
    full = token(anna, "read,submit,admin");
  }

  store::AccountRow account(const std::string& name, bool admin) {
    store::AccountRow row;
    row.name = name;
    row.admin = admin;
    return *store->accounts()->add_account(row);
  }
  std::string token(const store::AccountRow& of, const std::string& scopes, std::int64_t expires_ms = 0) {
    store::KeyRow key;
    key.owner = of.id;
    key.scopes = *store::scopes_from(scopes);
    key.expires_ms = expires_ms;
    const std::string secret = accounts::new_secret();
    last_key = store->accounts()->add_key(key, accounts::hash_of_secret(secret))->id;
    return secret;
  }
  static std::string shown(const std::string& secret) {
    return secret.empty() ? "" : "Authorization: Bearer " + secret + "\r\n";
  }
  Answer as(const std::string& secret, const std::string& method, const std::string& target,
            const std::string& body = "", const std::string& headers = "") {
    return ask(port, method, target, body, shown(secret) + headers);
  }

  /// Something of every kind that is Anna's.
  void make_things() {
    const std::string json = "Content-Type: application/json\r\n",
                      file = "Content-Type: application/octet-stream\r\n";
    const std::string asset =
        member(as(full, "POST", "/api/v1/assets?kind=body&name=post.obj", kPost, file), "id");
    const std::string project = member(as(full, "POST", "/api/v1/projects", dressed_pair(asset), json), "id");
    const std::string job =
        member(as(full, "POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}", json), "id");
    const store::RequestContext owner(anna.id);
    store::JobRow row = *store->job(owner, job);
    const std::string picture = png_of(squares());
    ASSERT_TRUE(store->put_result(owner, job, "front.png", picture));
    ASSERT_TRUE(store->put_result(owner, job, "final.obj", kPost));
    row.state = store::JobState::kSucceeded;
    row.report = "{\"settled\": true}";
    row.results["front.png"] = static_cast<std::int64_t>(picture.size());
    row.results["final.obj"] = static_cast<std::int64_t>(std::string(kPost).size());
    ASSERT_TRUE(update_job(*store, owner, row));
    token(anna, "read");
    const std::string key = last_key;
    store::LinkRow link;
    link.owner = anna.id;
    link.job = job;
    link.takes = {true, true, true};
    shared = accounts::new_secret();
    const std::string link_id = store->links()->add_link(link, accounts::hash_of_secret(shared))->id;
    store::WebhookRow webhook;
    webhook.owner = anna.id;
    webhook.url = "https://example.org/";
    webhook.states = {"cancelled"};
    const std::string hook = store::webhooks_of(*store)->add_webhook(webhook)->id;
    version = member(as(full, "POST", "/api/v1/projects/" + project + "/versions", R"({"name": "as drawn"})",
                        json + "If-Match: *\r\n"),
                     "id");
    const std::string sweep =
        member(as(full, "POST", "/api/v1/sweeps", "{\"project_id\": \"" + project + "\"}", json), "id");
    const store::JobRow swept = store::sweeps_of(*store)->jobs_of_sweep(owner, sweep)->front();
    ASSERT_TRUE(store->change_job(owner, swept.id, [](store::JobRow& one) -> Status {
      one.state = store::JobState::kSucceeded;
      return {};
    }));
    things = {{"assets", asset},  {"bodies", asset},  {"projects", project}, {"jobs", job},
              {"keys", key},      {"links", link_id}, {"shared", link_id},   {"admin/accounts", ben.id},
              {"webhooks", hook}, {"sweeps", sweep}};
    ASSERT_FALSE(sweep.empty() || asset.empty() || project.empty() || job.empty());
  }

  /// A path of the contract with Anna's things in place of its braces.
  std::string address_of(const std::string& path) {
    std::string address = path;
    const std::map<std::string, std::string> others{
        {"{body}", "anna"}, {"{landmark}", "navel"}, {"{number}", "1"}, {"{version}", version}};
    const auto put = [&](const std::string& brace, const std::string& value) {
      const std::size_t at = address.find(brace);
      if (at != std::string::npos) address.replace(at, brace.size(), value);
    };
    for (const auto& [room, id] : things)
      if (path.starts_with("/api/v1/" + room + "/")) put("{id}", id);
    for (const auto& [brace, value] : others) put(brace, value);
    put("{name}", path.find("fabrics") != std::string::npos ? "single-jersey" : "front.png");
    EXPECT_EQ(address.find('{'), std::string::npos) << "say here what stands for the braces of " << path;
    return address;
  }

  /// What an operation takes, so that it cannot be for its form that it is refused.
  std::string body_of(const ContractRoute& route) {
    const std::string operation = route.method + " " + route.path;
    const std::map<std::string, std::string> bodies{
        {"POST /api/v1/imports", "{\"asset\": \"" + things["assets"] + "\"}"},
        {"POST /api/v1/projects", napkin_request(things["assets"])},
        {"PUT /api/v1/projects/{id}", napkin_request(things["assets"])},
        {"POST /api/v1/projects/{id}/edits",
         R"({"edits": [{"edit": "rotate_grain", "piece": "front", "angle": 45}]})"},
        {"PUT /api/v1/projects/{id}/bodies/{body}",
         R"({"mannequin": {"preset": "eu40", "triangles": 1000}})"},
        {"PUT /api/v1/projects/{id}/bodies/{body}/landmarks/{landmark}", R"({"place": [0, 1, 0.2]})"},
        {"POST /api/v1/projects/{id}/versions", R"({"name": "with a slit"})"},
        {"POST /api/v1/projects/{id}/place", R"({"piece": "back", "side": "back"})"},
        {"POST /api/v1/webhooks", R"({"url": "https://example.org/other"})"},
        {"POST /api/v1/shared", R"({"secret": "guess"})"},
        {"POST /api/v1/jobs", "{\"project_id\": \"" + things["projects"] + "\"}"},
        {"POST /api/v1/sweeps", "{\"project_id\": \"" + things["projects"] + "\"}"},
    };
    const auto found = bodies.find(operation);
    return found == bodies.end() ? "{}" : found->second;
  }

  /// The operation with all that it may want.
  Answer tried(const ContractRoute& route, const std::string& secret) {
    std::string address = address_of(route.path), headers = "If-Match: *\r\n", body;
    if (route.method == "POST" || route.method == "PUT") {
      const bool upload = route.path == "/api/v1/assets" || route.path == "/api/v1/bodies";
      headers += upload ? "Content-Type: application/octet-stream\r\n" : "Content-Type: application/json\r\n";
      // Other bytes than those of make_things: the same would have the same id, being made of them.
      body = upload ? std::string("# another\n") + kPost : body_of(route);
      if (route.path == "/api/v1/assets") address += "?kind=body&name=post.obj";
      if (route.path == "/api/v1/bodies") address += "?name=post.obj";
    }
    if (route.path.ends_with("/stream")) headers += kStreamed;
    return as(secret, route.method, address, body, headers);
  }

  static std::string told(const ContractRoute& route) { return route.method + " " + route.path; }

  store::AccountRow anna, ben;
  std::string full;      ///< Anna's token for everything
  std::string last_key;  ///< id of the token that was made last
  std::string shared;    ///< secret of a link to Anna's job
  std::string version;   ///< id of one of Anna's project
  std::map<std::string, std::string> things;
};

}  // namespace toile::test
