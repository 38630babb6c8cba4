#include "server/app/read_password.h"

#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace toile::app {
namespace {

/// What is typed is not shown while this is there.
class Unseen {
 public:
  Unseen() {
    ::tcgetattr(STDIN_FILENO, &before_);
    termios unseen = before_;
    unseen.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &unseen);
  }
  ~Unseen() { ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_); }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;

 private:
  termios before_{};
};

std::string asked_for(const char* words) {
  std::fprintf(stderr, "%s: ", words);
  const Unseen unseen;
  std::string line;
  std::getline(std::cin, line);
  std::fprintf(stderr, "\n");
  return line;
}

}  // namespace

Result<std::string> read_password() {
  std::string password;
  if (::isatty(STDIN_FILENO) == 0) {
    std::getline(std::cin, password);
  } else {
    password = asked_for("Password");
    if (asked_for("Once more") != password) return Error{"usage.password", "the two are not alike", ""};
  }
  if (!password.empty()) return password;
  return Error{"usage.password", "there is no password on stdin", ""};
}

}  // namespace toile::app
