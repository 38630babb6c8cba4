// `toile account` and `toile token`, and a server that lets in only who is known.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class AccountVerbs : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_accounts");
    fs::create_directories(folder / "empty");
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string data() const { return (folder / "data").string(); }
  Ran on_store(std::vector<std::string> words) const {
    words.insert(words.end(), {"--data", data()});
    return run_toile(words);
  }
  std::string token(const std::string& account, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"token", "make", account};
    words.insert(words.end(), more.begin(), more.end());
    const Ran made = on_store(words);
    EXPECT_EQ(made.code, 0) << made.err;
    return made.out.substr(0, made.out.find('\n'));
  }
  static int status(const Serving& server, const std::string& target, const std::string& secret) {
    http::HttpClient::Request request;
    request.target = target;
    if (!secret.empty()) request.headers.emplace_back("Authorization", "Bearer " + secret);
    return server.ask(request).status;
  }

  fs::path folder;
};

TEST_F(AccountVerbs, OnceThereIsOneTheServerLetsInWhoIsKnownAndLearnsOfChangesAtOnce) {
  ASSERT_EQ(on_store({"account", "add", "anna"}).code, 0);
  const std::string first = token("anna");
  EXPECT_EQ(first.size(), 70u) << "stdout has the token and nothing else";
  Serving server(data(), {"--no-sample", "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(status(server, "/api/v1/jobs", ""), 401) << "nobody had to say --accounts";
  EXPECT_EQ(status(server, "/api/v1/jobs", first), 200);
  EXPECT_EQ(status(server, "/readyz", ""), 200);
  const std::string second = token("anna", {"--scopes", "read", "--json"});
  const auto told = json::parse_json(second);
  ASSERT_TRUE(told) << second;
  EXPECT_EQ(status(server, "/api/v1/jobs", *told->find("token")->text()), 200) << "made beside the server";
  ASSERT_EQ(on_store({"token", "revoke", "anna", *told->find("id")->text()}).code, 0);
  EXPECT_EQ(status(server, "/api/v1/jobs", *told->find("token")->text()), 401);
  ASSERT_EQ(on_store({"account", "lock", "anna"}).code, 0);
  EXPECT_EQ(status(server, "/api/v1/jobs", first), 401);
  ASSERT_EQ(on_store({"account", "unlock", "anna"}).code, 0);
  EXPECT_EQ(status(server, "/api/v1/jobs", first), 200);
  EXPECT_EQ(server.said().find(first), std::string::npos) << "no token in what is logged";
}

TEST_F(AccountVerbs, WithAccountsAsAnOptionAnEmptyStoreLetsInNobody) {
  Serving server(data(), {"--no-sample", "--workers", "1", "--accounts"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(status(server, "/api/v1/jobs", ""), 401);
}

TEST_F(AccountVerbs, TheAccountOfTheSingleUserHasWhatWasMadeBefore) {
  std::string project;
  {
    Serving server(data(), {"--no-sample", "--workers", "1"});
    ASSERT_TRUE(server.up()) << server.said();
    EXPECT_EQ(status(server, "/api/v1/projects", ""), 200);
    http::HttpClient::Request upload{.method = "POST",
                                     .target = "/api/v1/bodies?name=post.obj",
                                     .body = kPost,
                                     .content_type = "application/octet-stream",
                                     .headers = {}};
    project = *json::parse_json(server.ask(upload).body)->find("id")->text();
    EXPECT_EQ(server.end(SIGTERM), 0);
  }
  ASSERT_EQ(on_store({"account", "add", "anna", "--single-user"}).code, 0);
  ASSERT_EQ(on_store({"account", "add", "ben"}).code, 0);
  EXPECT_EQ(on_store({"account", "add", "carl", "--single-user"}).code, 2) << "one has it already";
  Serving server(data(), {"--no-sample", "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(status(server, "/api/v1/assets/" + project, token("anna")), 200);
  EXPECT_EQ(status(server, "/api/v1/assets/" + project, token("ben")), 404);
}

TEST_F(AccountVerbs, SubmitTakesItsTokenFromAFileOrTheEnvironment) {
  ASSERT_EQ(on_store({"account", "add", "anna"}).code, 0);
  const fs::path file = folder / "anna.token";
  ASSERT_EQ(on_store({"token", "make", "anna", "--out", file}).code, 0);
  struct stat kept {};
  ASSERT_EQ(::stat(file.c_str(), &kept), 0);
  EXPECT_EQ(kept.st_mode & 0777U, 0600U);
  const fs::path napkin = napkin_folder("toile_account_napkin");
  Serving server(data(), {"--no-sample", "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  const std::vector<std::string> submit{"submit", napkin / "project.json", "--server", server.url(),
                                        "--json"};
  const Ran unknown = run_toile(submit);
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("auth.required"), std::string::npos) << unknown.err;
  std::vector<std::string> with_file = submit;
  with_file.insert(with_file.end(), {"--token-file", file});
  const Ran known = run_toile(with_file);
  EXPECT_EQ(known.code, 0) << known.err;
  std::string secret = text_of(file);
  secret.pop_back();
  ::setenv("TOILE_TOKEN", secret.c_str(), 1);
  const Ran by_environment = run_toile(submit);
  ::unsetenv("TOILE_TOKEN");
  EXPECT_EQ(by_environment.code, 0) << by_environment.err;
  fs::remove_all(napkin);
}

TEST_F(AccountVerbs, APasswordFromAPipeLogsIn) {
  ASSERT_EQ(on_store({"account", "add", "anna"}).code, 0);
  const auto set = [&](const std::string& password) {
    const std::string program =
        std::string(TOILE_BINARY_DIR) + "/toile account password anna --data " + data();
    return std::system(("printf '%s\\n' '" + password + "' | " + program + " 2>/dev/null").c_str());
  };
  EXPECT_NE(set("short"), 0);
  ASSERT_EQ(set("correct horse"), 0);
  Serving server(data(), {"--no-sample", "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(server.post("/api/v1/session", R"({"name": "anna", "password": "short"})").status, 401);
  EXPECT_EQ(server.post("/api/v1/session", R"({"name": "anna", "password": "correct horse"})").status, 204);
  EXPECT_EQ(server.said().find("correct horse"), std::string::npos);
}

TEST_F(AccountVerbs, NoAddressBeyondTheLoopbackWithoutThemAndTls) {
  const std::vector<std::string> serve{"serve", "--port",      "0",         "--data",
                                       data(),  "--no-sample", "--address", "0.0.0.0"};
  const Ran open = run_toile(serve, 20);
  EXPECT_EQ(open.code, 2);
  EXPECT_NE(open.err.find("toile account add"), std::string::npos) << open.err;
  ASSERT_EQ(on_store({"account", "add", "anna"}).code, 0);
  const Ran plain = run_toile(serve, 20);
  EXPECT_EQ(plain.code, 2);
  EXPECT_NE(plain.err.find("--tls-certificate"), std::string::npos) << plain.err;
  std::vector<std::string> half = serve;
  half.insert(half.end(), {"--tls-certificate", "x.pem"});
  EXPECT_EQ(run_toile(half, 20).code, 2) << "no key";
  std::vector<std::string> proxied{"--no-sample", "--workers", "1", "--address", "0.0.0.0", "--behind-proxy"};
  Serving server(data(), proxied);
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(server.get("/readyz").status, 200);
}

TEST_F(AccountVerbs, ATokenDoesNotGoToOthersInTheClear) {
  write_text(folder / "token", "toile_0\n");
  const Ran told = run_toile(
      {"submit", "x.json", "--server", "http://toile.example", "--token-file", folder / "token"}, 20);
  EXPECT_EQ(told.code, 2);
  EXPECT_NE(told.err.find("usage.token"), std::string::npos) << told.err;
}

TEST_F(AccountVerbs, SayWhatIsWrong) {
  EXPECT_NE(on_store({"account", "add", "An na"}).err.find("accounts.name"), std::string::npos);
  EXPECT_NE(on_store({"token", "make", "nobody"}).err.find("store.not_found"), std::string::npos);
  ASSERT_EQ(on_store({"account", "add", "anna"}).code, 0);
  EXPECT_NE(on_store({"account", "add", "anna"}).err.find("accounts.taken"), std::string::npos);
  EXPECT_NE(on_store({"token", "make", "anna", "--scopes", "all"}).err.find("accounts.scope"),
            std::string::npos);
  const Ran admin = on_store({"token", "make", "anna", "--scopes", "read,admin"});
  EXPECT_EQ(admin.code, 2);
  EXPECT_NE(admin.err.find("--admin"), std::string::npos) << admin.err;
  EXPECT_NE(on_store({"token", "revoke", "anna", "k_0"}).err.find("store.not_found"), std::string::npos);
  const Ran none = run_toile({"submit", "x.json", "--token-file", folder / "none"});
  EXPECT_EQ(none.code, 2);
}

TEST_F(AccountVerbs, ListWhatThereIs) {
  ASSERT_EQ(on_store({"account", "add", "anna", "--admin"}).code, 0);
  token("anna", {"--label", "press"});
  const Ran accounts = on_store({"account", "list"}), keys = on_store({"token", "list", "anna"});
  EXPECT_NE(accounts.out.find("anna"), std::string::npos);
  EXPECT_NE(accounts.out.find("admin"), std::string::npos);
  EXPECT_NE(keys.out.find("read,submit"), std::string::npos);
  EXPECT_NE(keys.out.find("press"), std::string::npos);
  EXPECT_EQ(keys.out.find("toile_"), std::string::npos) << "never the token";
  EXPECT_TRUE(json::parse_json(on_store({"account", "list", "--json"}).out));
  EXPECT_TRUE(json::parse_json(on_store({"token", "list", "anna", "--json"}).out));
}

}  // namespace
}  // namespace toile
