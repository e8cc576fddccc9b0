// dermis parameters: the parameter table.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/commands.h"
#include "core/builtin/environments.h"
#include "core/light_rig/rig_fields.h"
#include "core/material/builtin_presets.h"
#include "core/material/parameter_docs.h"
#include "core/scene/cameras.h"

namespace dermis::cli {
namespace {

/// Those of the parameters, and those of what the program carries: views, light, presets.
std::vector<std::string> wordsOfTables() {
  std::vector<std::string> words = tableWords();
  const auto add = [&](std::string_view word) {
    if (!word.empty() && std::ranges::find(words, word) == words.end()) words.emplace_back(word);
  };
  for (const NamedCameraRow& row : namedCameras()) add(row.label);
  for (const BuiltinEnvironmentRow& row : builtinEnvironments())
    for (const std::string& word : {row.label, row.sentence}) add(word);
  for (const BuiltinPreset& preset : builtinPresets()) add(preset.name);
  return words;
}

}  // namespace

void addParameters(CLI::App& root, Action& action) {
  struct Options {
    bool json = false, markdown = false, schema = false, rigs = false, words = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      root.add_subcommand("parameters", "List every material parameter: id, type, range, default, meaning");
  auto* json = command->add_flag("--json", options->json, "As JSON, an array of rows");
  auto* markdown = command->add_flag("--markdown", options->markdown, "As a page in Markdown");
  command->add_flag("--schema", options->schema, "As the JSON Schema of preset files")
      ->excludes(json)
      ->excludes(markdown);
  json->excludes(markdown);
  command->add_flag("--rigs", options->rigs, "The keys of light rigs instead, as Markdown or with --schema")
      ->excludes(json);
  command->add_flag("--words", options->words, "What people read of it, a line each, for translators")
      ->excludes(json)
      ->excludes(markdown);
  command->footer(R"(
Examples:
  dermis parameters
  dermis parameters --json | jq '.[] | select(.group == "Subsurface") | .id'
  dermis parameters --schema > dermis.material.schema.json
  dermis parameters --rigs --schema > dermis.rig.schema.json)");
  command->callback([options, &action] {
    action = [options]() -> Outcome<int> {
      std::string text = options->words      ? fmt::format("{}", fmt::join(wordsOfTables(), "\n"))
                         : options->rigs     ? (options->schema ? rigsAsJsonSchema() : rigsAsMarkdown())
                         : options->json     ? parametersAsJson()
                         : options->markdown ? parametersAsMarkdown()
                         : options->schema   ? parametersAsJsonSchema()
                                             : parametersAsText();
      if (!text.ends_with('\n')) text += '\n';
      fmt::print("{}", text);
      return kDone;
    };
  });
}

}  // namespace dermis::cli
