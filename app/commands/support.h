// What the commands share: how they fail, what they print, where they may write.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::cli {

enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2, kUnusableInput = 3, kDifferent = 4 };

/// Why a command stops: its exit code and one sentence.
struct Failure {
  int exitCode = kFailed;
  std::string sentence;
};
template <class T>
using Outcome = tl::expected<T, Failure>;
/// What a subcommand does once its arguments are read; returns an exit code.
using Action = std::function<Outcome<int>()>;

[[nodiscard]] tl::unexpected<Failure> failure(const Error& error);
[[nodiscard]] tl::unexpected<Failure> wrongUsage(std::string sentence);

/// "warning: …", a line each, on stderr; clears the list.
void printWarnings(Warnings& warnings);
/// "dermis: …" in one line on stderr; returns the exit code.
int report(const Failure& failure);

/// Whether a file can be put there, asked before the work: the extension is one of `extensions` (".png"), the folder
/// exists and can be written. Fails with 2 and 1.
[[nodiscard]] Outcome<void> checkOutputFile(const std::filesystem::path& path,
                                            std::span<const std::string_view> extensions);

[[nodiscard]] std::string extensionOf(const std::filesystem::path& path);  ///< lower case, with the dot

/// "1280x720". Fails with 2.
[[nodiscard]] Outcome<glm::ivec2> parseSize(std::string_view text);

/// A line on stderr that grows while work goes on, on a terminal only; nothing at all elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted = true);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(std::string_view what, double fraction);
  void clear();

 private:
  bool m_active;
  bool m_shown = false;
};

/// CPU seconds of this process so far, user and system.
[[nodiscard]] double cpuSeconds();

}  // namespace dermis::cli
