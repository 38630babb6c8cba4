// Same input, same bytes on every processor: what moves cloth may add, subtract, multiply, divide and take
// square roots, which IEEE 754 defines to the last bit. The C library's other functions differ between
// processors and versions, and so do a fused multiply-add and the processors' own approximations. Eigen sums
// in an order that depends on the vector width. Clocks, chance and hash tables have no place in a step.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace toile::rules {
namespace {

namespace fs = std::filesystem;

/// The rooms whose code runs in a step.
constexpr const char* kRooms[] = {"core/solver", "core/collision", "core/geometry"};

/// The text without comments; lines stay where they are.
std::string code_in(const std::string& text) {
  std::string code;
  enum { kCode, kLine, kBlock } in = kCode;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view two = std::string_view(text).substr(i, 2);
    if (in == kCode && two == "//") in = kLine;
    if (in == kCode && two == "/*") in = kBlock;
    if (in == kLine && text[i] == '\n') in = kCode;
    if (in == kCode || text[i] == '\n') code += text[i];
    if (in == kBlock && two == "*/") {
      in = kCode;
      ++i;
    }
  }
  return code;
}

/// "path:line: what" for each thing in the code that may give other bytes elsewhere.
std::vector<std::string> faults_in(const std::string& path, const std::string& text) {
  static const std::regex forbidden(
      R"(\b(sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|)"
      R"(hypot|cbrt|fma|fmod|remainder|erf|erfc|tgamma|lgamma)[fl]?\s*\()"
      R"(|\b_mm\w*_(fm|fnm|rcp|rsqrt)\w*|["',]fma\b)"
      R"(|#\s*include\s*<(Eigen/[^>]*|random|chrono|unordered_\w+|execution|cstdlib)>)"
      R"(|\bunordered_\w+|\bpar_unseq\b|\brandom_device\b|#\s*pragma\s+(omp|GCC\s+optimize|STDC)\b)"
      R"(|fast-math|\blong\s+double\b)");
  std::vector<std::string> faults;
  const std::string code = code_in(text);
  int line = 1;
  auto from = code.begin();
  for (std::sregex_iterator found(code.begin(), code.end(), forbidden), end; found != end; ++found) {
    const auto at = code.begin() + found->position();
    line += static_cast<int>(std::count(from, at, '\n'));
    from = at;
    faults.push_back(path + ":" + std::to_string(line) + ": " + found->str());
  }
  return faults;
}

TEST(Arithmetic, OfAStepIsWhatEveryProcessorDoesAlike) {
  int files = 0;
  for (const char* room : kRooms) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(TOILE_SOURCE_DIR) / room)) {
      const std::string kind = entry.path().extension();
      if (kind != ".h" && kind != ".cpp") continue;
      std::ifstream in(entry.path());
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      for (const std::string& fault : faults_in(entry.path(), text)) ADD_FAILURE() << fault;
      ++files;
    }
  }
  EXPECT_GT(files, 15) << "the rooms are there";
}

TEST(Arithmetic, KeepsTheCompilerFromFusingAndReordering) {
  std::ifstream in(fs::path(TOILE_SOURCE_DIR) / "CMakeLists.txt");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("-ffp-contract=off"), std::string::npos);
  for (const char* flag : {"-ffast-math", "-Ofast", "-funsafe-math", "-fassociative-math",
                           "-freciprocal-math", "-march=native", "-mfma"}) {
    EXPECT_EQ(text.find(flag), std::string::npos) << flag;
  }
}

TEST(Arithmetic, IsCaughtWhereItDiffers) {
  const auto count = [](const char* code) { return faults_in("a.cpp", code).size(); };
  EXPECT_EQ(count("double a = std::sin(x);"), 1u);
  EXPECT_EQ(count("double a = sinf (x) + std::hypot(x, y);"), 2u);
  EXPECT_EQ(count("y = fma(a, b, c);"), 1u);
  EXPECT_EQ(count("v = _mm256_fmadd_pd(a, b, c), w = _mm_rsqrt_ps(a);"), 2u);
  EXPECT_EQ(count("[[gnu::target(\"avx2,fma\")]] void f();"), 1u);
  EXPECT_EQ(count("#include <Eigen/Core>\n#include <chrono>\n"), 2u);
  EXPECT_EQ(count("std::unordered_map<int, int> m;"), 1u);
  EXPECT_EQ(count("/* atan2(y, x) */ int a; // pow(2, 3)\n"), 0u);
  EXPECT_EQ(count("double sine = sqrt(1 - c * c); fabs(x); using_sin (x); exponent(2); // ok"), 0u);
  EXPECT_EQ(faults_in("a.cpp", "\n/* \n */ int a;\nx = std::pow(x, 2);")[0], "a.cpp:4: pow(");
}

}  // namespace
}  // namespace toile::rules
