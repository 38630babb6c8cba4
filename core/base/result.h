#pragma once
// Bad input is not an exception but a value: Result<T> holds a T, or an Error that names the place.
// TRY(…) takes the T out, or leaves the function with the Error.

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace toile {

/// What an error means to whoever called: what it is answered with, and whether trying again helps. Code of
/// ours branches on this, never on the words of Error::code.
enum class ErrorKind : std::uint8_t {
  kInput,          ///< what was given cannot be used
  kMalformed,      ///< it has not even the form that it should have: no JSON, no cursor that a list gave
  kTooLarge,       ///< it is more than is taken
  kNotFound,       ///< there is no such thing, or it is somebody else's
  kConflict,       ///< as things stand this cannot be done
  kStale,          ///< it was changed since it was looked at
  kUnconditional,  ///< a change must say what it changes
  kTooMany,        ///< too much is under way; it may go well later
  kUnavailable,    ///< whoever does it is not there just now; it may go well later
  kNoRoom,         ///< the disk is full
  kCancelled,      ///< nobody wants it any more
  kSystem,         ///< disk, database or child process let us down, or what was kept is damaged
  kInternal,       ///< a fault of ours
};

/// What went wrong.
struct Error {
  std::string code;     ///< stable, lower case with dots, e.g. "dxf.truncated", for programs outside
  std::string message;  ///< one sentence for a person, with the way out
  std::string where;    ///< the place: file and line, piece, edge, JSON pointer; empty when there is none
  ErrorKind kind = ErrorKind::kInput;
};

/// The same error, seen from further up: with another place.
Error placed_at(Error error, std::string where);

/// "code: message (where)", as the command line prints it.
std::string to_string(const Error& error);

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// REQUIRES ok().
  T& value() & {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }

  /// REQUIRES !ok().
  const Error& error() const& {
    assert(!ok());
    return *std::get_if<1>(&state_);
  }
  Error&& error() && {
    assert(!ok());
    return std::move(*std::get_if<1>(&state_));
  }

 private:
  std::variant<T, Error> state_;
};

/// The result of an act that makes nothing: success, or an Error.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}  // NOLINT: implicit on purpose
  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  /// REQUIRES !ok().
  const Error& error() const& {
    assert(!ok());
    return *error_;
  }
  Error&& error() && {
    assert(!ok());
    return *std::move(error_);
  }
  /// Nothing, so that TRY(…) reads alike for both.
  void value() && { assert(ok()); }

 private:
  std::optional<Error> error_;
};

}  // namespace toile

/// The value of a Result, or, when it holds an Error, `return` of that Error from the enclosing function,
/// which gives back a Result or a Status itself: `const Panel panel = TRY(read_panel(file));`. It stands
/// alone on the right of `=` or as a statement: a return out of the middle of a larger expression would leave
/// open which of its other parts were evaluated. A statement expression is an extension of GCC and Clang, our
/// compilers.
#define TRY(...)                                                  \
  __extension__({                                                 \
    auto toile_tried = (__VA_ARGS__);                             \
    if (!toile_tried.ok()) return std::move(toile_tried).error(); \
    std::move(toile_tried).value();                               \
  })
