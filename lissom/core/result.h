#pragma once
/// Errors as values: what is wrong, where, and what to do about it.

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "lissom/core/assert.h"

namespace lissom {

enum class ErrorCode {
  kFile,         ///< a file is missing, unreadable, unwritable or truncated
  kSyntax,       ///< the bytes are not the format they claim to be
  kUnknown,      ///< a name, key, set, material, quantity or option that does not exist
  kType,         ///< a value of the wrong kind or length
  kUnit,         ///< a unit that is missing, unknown or of the wrong dimension
  kRange,        ///< a number outside what is possible (NaN, negative radius, Poisson ratio above 1/2)
  kGeometry,     ///< zero-length rods, nodes that coincide, disconnected parts, curves that cannot be sampled
  kConflict,     ///< two statements that cannot both hold
  kUnsupported,  ///< understood, but beyond what this version computes
};

/// One mistake. `where` is a place the user can find: a JSON pointer ("/rods/3/section"), "file:line", or a name.
struct Error {
  ErrorCode code = ErrorCode::kRange;
  std::string where;
  std::string message;  ///< what is wrong, in the user's terms, one sentence without a full stop
  std::string hint;     ///< what to do about it; may be empty

  /// "where: message (hint)".
  std::string text() const {
    std::string s = where.empty() ? message : where + ": " + message;
    if (!hint.empty()) s += " (" + hint + ")";
    return s;
  }
};

/// A value or the error that prevented it.
template <class T>
class [[nodiscard]] Result {
 public:
  // Implicit, so that a function returns its value or its error as it is. NOLINTBEGIN(google-explicit-constructor)
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}
  // NOLINTEND(google-explicit-constructor)

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    LISSOM_ASSERT(ok());
    return std::get<0>(content_);
  }
  const T& value() const& {
    LISSOM_ASSERT(ok());
    return std::get<0>(content_);
  }
  T&& value() && {
    LISSOM_ASSERT(ok());
    return std::get<0>(std::move(content_));
  }
  const Error& error() const {
    LISSOM_ASSERT(!ok());
    return std::get<1>(content_);
  }

 private:
  std::variant<T, Error> content_;
};

/// Result of an operation without a value: empty when it succeeded.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor): as above

  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    LISSOM_ASSERT(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace lissom
