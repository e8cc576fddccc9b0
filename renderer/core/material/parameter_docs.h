// The parameter table as documents: for a terminal, for programs, for a page, for validators.
#pragma once

#include <string>

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

}  // namespace dermis
