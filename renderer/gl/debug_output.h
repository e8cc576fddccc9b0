// GL errors and KHR_debug messages, recorded so that a test can fail on them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace dermis::gl {

/// Listens to the current context from construction to destruction. Everything that the driver marks as an error, or as
/// of high severity, is kept; chatter is not.
class DebugOutput {
 public:
  /// `synchronous`: a message arrives inside the call that caused it (tests, debuggers); slower.
  explicit DebugOutput(bool synchronous);
  ~DebugOutput();
  DebugOutput(const DebugOutput&) = delete;
  DebugOutput& operator=(const DebugOutput&) = delete;

  /// Asks glGetError too, and returns what was recorded since the last call.
  [[nodiscard]] Warnings take();
  /// Errors since construction.
  [[nodiscard]] std::uint64_t count() const { return m_count; }
  /// Adds what glGetError knows to the record.
  void poll();

  void record(std::string message);

 private:
  std::vector<std::string> m_messages;
  std::uint64_t m_count = 0;
};

}  // namespace dermis::gl
