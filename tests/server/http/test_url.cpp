#include "server/http/url.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Url, SplitsAndDecodesATarget) {
  const auto target = http::parse_target("/api/v1/assets?kind=dxf&name=a%20b%2fc&empty=&x");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->segments, (std::vector<std::string>{"api", "v1", "assets"}));
  EXPECT_EQ(target->query.at("name"), "a b/c");
  EXPECT_EQ(target->query.at("empty"), "");
  EXPECT_TRUE(target->query.contains("x"));
  EXPECT_TRUE(http::parse_target("/")->segments.empty());
  EXPECT_EQ(http::parse_target("/a/")->segments, (std::vector<std::string>{"a", ""}));
  EXPECT_EQ(http::parse_target("/?a=1")->query.at("a"), "1");
}

TEST(Url, RefusesTargetsThatLeaveTheirFolder) {
  for (const char* target : {"/..",        "/../etc/passwd",
                             "/a/../../b", "/%2e%2e/x",
                             "/.%2e/x",    "/..%2fx",
                             "/a%2fb",     "/a%5cb",
                             "/a\\b",      "/%2e",
                             "/./a",       "/x%00.html",
                             "/%",         "/%4",
                             "/%zz",       "*",
                             "",           "http://localhost/",
                             "a/b",        "/?x=%q"}) {
    EXPECT_FALSE(http::parse_target(target)) << target;
  }
}

TEST(Url, FindsATagInAListHoweverWeak) {
  for (const char* list : {"\"3\"", "W/\"3\"", "\"1\", \"3\"", "W/\"1\",W/\"3\"", "*", "\"a, b\", \"3\""})
    EXPECT_TRUE(http::names_tag(list, "\"3\"")) << list;
  for (const char* list : {"", "3", "\"33\"", "\"1\", \"2\"", "\"3", "W/3"})
    EXPECT_FALSE(http::names_tag(list, "\"3\"")) << list;
}

TEST(Url, KnowsTheLoopbackByItsNames) {
  for (const char* host : {"localhost", "LOCALHOST:80", "127.0.0.1:8460", "127.9.9.9", "[::1]", "[::1]:8460",
                           "toile.localhost:1"}) {
    const auto name = http::host_name(host);
    ASSERT_TRUE(name) << host;
    EXPECT_TRUE(http::is_loopback_name(*name)) << host;
  }
  for (const char* host :
       {"example.org", "127.0.0.1.example.org", "localhost.example.org", "10.0.0.1", "0.0.0.0", "128.0.0.1",
        "127.0.0", "127.0.0.1.1", "127.0.0.256", "[::2]", "notlocalhost"}) {
    const auto name = http::host_name(host);
    ASSERT_TRUE(name) << host;
    EXPECT_FALSE(http::is_loopback_name(*name)) << host;
  }
  for (const char* host : {"", ":80", "localhost:", "localhost:http", "localhost:123456", "[::1", "[::1]x"}) {
    EXPECT_FALSE(http::host_name(host)) << host;
  }
}

}  // namespace
}  // namespace toile
