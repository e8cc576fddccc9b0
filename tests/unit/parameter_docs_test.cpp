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

}  // namespace
}  // namespace dermis
