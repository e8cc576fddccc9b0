// The one program: a subcommand, or the editor on the files given.
#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <clocale>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app/commands/commands.h"
#ifdef DERMIS_EDITOR
#include "app/gui.h"
#endif

namespace {

using dermis::cli::Action;

constexpr const char* kDescription = "Dermis draws physically based skin: an editor, and these commands.";

constexpr const char* kFooter = R"(
With no command the editor opens, on the files given: a scene, presets, a model, an environment.

Examples:
  dermis
  dermis face.dermis
  dermis render face.dermis -o face.png
  dermis COMMAND --help

Exit codes: 0 done; 1 failed while running; 2 wrong usage; 3 an input file is unusable; 4 a comparison is past
its tolerance. Errors and warnings go to stderr, an error in one sentence. Commands need no display.
Environment: OCIO, a colour configuration to use instead of the built-in one; XDG_CACHE_HOME, where baked
environments are kept.)";

/// "render" and not "face.dermis": a first word without dot and slash that names no file can only be a command.
bool isCommandWord(const std::string& word) {
  std::error_code error;
  return !word.empty() && word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, error);
}

bool isFile(const std::string& word) { return !word.empty() && word.front() != '-' && !isCommandWord(word); }

/// CLI11's own message, as one sentence of ours.
int reportUsage(const CLI::App& app, const CLI::ParseError& error) {
  const auto parsed = app.get_subcommands();
  const std::string where = parsed.empty() ? "dermis" : "dermis " + parsed.front()->get_name();
  return dermis::cli::report({dermis::cli::kWrongUsage, fmt::format("{}; see {} --help", error.what(), where)});
}

int runCommand(int argc, char** argv) {
  CLI::App app(kDescription, "dermis");
  app.footer(kFooter);
  app.ignore_case();
  app.set_version_flag("--version", "dermis " DERMIS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  Action action;
  dermis::cli::addRender(app, action);
  dermis::cli::addThumbnails(app, action);
  dermis::cli::addBake(app, action);
  dermis::cli::addExport(app, action);
  dermis::cli::addInspect(app, action);
  dermis::cli::addCompare(app, action);
  dermis::cli::addVerify(app, action);
  dermis::cli::addParameters(app, action);
  dermis::cli::addBenchmark(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return reportUsage(app, error);
  }
  const auto outcome = action();
  return outcome ? *outcome : dermis::cli::report(outcome.error());
}

/// In the editor, images and meshes go back to the system when they are freed. glibc raises its threshold to the
/// largest of them it has seen freed, and keeps what lies between longer-lived ones: a quarter of the editor's memory.
/// A command ends soon: what it frees is used again, which touches an eighth less memory.
void chooseLargeBlocks(bool isEditor) {
#ifdef __GLIBC__
  constexpr int kLarge = 256 * 1024, kLargestAllowed = 32 * 1024 * 1024;  // bytes
  mallopt(M_MMAP_THRESHOLD, isEditor ? kLarge : kLargestAllowed);
  if (isEditor) return;
  mallopt(M_TRIM_THRESHOLD, 2 * kLargestAllowed);
  mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_logger_mt("dermis"));
  spdlog::set_pattern("%l: %v");
  spdlog::set_level(spdlog::level::warn);
  try {
    const std::string first = argc > 1 ? argv[1] : "";
    const bool isEditor = argc <= 1 || isFile(first);
    chooseLargeBlocks(isEditor);
    if (isEditor) {
      std::vector<std::filesystem::path> files(argv + 1, argv + argc);
      for (const std::filesystem::path& file : files)
        if (file.native().starts_with('-'))
          return dermis::cli::report(
              {dermis::cli::kWrongUsage,
               fmt::format("the editor takes files only, not {}; see dermis --help", file.string())});
#ifdef DERMIS_EDITOR
      return dermis::runEditor(argc, argv, files);
#else
      return dermis::cli::report(
          {dermis::cli::kFailed, "this build of dermis has no editor; see dermis --help for its commands"});
#endif
    }
    return runCommand(argc, argv);
  } catch (const std::bad_alloc&) {
    return dermis::cli::report({dermis::cli::kFailed, "there is not enough memory for this"});
  } catch (const std::exception& error) {
    return dermis::cli::report(
        {dermis::cli::kFailed, fmt::format("something unforeseen went wrong: {}", error.what())});
  }
}
