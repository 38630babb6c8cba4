// A command reads the document and the pattern file once, whatever it makes of them.

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// Counts how often files of a folder are opened, by name, from its making on.
class OpenCounter {
 public:
  explicit OpenCounter(const fs::path& folder) : queue_(::inotify_init1(IN_NONBLOCK)) {
    EXPECT_GE(::inotify_add_watch(queue_, folder.c_str(), IN_OPEN), 0) << std::strerror(errno);
  }
  OpenCounter(const OpenCounter&) = delete;
  OpenCounter& operator=(const OpenCounter&) = delete;
  ~OpenCounter() { ::close(queue_); }

  /// Of all that has happened.
  std::map<std::string, int> opened() {
    alignas(inotify_event) std::array<char, 65536> bytes;
    for (;;) {
      const ssize_t got = ::read(queue_, bytes.data(), bytes.size());
      if (got <= 0) return opened_;
      for (ssize_t at = 0; at < got;) {
        const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
        if (event->len > 0) ++opened_[event->name];
        at += static_cast<ssize_t>(sizeof(inotify_event)) + event->len;
      }
    }
  }

 private:
  int queue_;
  std::map<std::string, int> opened_;
};

/// A folder with the sample in coarse triangles, of which nobody but the test knows.
fs::path coarse_sample(const std::string& name) {
  const fs::path folder = fresh_folder(name);
  fs::copy(fs::path(TOILE_SOURCE_DIR) / "samples" / "skirt", folder, fs::copy_options::recursive);
  std::string document = text_of(folder / "project.json");
  const std::string fine = "\"particle_distance_mm\": 16.20";
  EXPECT_NE(document.find(fine), std::string::npos);
  document.replace(document.find(fine), fine.size(), "\"particle_distance_mm\": 60");
  write_text(folder / "project.json", document);
  return folder;
}

void expect_read_once(const std::string& name, const fs::path& folder,
                      const std::vector<std::string>& arguments) {
  OpenCounter counter(folder);
  const Ran ran = run_toile(arguments);
  EXPECT_TRUE(ran.code == 0 || ran.code == 3) << name << ": " << ran.err;  // 3: drape found no rest
  const std::map<std::string, int> opened = counter.opened();
  for (const char* file : {"project.json", "skirt.dxf"}) {
    ASSERT_TRUE(opened.contains(file)) << name << " has not read " << file;
    EXPECT_EQ(opened.at(file), 1) << name << " has read " << file << " again";
  }
}

TEST(Commands, ReadADocumentAndItsPatternOnce) {
  const fs::path folder = coarse_sample("reads");
  const std::string project = (folder / "project.json").string();
  const fs::path out = fresh_folder("reads_out");
  expect_read_once("check", folder, {"check", project});
  expect_read_once("drape", folder, {"drape", project, "--no-stills", "--out", (out / "drape").string()});
  expect_read_once("pattern export", folder,
                   {"pattern", "export", project, "--out", (out / "a.dxf").string()});
  expect_read_once("project arrange", folder,
                   {"project", "arrange", project, "--out", (out / "project.json").string()});
}

}  // namespace
}  // namespace toile
