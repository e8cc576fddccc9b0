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

/// Sets a C locale with a decimal comma, from those installed or made on the spot; false where there is none to be had.
bool setCommaLocale(const test::TemporaryFolder& folder) {
  const auto works = [](const char* name) {
    return std::setlocale(LC_ALL, name) != nullptr && *std::localeconv()->decimal_point == ',';
  };
  for (const char* name : {"hr_HR.UTF-8", "hr_HR.utf8", "de_DE.UTF-8", "fr_FR.UTF-8"})
    if (works(name)) return true;
  const std::string made = (folder / "hr_HR.UTF-8").string();
  const std::string command = "localedef -i hr_HR -f UTF-8 '" + made + "' >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return false;
  ::setenv("LOCPATH", folder.path().c_str(), 1);
  return works("hr_HR.UTF-8");
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
