// Reading and writing under a locale that writes 0,5 and 1.000: nothing may change.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <locale>

#include "core/base/number_format.h"
#include "core/material/parameter_docs.h"
#include "core/material/preset_io.h"
#include "core/scene/scene_io.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Makes a C locale with a decimal comma and sets it (none need be installed); false where there is no localedef.
bool setCommaLocale(const test::TemporaryFolder& folder) {
  folder.write("comma", "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n");
  const std::string in = folder.path().string();
  // -c: although only one category is defined. The character set is localedef's own.
  const std::string command = "localedef -c -i '" + in + "/comma' -f ANSI_X3.4-1968 '" + in + "/xx_XX' >/dev/null 2>&1";
  if (std::system(command.c_str()) > 256) return false;  // 1, in the upper byte, only warns
  ::setenv("LOCPATH", in.c_str(), 1);
  return std::setlocale(LC_NUMERIC, "xx_XX") != nullptr && *std::localeconv()->decimal_point == ',';
}

TEST(Locale, NothingDependsOnIt) {
  const auto everything = [] {
    Warnings warnings;
    Material material;
    material.parameters.surfaceDetailTiling = 1000.0F;
    const std::string preset = writePreset(material, "/p");
    Scene scene;
    scene.camera = Camera{};
    scene.camera->position = {0.25F, 12345.5F, 6.5F};
    const std::string text = writeScene(scene, "/p");
    return preset + writePreset(readPreset(preset, "a", "/p", warnings).value(), "/p") + text +
           writeScene(readScene(text, "a", "/p", warnings).value(), "/p") + parametersAsMarkdown() +
           parametersAsJson() + shortestDecimal(1234567.0F) + shortestDecimal(*parseFloat("0.45"));
  };
  const std::string expected = everything();
  const test::TemporaryFolder folder;
  const std::locale before;
  std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  const bool commaInC = setCommaLocale(folder);
  const std::string actual = everything();
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  ::unsetenv("LOCPATH");
  EXPECT_EQ(actual, expected);
  RecordProperty("c_locale_with_comma", commaInC ? "yes" : "no");
}

}  // namespace
}  // namespace dermis
