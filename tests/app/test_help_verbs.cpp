// The command line told to shells and to man.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What a shell prints.
std::string said_by(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> part{};
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), n);
  pclose(pipe);
  return text;
}

/// What bash would offer for the last of these words.
std::string offered(const std::string& words) {
  static const std::string script = run_toile({"completion"}).out;
  const fs::path file = fresh_folder("toile_completion") / "trial.sh";
  write_text(file, script + "COMP_WORDS=(" + words + ")\n" +
                       "COMP_CWORD=$((${#COMP_WORDS[@]}-1))\n_toile\necho \"${COMPREPLY[*]}\"\n");
  return said_by("bash " + file.string());
}

TEST(Completion, OffersVerbsOptionsAndTheirChoices) {
  EXPECT_EQ(offered("toile dr"), "drape\n");
  EXPECT_EQ(offered("toile pattern ex"), "export\n");
  EXPECT_EQ(offered("toile pattern export --pa"), "--paper\n");
  EXPECT_EQ(offered("toile pattern export --paper ''"), "a4 a3 a0 letter\n");
  EXPECT_EQ(offered("toile serve --log j"), "json\n");
}

TEST(Completion, LeavesFilesToTheShell) {
  EXPECT_EQ(offered("toile drape ''"), "\n");
  EXPECT_EQ(offered("toile drape drape"), "\n") << "a file of a verb's name";
  EXPECT_EQ(offered("toile drape --out ''"), "\n");
}

TEST(Man, HasEachVerbWithItsOptionsOnce) {
  const Ran man = run_toile({"man"});
  ASSERT_EQ(man.code, 0) << man.err;
  for (const char* verb : {"drape", "pattern export", "body make", "fabric calibrate", "verify", "man"}) {
    const std::string head = ".SS \"toile " + std::string(verb) + "\"\n";
    const std::size_t at = man.out.find(head);
    ASSERT_NE(at, std::string::npos) << verb;
    EXPECT_EQ(man.out.find(head, at + 1), std::string::npos) << verb;
  }
  EXPECT_TRUE(has(man.out, "\\fB\\-\\-paper\\fR \\fIa4|a3|a0|letter\\fR"));
  const std::size_t codes = man.out.find("Exit codes:");
  ASSERT_NE(codes, std::string::npos);
  EXPECT_EQ(man.out.find("Exit codes:", codes + 1), std::string::npos) << "not under every verb";
}

TEST(Usage, AVerbThatIsNotThereIsNamedBesideThoseThatAre) {
  const Ran below = run_toile({"fabric", "shw"});
  EXPECT_EQ(below.code, 2);
  EXPECT_TRUE(has(below.err, "there is no \"toile fabric shw\"; there are list, show, test, calibrate"));
  EXPECT_TRUE(has(below.err, "see toile fabric --help")) << below.err;
  EXPECT_TRUE(has(run_toile({"drpe", "a.json"}).err, "there is no \"toile drpe\"; there are drape, "));
  EXPECT_TRUE(has(run_toile({"pattern", "export"}).err, "see toile pattern export --help"));
}

}  // namespace
}  // namespace toile
