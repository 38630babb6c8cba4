#include "server/http/static_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "server/http/compress.h"
#include "server/http/url.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class StaticFilesTest : public testing::Test {
 protected:
  StaticFilesTest() : root(fs::path(testing::TempDir()) / ("toile_page_" + std::to_string(getpid()))) {
    fs::remove_all(root);
    fs::create_directories(root / "dist/assets");
    write("dist/index.html", "<p>page");
    write("dist/icon.svg", "<svg/>");
    write("dist/assets/index-3f2a.js", "1");
    write("dist/.env", "SECRET=1");
    write("secret.txt", "secret");
    fs::create_symlink(root / "secret.txt", root / "dist/link.txt");
  }
  ~StaticFilesTest() override { fs::remove_all(root); }
  void write(const std::string& name, const std::string& text) { std::ofstream(root / name) << text; }

  http::HttpResponse get(const std::string& target, const std::string& folder = "dist",
                         const std::string& accept_encoding = "") {
    http::HttpRequest request;
    request.method = "GET";
    request.target = target;
    request.headers["accept-encoding"] = accept_encoding;
    const auto parsed = http::parse_target(target);
    if (!parsed) return {.status = 400, .content_type = {}, .body = {}, .headers = {}};
    request.segments = parsed->segments;
    return http::StaticFiles(root / folder).get(request);
  }
  static std::string header(const http::HttpResponse& response, const std::string& name) {
    for (const auto& [key, value] : response.headers) {
      if (key == name) return value;
    }
    return "";
  }

  fs::path root;
};

TEST_F(StaticFilesTest, ServesThePageAndAsksForItAgain) {
  const http::HttpResponse page = get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, "<p>page");
  EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
  EXPECT_EQ(header(page, "Cache-Control"), "no-cache");
  EXPECT_NE(header(page, "Content-Security-Policy").find("default-src 'self'"), std::string::npos);
}

TEST_F(StaticFilesTest, CompressesTextForWhoTakesIt) {
  std::string script;
  for (int k = 0; k < 2000; ++k) script += "export const value" + std::to_string(k) + " = 1;\n";
  write("dist/assets/large.js", script);
  const http::HttpResponse plain = get("/assets/large.js"), small = get("/", "dist", "gzip");
  EXPECT_EQ(plain.body, script);
  EXPECT_EQ(header(plain, "Content-Encoding"), "");
  EXPECT_EQ(header(plain, "Vary"), "Accept-Encoding");
  EXPECT_EQ(header(small, "Content-Encoding"), "") << "not worth it";
  const http::HttpResponse packed = get("/assets/large.js", "dist", "br, gzip;q=0.8");
  EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
  EXPECT_EQ(packed.content_type, plain.content_type);
  EXPECT_TRUE(packed.body.starts_with("\x1f\x8b"));
  EXPECT_LT(packed.body.size(), script.size() / 4);
  EXPECT_EQ(header(get("/assets/large.js", "dist", "gzip;q=0, br"), "Content-Encoding"), "");
}

TEST(TakesGzip, ByItsNameOrUnderTheStar) {
  for (const char* yes : {"gzip", "GZIP", "br, gzip", "gzip;q=0.1", "*", "br;q=1, *;q=0.5"})
    EXPECT_TRUE(http::takes_gzip(yes)) << yes;
  for (const char* no : {"", "br", "gzip;q=0", "gzip; q=0.000", "*;q=0", "identity", "gzip;q=0, *"})
    EXPECT_FALSE(http::takes_gzip(no)) << no;
}

TEST_F(StaticFilesTest, LetsHashedFilesBeKept) {
  const http::HttpResponse script = get("/assets/index-3f2a.js");
  EXPECT_EQ(script.content_type, "text/javascript; charset=utf-8");
  EXPECT_NE(header(script, "Cache-Control").find("immutable"), std::string::npos);
  EXPECT_EQ(get("/icon.svg").content_type, "image/svg+xml");
  EXPECT_EQ(header(get("/icon.svg"), "Cache-Control"), "no-cache");
}

TEST_F(StaticFilesTest, ShowsNothingOutsideItsFolder) {
  for (const char* target :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/assets/../../secret.txt", "/link.txt",
        "/.env", "/assets", "/assets/", "//etc/passwd", "/etc/passwd", "/index.html/", "/nothing.html",
        "/%00", "/assets/%2e%2e/%2e%2e/secret.txt", "/....//secret.txt", "/..;/secret.txt"}) {
    const http::HttpResponse response = get(target);
    EXPECT_GE(response.status, 400) << target;
    EXPECT_EQ(response.body.find("secret\n"), std::string::npos) << target;
    EXPECT_NE(response.body, "secret") << target;
  }
}

TEST_F(StaticFilesTest, SaysInPlainWordsThatThePageIsNotBuilt) {
  EXPECT_EQ(get("/", "nowhere").status, 200);
  EXPECT_NE(get("/", "nowhere").body.find("has not been built"), std::string::npos);
  EXPECT_EQ(get("/index.js", "nowhere").status, 404);
}

}  // namespace
}  // namespace toile
