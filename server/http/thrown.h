#pragma once
// Exceptions that come out of a coroutine that nobody awaits. Internal to http.

#include <exception>
#include <string>

#include "core/base/log.h"

namespace toile {

inline std::string words_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "something that is no exception";
  }
}

/// For co_spawn in place of asio::detached, which would drop what is thrown without a word. `place` says in
/// the log what broke off.
inline auto or_log(Log log, const char* place) {
  return [log = std::move(log), place](const std::exception_ptr& thrown) {
    if (thrown) log.error(place, LogFields{{"what", words_of(thrown)}});
  };
}

}  // namespace toile
