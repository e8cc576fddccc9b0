// Result<T>: a value, or an Error with one sentence that a person can act on.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace dermis {

/// What went wrong: which file, what about it, where in it, what to do. `message` is one sentence for a person.
struct Error {
  enum class Kind {
    Input,      ///< a file (or what it says) is unusable: exit code 3
    Runtime,    ///< something failed while running (no GL 4.5, unwritable output): exit code 1
    Cancelled,  ///< the caller asked to stop
  };
  Kind kind = Kind::Runtime;
  std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> inputError(std::string message) {
  return tl::unexpected<Error>(Error{Error::Kind::Input, std::move(message)});
}
inline tl::unexpected<Error> runtimeError(std::string message) {
  return tl::unexpected<Error>(Error{Error::Kind::Runtime, std::move(message)});
}
inline tl::unexpected<Error> cancelledError() {
  return tl::unexpected<Error>(Error{Error::Kind::Cancelled, "cancelled"});
}

/// Sentences about what was repaired, ignored or assumed; they never stop anything.
using Warnings = std::vector<std::string>;

}  // namespace dermis
