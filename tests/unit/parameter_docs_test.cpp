#include "core/material/parameter_docs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/json_text.h"
#include "core/material/parameter_table.h"
#include "core/material/value_json.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using testing::HasSubstr;

// To write the two files anew: `dermis parameters --markdown > docs/parameters.md` and
// `dermis parameters --schema > resources/schema/dermis.material.schema.json`.
TEST(ParameterDocs, TheCommittedFilesAreTheProgramsOwn) {
  const std::string source = DERMIS_SOURCE_DIR;
  EXPECT_EQ(test::contentOf(source + "/docs/parameters.md"), parametersAsMarkdown());
  EXPECT_EQ(test::contentOf(source + "/resources/schema/dermis.material.schema.json"), parametersAsJsonSchema());
}

TEST(ParameterDocs, EveryRowIsInEveryDocument) {
  const Json rows = parseJson(parametersAsJson(), "rows").value();
  const Json schema = parseJson(parametersAsJsonSchema(), "schema").value();
  ASSERT_EQ(rows.size(), parameterTable().size());
  std::size_t index = 0;
  for (const ParameterRow& row : parameterTable()) {
    const Json& json = rows[index++];
    EXPECT_EQ(json.at("id"), row.id);
    for (const char* key : {"label", "group", "type", "unit", "hard", "soft", "default", "invalidates", "models",
                            "sentence", "source", "words", "map"})
      EXPECT_TRUE(json.contains(key)) << row.id << " " << key;
    EXPECT_EQ(json.at("default"), parameterToJson(row, row.defaultValue()));
    EXPECT_THAT(parametersAsText(), HasSubstr(std::string(row.id)));
    EXPECT_THAT(parametersAsMarkdown(), HasSubstr("`" + std::string(row.id) + "`"));
    EXPECT_TRUE(schema.at("properties").at("parameters").at("properties").contains(row.id));
  }
}

// packaging/translations.sh writes it anew.
TEST(ParameterDocs, TranslatorsFindEveryWordOfTheTables) {
  const std::string text = test::contentOf(DERMIS_SOURCE_DIR "/translations/dermis_template.ts");
  const std::size_t begin = text.find("<name>tables</name>");
  ASSERT_NE(begin, std::string::npos);
  const std::string context = text.substr(begin, text.find("</context>", begin) - begin);
  EXPECT_GT(tableWords().size(), 100U);
  for (std::string word : tableWords()) {
    for (const auto& [plain, escaped] : {std::pair("&", "&amp;"), std::pair("<", "&lt;"), std::pair(">", "&gt;"),
                                         std::pair("\"", "&quot;"), std::pair("'", "&apos;")})
      for (std::size_t at = 0; (at = word.find(plain, at)) != std::string::npos; at += std::string(escaped).size())
        word.replace(at, 1, escaped);
    EXPECT_THAT(context, HasSubstr("<source>" + word + "</source>"));
  }
}

TEST(ParameterDocs, ChoicesAreShownAsWords) {
  EXPECT_EQ(choiceLabel("mean_free_path"), "Mean free path");
  EXPECT_EQ(choiceLabel("burley"), "Burley");
}

}  // namespace
}  // namespace dermis
