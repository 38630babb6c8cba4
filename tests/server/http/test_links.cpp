// Share links: who has one sees one job and nothing else of its owner, changes nothing, and sees nothing any
// more once it is over.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

constexpr const char* kJson = "Content-Type: application/json\r\n";

std::int64_t now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

class SharedJob : public Accounts {
 protected:
  void SetUp() override {
    Accounts::SetUp();
    make_things();
    place = "/api/v1/shared/" + things["links"];
  }

  /// A link by the API; its id, and its secret in `secret`.
  std::string link_of(const std::string& job, const std::string& wish, std::string& secret) {
    const Answer made = as(full, "POST", "/api/v1/jobs/" + job + "/links", wish, kJson);
    EXPECT_EQ(made.status, 201) << made.body;
    secret = member(made, "secret");
    const auto tree = json::parse_json(made.body);
    return *tree->find("link")->find("id")->text();
  }
  std::string made_in_store(store::LinkRow row, std::string& secret) {
    row.owner = row.owner.empty() ? anna.id : row.owner;
    row.job = things["jobs"];
    secret = accounts::new_secret();
    return store->links()->add_link(row, accounts::hash_of_secret(secret))->id;
  }

  std::string place;
};

TEST_F(SharedJob, OpensNothingOfTheContractButItself) {
  for (const ContractRoute& route : contract_routes()) {
    if (route.open || route.link) continue;
    SCOPED_TRACE(told(route));
    const Answer answer = tried(route, shared);
    EXPECT_TRUE(answer.status == 401 || answer.status == 429) << answer.status << answer.body;
    const Answer by_cookie = ask(port, route.method, address_of(route.path), "",
                                 "Cookie: toile=" + shared + "; toile-" + things["links"] + "=" + shared +
                                     "\r\nOrigin: http://localhost\r\n");
    EXPECT_GE(by_cookie.status, 400) << by_cookie.body;
  }
  EXPECT_EQ(as(full, "GET", "/api/v1/jobs/" + things["jobs"]).status, 200) << "nothing has changed";
}

TEST_F(SharedJob, IsSeenWithoutAnAccount) {
  const Answer opened = ask(port, "POST", "/api/v1/shared", "{\"secret\": \"" + shared + "\"}", kJson);
  ASSERT_EQ(opened.status, 200) << opened.body;
  EXPECT_EQ(member(opened, "id"), things["links"]);
  EXPECT_EQ(member(opened, "state"), "succeeded");
  const std::string set = opened.headers.at("set-cookie");
  EXPECT_NE(set.find("; Path=" + place + ";"), std::string::npos) << set;
  for (const char* guard : {"HttpOnly", "SameSite=Strict"}) EXPECT_NE(set.find(guard), std::string::npos);
  const std::string cookie = "Cookie: " + set.substr(0, set.find(';')) + "\r\n";
  for (const char* part :
       {"", "/cloth", "/pieces", "/results/front.png", "/results/front.png/small", "/report"})
    EXPECT_EQ(get(place + part, cookie).status, 200) << part;
  EXPECT_EQ(get(place + "/cloth", cookie).body, kPost);
}

TEST_F(SharedJob, TellsNothingElseOfItsOwner) {
  const std::string answers =
      as(shared, "GET", place).body + as(shared, "GET", place + "/pieces").body +
      ask(port, "POST", "/api/v1/shared", "{\"secret\": \"" + shared + "\"}", kJson).body;
  for (const std::string& word :
       {things["projects"], things["jobs"], things["assets"], things["keys"], anna.id, std::string("outline"),
        std::string("post.obj"), std::string("anna")})
    EXPECT_EQ(answers.find(word), std::string::npos) << word << " in " << answers;
}

TEST_F(SharedJob, IsNotOpenedByTheSecretOfAnother) {
  std::string secret;
  const std::string other = made_in_store({}, secret);
  EXPECT_EQ(as(secret, "GET", "/api/v1/shared/" + other).status, 200);
  EXPECT_PROBLEM(as(secret, "GET", place), 401, "links.unknown");
  EXPECT_PROBLEM(as(shared, "GET", "/api/v1/shared/" + other), 401, "links.unknown");
  EXPECT_PROBLEM(as(full, "GET", place), 401, "links.unknown");
  EXPECT_PROBLEM(get(place), 401, "auth.required");
}

TEST_F(SharedJob, GivesAwayOnlyWhatItsOwnerAllows) {
  std::string secret;
  const std::string here =
      "/api/v1/shared/" + link_of(things["jobs"], R"({"take": ["report"], "label": "to look at"})", secret);
  EXPECT_PROBLEM(as(secret, "GET", here + "/results/front.png"), 403, "links.take");
  EXPECT_PROBLEM(as(secret, "GET", here + "/results/final.obj"), 403, "links.take");
  EXPECT_EQ(as(secret, "GET", here + "/results/front.png/small").status, 200) << "it is to be seen";
  EXPECT_EQ(as(secret, "GET", here + "/report").status, 200);
  EXPECT_EQ(as(secret, "GET", here).body.find("front.png\":"), std::string::npos);
  std::string none;
  const std::string bare = "/api/v1/shared/" + link_of(things["jobs"], "{}", none);
  EXPECT_PROBLEM(as(none, "GET", bare + "/report"), 403, "links.take");
  for (const char* name : {"final.hung", "drape.film", "checkpoint", "%2e%2e%2ftoile.db"}) {
    EXPECT_GE(as(shared, "GET", place + "/results/" + name).status, 400) << name;
    EXPECT_GE(as(shared, "GET", place + "/results/" + name + "/small").status, 400) << name;
    EXPECT_GE(as(shared, "GET", place + "/pictures/" + name).status, 400) << name;
  }
}

TEST_F(SharedJob, SaysWhatBecameOfItToWhoHasIt) {
  store::LinkRow old;
  old.expires_ms = now_ms() - 1000;
  std::string secret;
  const std::string expired = made_in_store(old, secret);
  EXPECT_PROBLEM(as(secret, "GET", "/api/v1/shared/" + expired), 410, "links.expired");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/shared", "{\"secret\": \"" + secret + "\"}", kJson), 410,
                 "links.expired");
  ASSERT_EQ(as(full, "DELETE", "/api/v1/links/" + things["links"]).status, 204);
  EXPECT_PROBLEM(as(full, "DELETE", "/api/v1/links/" + things["links"]), 404, "store.not_found");
  for (const char* part : {"", "/cloth", "/pieces", "/body", "/results/front.png", "/report"})
    EXPECT_PROBLEM(as(shared, "GET", place + part), 410, "links.revoked");
  std::string last;
  const std::string removed = made_in_store({}, last);
  ASSERT_EQ(as(full, "DELETE", "/api/v1/jobs/" + things["jobs"]).status, 204);
  EXPECT_PROBLEM(as(last, "GET", "/api/v1/shared/" + removed), 410, "links.removed");
}

TEST_F(SharedJob, IsOverWhenItsOwnersAccountIsLocked) {
  store::AccountRow row = *store->accounts()->account_named("anna");
  row.locked = true;
  ASSERT_TRUE(store->accounts()->change_account(row));
  EXPECT_PROBLEM(as(shared, "GET", place), 410, "links.revoked");
}

TEST_F(SharedJob, IsNotGuessed) {
  Answer last;
  for (int i = 0; i < 12; ++i)
    last = ask(port, "POST", "/api/v1/shared", "{\"secret\": \"guess" + std::to_string(i) + "\"}", kJson);
  EXPECT_PROBLEM(last, 429, "auth.guesses");
  EXPECT_GT(std::stoi(last.headers.at("retry-after")), 0);
  EXPECT_EQ(as(shared, "GET", place).status, 200) << "who has it goes on";
}

TEST_F(SharedJob, IsTheOwnersToListAndToTakeBack) {
  const std::string list = as(full, "GET", "/api/v1/jobs/" + things["jobs"] + "/links").body;
  EXPECT_NE(list.find(things["links"]), std::string::npos);
  EXPECT_EQ(list.find(shared), std::string::npos) << "a secret is told once";
  EXPECT_EQ(list.find(accounts::hash_of_secret(shared)), std::string::npos);
  const std::string foreign = token(ben, "read,submit");
  EXPECT_EQ(as(foreign, "GET", "/api/v1/links").body.find(things["links"]), std::string::npos);
  EXPECT_PROBLEM(as(foreign, "DELETE", "/api/v1/links/" + things["links"]), 404, "store.not_found");
  EXPECT_EQ(as(shared, "GET", place).status, 200);
}

TEST_F(SharedJob, WishesAreLookedAt) {
  const std::string here = "/api/v1/jobs/" + things["jobs"] + "/links";
  const auto refused = [&](const std::string& wish) { return as(full, "POST", here, wish, kJson); };
  EXPECT_PROBLEM(refused(R"({"days": 0})"), 422, "links.days");
  EXPECT_PROBLEM(refused(R"({"days": 4000})"), 422, "links.days");
  EXPECT_PROBLEM(refused(R"({"take": ["everything"]})"), 422, "links.take");
  EXPECT_PROBLEM(refused(R"({"take": "report"})"), 422, "links.take");
  EXPECT_PROBLEM(refused("{\"label\": \"" + std::string(81, 'a') + "\"}"), 422, "links.label");
  EXPECT_PROBLEM(refused(R"({"for": "you"})"), 422, "request.unknown_key");
}

TEST_F(SharedJob, KeepsNoSecretOnDisk) {
  std::string secret;
  link_of(things["jobs"], "{}", secret);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(bytes.find(secret), std::string::npos) << entry.path();
  }
}

class SharedStream : public SharedJob {
 protected:
  /// A job that waits, a link to it, and where it streams.
  void share_live() {
    job = member(as(full, "POST", "/api/v1/jobs", "{\"project_id\": \"" + things["projects"] + "\"}", kJson),
                 "id");
    link = link_of(job, "{}", secret);
    target = "/api/v1/shared/" + link + "/stream";
  }
  std::string job, link, secret, target;
};

TEST_F(SharedStream, ShowsALiveDrapeUnderTheLinksId) {
  share_live();
  EXPECT_EQ(Socket(port, target).status(), 401);
  EXPECT_EQ(Socket(port, target, shown(full)).status(), 401) << "an account's token is no link";
  EXPECT_EQ(Socket(port, target, shown(shared)).status(), 401) << "nor is another link";
  EXPECT_EQ(Socket(port, "/api/v1/jobs/" + job + "/stream", shown(secret)).status(), 401);
  const std::string cookie = "Cookie: toile-" + link + "=" + secret + "\r\n";
  EXPECT_EQ(Socket(port, target, cookie).status(), 403) << "a cookie, and no Origin";
  EXPECT_EQ(Socket(port, target, cookie + "Origin: http://elsewhere\r\n").status(), 403);
  Socket viewer(port, target, shown(secret));
  ASSERT_EQ(viewer.status(), 101);
  const auto hello = viewer.read(5);
  ASSERT_TRUE(hello);
  EXPECT_NE(hello->payload.find(link), std::string::npos) << hello->payload;
  EXPECT_EQ(hello->payload.find(job), std::string::npos) << hello->payload;
  EXPECT_EQ(hello->payload.find(things["projects"]), std::string::npos) << hello->payload;
}

TEST_F(SharedStream, TakesNoCommands) {
  share_live();
  for (const char* command : {"pause", "cancel"}) {
    Socket viewer(port, target, shown(secret));
    ASSERT_EQ(viewer.status(), 101);
    viewer.send(Socket::kText, std::string("{\"type\": \"") + command + "\"}");
    std::string said;
    for (int i = 0; i < 5 && said.find("auth.scope") == std::string::npos; ++i) {
      const auto message = viewer.read(5);
      if (!message) break;
      said += message->payload;
    }
    EXPECT_NE(said.find("auth.scope"), std::string::npos) << said;
  }
  EXPECT_EQ(member(as(full, "GET", "/api/v1/jobs/" + job), "state"), "queued");
}

TEST_F(SharedStream, EndsWhenTheLinkIsTakenBack) {
  share_live();
  Socket viewer(port, target, shown(secret));
  ASSERT_EQ(viewer.status(), 101);
  ASSERT_EQ(as(full, "DELETE", "/api/v1/links/" + link).status, 204);
  EXPECT_EQ(viewer.read_to_close(), 1008);
}

TEST_F(SharedStream, HasRoomForSoManyAndNoMore) {
  share_live();
  std::vector<std::unique_ptr<Socket>> viewers;
  for (int i = 0; i < accounts::LinkGate::kMostViewers; ++i) {
    viewers.push_back(std::make_unique<Socket>(port, target, shown(secret)));
    ASSERT_EQ(viewers.back()->status(), 101) << i;
  }
  EXPECT_EQ(Socket(port, target, shown(secret)).status(), 429);
  EXPECT_EQ(Socket(port, place + "/stream", shown(shared)).status(), 101) << "another link has room";
  viewers.clear();
  int status = 0;
  for (int i = 0; i < 200 && status != 101; ++i) status = Socket(port, target, shown(secret)).status();
  EXPECT_EQ(status, 101) << "who goes gives the seat back";
}

/// Without accounts, and behind a proxy.
class LinksOfTheSingleUser : public Served {};

TEST_F(LinksOfTheSingleUser, OpenAndCommandNothing) {
  http::ServerSettings settings;
  settings.stream.check_every = std::chrono::milliseconds(50);
  serve(settings);
  const std::string job = make_job();
  const Answer made = send_json("POST", "/api/v1/jobs/" + job + "/links", R"({"days": 1})");
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string secret = member(made, "secret"), bearer = "Authorization: Bearer " + secret + "\r\n";
  const Answer opened = send_json("POST", "/api/v1/shared", "{\"secret\": \"" + secret + "\"}");
  ASSERT_EQ(opened.status, 200) << opened.body;
  const std::string link = member(opened, "id");
  EXPECT_PROBLEM(get("/api/v1/shared/" + link), 401, "auth.required");
  Socket viewer(port, "/api/v1/shared/" + link + "/stream", bearer);
  ASSERT_EQ(viewer.status(), 101);
  viewer.send(Socket::kText, R"({"type": "cancel"})");
  ASSERT_EQ(ask(port, "DELETE", "/api/v1/links/" + link).status, 204);
  EXPECT_EQ(viewer.read_to_close(), 1008);
  EXPECT_EQ(member(get("/api/v1/jobs/" + job), "state"), "queued");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/shared", "{\"secret\": \"" + secret + "\"}"), 410,
                 "links.revoked");
}

class LinksBehindAProxy : public Served {};

TEST_F(LinksBehindAProxy, AreGuessedByTheAddressBehindIt) {
  http::ServerSettings settings;
  settings.behind_proxy = true;
  serve(settings, false, true);
  store::AccountRow row;
  row.name = "anna";
  const store::AccountRow anna = *store->accounts()->add_account(row);
  store::LinkRow link;
  link.owner = anna.id;
  store::JobRow job;
  job.name = "shirt";
  link.job = store->create_job(store::RequestContext(anna.id), job, "")->id;
  const std::string secret = accounts::new_secret();
  ASSERT_TRUE(store->links()->add_link(link, accounts::hash_of_secret(secret)));
  const auto open = [&](const std::string& shown, const std::string& from) {
    return send_json("POST", "/api/v1/shared", "{\"secret\": \"" + shown + "\"}",
                     "X-Forwarded-For: " + from + "\r\n");
  };
  for (int i = 0; i < 12; ++i) open("guess" + std::to_string(i), "192.0.2.1");
  EXPECT_PROBLEM(open("guess", "192.0.2.1"), 429, "auth.guesses");
  EXPECT_PROBLEM(open("guess", "192.0.2.2"), 401, "links.unknown");
  const Answer opened = open(secret, "192.0.2.3");
  ASSERT_EQ(opened.status, 200) << opened.body;
  const std::string cookie = opened.headers.at("set-cookie");
  EXPECT_TRUE(cookie.starts_with("__Secure-toile-l_")) << cookie;
  EXPECT_TRUE(cookie.ends_with("; Secure")) << cookie;
}

}  // namespace
}  // namespace toile::test
