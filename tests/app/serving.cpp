#include "tests/app/serving.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <system_error>
#include <thread>

#include "tests/app/program.h"

extern char** environ;

namespace toile {
namespace {

void pause_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

}  // namespace

Serving::Serving(const std::filesystem::path& data, const std::vector<std::string>& more, int port) {
  static int number = 0;
  const auto tls = std::find(more.begin(), more.end(), "--tls-certificate");
  if (tls != more.end()) roots_ = *(tls + 1);
  log_ = data.parent_path() / ("serving" + std::to_string(++number) + ".log");
  std::string program = std::string(TOILE_BINARY_DIR) + "/toile";
  std::vector<std::string> words{"serve", "--port", std::to_string(port), "--data", data.string()};
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> argv{program.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  if (posix_spawn(&pid_, program.c_str(), &files, nullptr, argv.data(), environ) != 0) pid_ = -1;
  posix_spawn_file_actions_destroy(&files);
  for (int i = 0; i < 3000 && port_ == 0; ++i) {
    const std::string text = said();
    const std::size_t at = text.find("serves on http");
    if (at != std::string::npos && text.find('\n', at) != std::string::npos) {
      const std::size_t host = text.find("://", at) + 3;
      port_ = std::stoi(text.substr(text.find(':', host) + 1));
    } else if (pid_ < 0 || waitpid(pid_, nullptr, WNOHANG) != 0) {
      pid_ = -1;
      return;
    }
    pause_a_little();
  }
}

Serving::~Serving() {
  if (pid_ > 0) end(SIGKILL);
}

int Serving::end(int signal, double within_s) {
  if (pid_ <= 0) return -1;
  kill(pid_, signal);
  int status = 0;
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(within_s);
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) kill(pid_, SIGKILL);
    pause_a_little();
  }
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::vector<pid_t> Serving::readers() const {
  std::vector<pid_t> found;
  std::error_code gone;
  for (const auto& thread :
       std::filesystem::directory_iterator("/proc/" + std::to_string(pid_) + "/task", gone)) {
    std::ifstream in(thread.path() / "children");
    for (pid_t child = 0; in >> child;) {
      // Before it becomes the reader it shares the server's memory, which waits for it.
      const bool reads =
          text_of("/proc/" + std::to_string(child) + "/cmdline").find("import-mesh") != std::string::npos;
      if (reads) found.push_back(child);
    }
  }
  return found;
}

std::string Serving::said() const { return text_of(log_); }

http::HttpReply Serving::ask(const http::HttpClient::Request& request) const {
  Result<http::HttpClient> client = http::HttpClient::make(url(), roots_);
  if (!client) return {};
  Result<http::HttpReply> reply = client->ask(request, std::chrono::seconds(30));
  return reply ? *reply : http::HttpReply{};
}

http::HttpReply Serving::get(const std::string& target) const {
  http::HttpClient::Request request;
  request.target = target;
  return ask(request);
}

http::HttpReply Serving::post(const std::string& target, const std::string& json,
                              const std::string& key) const {
  http::HttpClient::Request request;
  request.method = "POST";
  request.target = target;
  request.body = json;
  if (!json.empty()) request.content_type = "application/json";
  if (!key.empty()) request.headers.emplace_back("Idempotency-Key", key);
  return ask(request);
}

}  // namespace toile
