#pragma once
// Bad input is not an exception but a value: Result<T> holds a T, or an Error that names the place.
// TRY(…) takes the T out, or leaves the function with the Error.

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace toile {

/// What went wrong with an input.
struct Error {
  std::string code;     ///< stable, lower case with dots, e.g. "dxf.truncated"; programs match on it
  std::string message;  ///< one sentence for a person, with the way out
  std::string where;    ///< the place: file and line, piece, edge, JSON pointer; empty when there is none
};

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
