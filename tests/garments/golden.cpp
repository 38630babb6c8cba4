#include "tests/garments/golden.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "core/drape/checkpoint.h"

namespace toile::test {
namespace {

constexpr const char* kPath = TOILE_SOURCE_DIR "/tests/data/golden_hashes.txt";
constexpr const char* kHead =
    "# Hash of the final positions of each sample, and the version of the engine that made them\n"
    "# (kCheckpointVersion). They are the same on every machine and by every compiler. When a change of the\n"
    "# engine is meant to change them: raise kCheckpointVersion in core/drape/checkpoint.h, run\n"
    "#   TOILE_WRITE_GOLDEN=1 build/release/test_garments --gtest_filter='Sample*'\n"
    "# look at the new drapes, and say in CHANGELOG.md why they are better.\n";

using Goldens = std::map<std::string, std::string>;  // name → hash; "engine" → version

Goldens read_goldens() {
  std::ifstream in(kPath);
  Goldens goldens;
  std::string line, name, value;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    if (!line.starts_with('#') && words >> name >> value) goldens[name] = value;
  }
  return goldens;
}

void write_golden(const std::string& sample, const std::string& hash) {
  Goldens goldens = read_goldens();
  const std::string engine = std::to_string(drape::kCheckpointVersion);
  const auto had = goldens.find(sample);
  if (had != goldens.end() && had->second != hash && goldens["engine"] == engine) {
    std::fprintf(
        stderr,
        "%s has changed and kCheckpointVersion has not: a server of the new engine would go on with\n"
        "checkpoints of the old one. Raise it in core/drape/checkpoint.h and write again.\n",
        sample.c_str());
  }
  goldens["engine"] = engine;
  goldens[sample] = hash;
  std::ofstream out(kPath, std::ios::trunc);
  out << kHead;
  for (const auto& [name, value] : goldens) out << name << " " << value << "\n";
  EXPECT_TRUE(out.flush()) << "cannot write " << kPath;
}

}  // namespace

void expect_golden(const std::string& sample, const std::string& hash) {
  const char* wanted = std::getenv("TOILE_WRITE_GOLDEN");
  if (wanted != nullptr && std::string(wanted) == "1") return write_golden(sample, hash);
  const Goldens goldens = read_goldens();
  const auto found = goldens.find(sample);
  ASSERT_NE(found, goldens.end()) << sample << " is not in " << kPath << ", which says how to write it";
  EXPECT_EQ(hash, found->second) << "the sample " << sample << " does not end in the bytes that " << kPath
                                 << " has; the file says what to do if that is meant";
  EXPECT_EQ(goldens.at("engine"), std::to_string(drape::kCheckpointVersion))
      << "the hashes are of another version of the engine; " << kPath << " says how to write them again";
}

}  // namespace toile::test
