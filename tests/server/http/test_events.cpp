// The feed of events: told as it happens, gone on with after a break, to nobody else.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "server/http/event_text.h"
#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

/// A client of the feed. What follows the header comes as it is.
class Listener {
 public:
  explicit Listener(int port, const std::string& headers = "", const std::string& query = "") : wire_(port) {
    wire_.send("GET /api/v1/events" + query + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port) +
               "\r\n" + headers + "\r\n");
    answer = read_answer(wire_);
  }
  /// The next that has a type or a comment, whole; nothing when none comes.
  std::optional<std::string> next() {
    for (;;) {
      const std::optional<std::string> event = wire_.read_until("\n\n");
      if (!event || event->find("event: ") != std::string::npos) return event;
      before += *event;
    }
  }
  bool ends() { return wire_.closed(20); }

  Answer answer;
  std::string before;  ///< what had no type: where it begins

 private:
  Wire wire_;
};

class EventFeeds : public Served {
 protected:
  void SetUp() override { serve(); }
  Answer act(const std::string& job, const std::string& what) {
    return ask(port, "POST", "/api/v1/jobs/" + job + "/" + what);
  }
};

TEST_F(EventFeeds, TellWhatBecomesOfEveryJob) {
  Listener listener(port);
  ASSERT_EQ(listener.answer.status, 200);
  EXPECT_EQ(listener.answer.headers.at("content-type"), "text/event-stream");
  EXPECT_EQ(listener.answer.headers.count("content-length"), 0u);
  const std::string first = make_job(), second = make_job();
  ASSERT_EQ(act(first, "cancel").status, 200);
  const std::string one = listener.next().value_or(""), two = listener.next().value_or(""),
                    three = listener.next().value_or("");
  EXPECT_TRUE(one.starts_with("id: 1\nevent: job\ndata: {")) << one;
  EXPECT_NE(one.find("\"job\": \"" + first + "\""), std::string::npos) << one;
  EXPECT_NE(one.find("\"state\": \"queued\""), std::string::npos) << one;
  EXPECT_NE(one.find("\"name\": \"Napkin\""), std::string::npos) << one;
  EXPECT_NE(two.find(second), std::string::npos) << two;
  EXPECT_TRUE(three.starts_with("id: 3\n")) << three;
  EXPECT_NE(three.find("\"state\": \"cancelled\""), std::string::npos) << three;
}

TEST_F(EventFeeds, GoOnAfterTheLastThatWasHeard) {
  const std::string job = make_job();
  ASSERT_EQ(act(job, "pause").status, 200);
  ASSERT_EQ(act(job, "resume").status, 200);
  Listener from_now(port);
  Listener again(port, "Last-Event-ID: 1\r\n");
  Listener all(port, "", "?after=0");
  EXPECT_TRUE(again.next().value_or("").starts_with("id: 2\n"));
  EXPECT_TRUE(again.next().value_or("").starts_with("id: 3\n"));
  EXPECT_TRUE(all.next().value_or("").starts_with("id: 1\n"));
  ASSERT_EQ(act(job, "cancel").status, 200);
  EXPECT_TRUE(from_now.next().value_or("").starts_with("id: 4\n")) << "nothing of before";
  EXPECT_NE(from_now.before.find("id: 3\n"), std::string::npos) << "a client that comes back says this";
}

TEST_F(EventFeeds, SayWhereSomethingIsMissing) {
  make_job();
  Listener other_store(port, "Last-Event-ID: 77\r\n");
  EXPECT_EQ(other_store.next().value_or(""), "id: 1\nevent: gap\ndata: {}\n\n");
  store::EventRow late;
  late.number = 9;
  late.state = "queued";
  EXPECT_TRUE(http::event_text({late}, 3).starts_with("id: 8\nevent: gap\ndata: {}\n\nid: 9\n"));
  late.job = "j_1";
  EXPECT_TRUE(http::event_text({late}, 8).starts_with("id: 9\nevent: job\n"));
  store::EventRow end = late;  // of a sweep itself
  end.job.clear();
  end.sweep = "s_1";
  EXPECT_TRUE(http::event_text({end}, 8).starts_with("id: 9\nevent: sweep\n"));
  EXPECT_PROBLEM(get("/api/v1/events", "Last-Event-ID: x\r\n"), 400, "request.after");
  EXPECT_PROBLEM(get("/api/v1/events?after=-1"), 400, "request.after");
  EXPECT_PROBLEM(get("/api/v1/events?state=queued"), 400, "request.unknown_parameter");
}

TEST_F(EventFeeds, AreBoundedAndAreGivenBack) {
  std::vector<std::unique_ptr<Listener>> listeners;
  for (int i = 0; i < 16; ++i) listeners.push_back(std::make_unique<Listener>(port));
  EXPECT_EQ(listeners.back()->answer.status, 200);
  EXPECT_PROBLEM(get("/api/v1/events"), 429, "events.too_many");
  listeners.pop_back();
  int status = 0;
  for (int tries = 0; tries < 200 && status != 200; ++tries) {
    status = Listener(port).answer.status;
    if (status != 200) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(status, 200) << "who has gone has left the seat";
}

TEST_F(EventFeeds, EndWithTheServer) {
  Listener listener(port);
  ASSERT_EQ(listener.answer.status, 200);
  server->stop();
  EXPECT_TRUE(listener.ends());
}

class AccountFeeds : public Accounts {};

TEST_F(AccountFeeds, TellAnOwnersOwnAlone) {
  make_things();
  Listener hers(port, shown(token(anna, "read")), "?after=0"),
      his(port, shown(token(ben, "read")), "?after=0");
  ASSERT_EQ(his.answer.status, 200);
  EXPECT_NE(hers.next().value_or("").find(things["jobs"]), std::string::npos);
  const std::string ben_token = token(ben, "read,submit");
  const std::string json = "Content-Type: application/json\r\n";
  const std::string asset = member(as(ben_token, "POST", "/api/v1/bodies?name=post.obj", kPost,
                                      "Content-Type: application/octet-stream\r\n"),
                                   "id");
  const std::string project =
      member(as(ben_token, "POST", "/api/v1/projects", napkin_request(asset), json), "id");
  const std::string job =
      member(as(ben_token, "POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}", json), "id");
  const std::string first = his.next().value_or("");
  EXPECT_TRUE(first.starts_with("id: 1\n")) << "numbers tell nothing of others: " << first;
  EXPECT_NE(first.find(job), std::string::npos) << first;
}

TEST_F(AccountFeeds, EndWhenTheirKeyIsRevoked) {
  const std::string secret = token(anna, "read");
  Listener listener(port, shown(secret));
  ASSERT_EQ(listener.answer.status, 200);
  ASSERT_TRUE(store->accounts()->remove_key(anna.id, last_key));
  EXPECT_TRUE(listener.ends());
}

}  // namespace
}  // namespace toile::test
