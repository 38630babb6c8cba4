// `toile serve` under TLS whose certificate is renewed.

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "tests/app/program.h"
#include "tests/app/serving.h"
#include "tests/server/http/certificate.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

bool becomes(const std::function<bool()>& holds) {
  for (int i = 0; i < 3000 && !holds(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return holds();
}

std::size_t times_said(const Serving& server, const std::string& words) {
  const std::string said = server.said();
  std::size_t times = 0;
  for (std::size_t at = said.find(words); at != std::string::npos; at = said.find(words, at + 1)) ++times;
  return times;
}

TEST(Certificates, AreReadAnewWhenTheServerIsSentSighup) {
  const fs::path folder = fresh_folder("toile_certificates");
  fs::create_directories(folder / "next");
  const test::Certificate first = test::make_certificate(folder);
  Serving server(folder / "data", {"--no-sample", "--no-workers", "--log", "text", "--tls-certificate",
                                   first.certificate, "--tls-key", first.key});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(server.get("/readyz").status, 200);
  ASSERT_EQ(kill(server.pid(), SIGHUP), 0);
  EXPECT_TRUE(becomes([&] { return times_said(server, "certificate read anew") == 1; }))
      << "though nothing has changed: " << server.said();
  EXPECT_EQ(server.get("/readyz").status, 200);

  const test::Certificate next = test::make_certificate(folder / "next");
  fs::copy_file(next.certificate, folder / "believed.pem");
  fs::rename(next.key, first.key);
  fs::rename(next.certificate, first.certificate);
  ASSERT_EQ(kill(server.pid(), SIGHUP), 0);
  server.believe(folder / "believed.pem");
  EXPECT_TRUE(becomes([&] { return server.get("/readyz").status == 200; })) << server.said();

  write_text(folder / "broken", "no certificate");
  fs::rename(folder / "broken", first.certificate);
  ASSERT_EQ(kill(server.pid(), SIGHUP), 0);
  EXPECT_TRUE(becomes([&] { return times_said(server, "certificate not taken") > 0; })) << server.said();
  EXPECT_NE(server.said().find(first.certificate.string()), std::string::npos) << "the file is named";
  EXPECT_EQ(server.get("/readyz").status, 200);
  EXPECT_EQ(server.end(SIGTERM), 0);
  fs::remove_all(folder);
}

TEST(Certificates, WithoutTlsSighupEndsTheServerAsEver) {
  const fs::path folder = fresh_folder("toile_no_certificates");
  Serving server(folder / "data", {"--no-sample", "--no-workers"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(server.end(SIGHUP), -SIGHUP);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace toile
