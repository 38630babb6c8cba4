#include "tests/bench/service/house.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <sstream>

#include "tests/app/program.h"
#include "tests/bench/service/visitor.h"

namespace toile::bench {
namespace {

namespace fs = std::filesystem;

std::string said_by(const std::vector<std::string>& arguments) {
  const Ran ran = run_toile(arguments);
  if (ran.code != 0) give_up("toile " + arguments[0] + ": " + ran.err);
  return ran.out.substr(0, ran.out.find('\n'));
}

}  // namespace

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

House::House(const std::vector<std::string>& options) : folder_(fresh_folder("toile_bench")) {
  serve(options);
}

House::House(const std::vector<std::string>& accounts, const std::vector<std::string>& options)
    : folder_(fresh_folder("toile_bench")) {
  const std::string data = folder_ / "data";
  for (const std::string& name : accounts) {
    said_by({"account", "add", name, "--data", data});
    tokens_.push_back(said_by({"token", "make", name, "--data", data}));
  }
  serve(options);
}

House::~House() {
  server_->end(SIGTERM, 40);
  server_.reset();
  fs::remove_all(folder_);
}

void House::serve(std::vector<std::string> options) {
  options.insert(options.end(), {"--no-sample", "--log", "text"});
  server_ = std::make_unique<Serving>(folder_ / "data", options);
  if (!server_->up()) give_up("the server does not start: " + server_->said());
}

double House::resident_mb() const {
  std::ifstream in("/proc/" + std::to_string(server_->pid()) + "/status");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  }
  give_up("the server is gone");
}

double House::worked_s() const {
  const std::string text = text_of("/proc/" + std::to_string(server_->pid()) + "/stat");
  std::istringstream in(text.substr(text.rfind(')') + 2));  // a program's name may hold blanks
  std::string word;
  double ticks = 0;
  for (int field = 3; in >> word; ++field) {
    if (field >= 14 && field <= 17) ticks += std::stod(word);  // utime, stime, cutime, cstime
  }
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace toile::bench
