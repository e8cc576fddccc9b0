// The parameter table as documents: for a terminal, for programs, for a page, for validators.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dermis {

/// One line a parameter: id, type, default, range and unit, and the sentence below it.
[[nodiscard]] std::string parametersAsText();
/// An array of rows: id, label, group, type, unit, hard, soft, default, invalidates, models, sentence, source, words,
/// map.
[[nodiscard]] std::string parametersAsJson();
/// docs/parameters.md.
[[nodiscard]] std::string parametersAsMarkdown();
/// JSON Schema (2020-12) of preset files, format "dermis.material", version 1.
[[nodiscard]] std::string parametersAsJsonSchema();
/// Labels, groups, sentences and choices of the tables of parameters, shading models and maps, each once: what a
/// translator needs beside the editor's own words.
[[nodiscard]] std::vector<std::string> tableWords();
/// How a choice is shown: "mean_free_path" is "Mean free path".
[[nodiscard]] std::string choiceLabel(std::string_view word);

}  // namespace dermis
