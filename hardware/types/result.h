// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace horopter::hardware {

/// Why a call on hardware or I/O failed, in a sentence that names the remedy where there is one.
enum class ErrorCode {
  kNotActive,     ///< the device's lifecycle state does not allow the call
  kOutOfRange,    ///< a command no axis or wheel could ever execute (not finite)
  kTimeout,       ///< no answer before the deadline
  kDisconnected,  ///< the link is gone; the device is in fault
  kProtocol,      ///< the answer could not be understood, or was an error reply
  kUnavailable,   ///< the device or service does not exist here
};

struct Error {
  ErrorCode code;
  std::string message;
};

/// A value, or the error that prevented it. Never both, never neither.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// @pre ok()
  const T& value() const& {
    assert(ok());
    return std::get<0>(state_);
  }
  T&& value() && {
    assert(ok());
    return std::get<0>(std::move(state_));
  }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }

  /// @pre !ok()
  const Error& error() const {
    assert(!ok());
    return std::get<1>(state_);
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// @pre !ok()
  const Error& error() const {
    assert(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace horopter::hardware
