// What a person reads in the editor goes through tr(): no literal is handed to a function that shows text.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace dermis {
namespace {

/// "file:line: text" of each literal with a word in it that a showing function is given as it stands.
std::vector<std::string> untranslated(const std::string& source, const std::string& name) {
  // The function, its bracket, and a literal as first argument; objectName and style sheets are for machines.
  static const std::regex kShown(
      R"rx((?:setText|setToolTip|setStatusTip|setWhatsThis|setWindowTitle|setAccessibleName|setAccessibleDescription|setPlaceholderText|setSuffix|setPrefix|setTitle|setInformativeText|addAction|addMenu|addItem|addTab|addRow|addSection|new\s+QLabel|new\s+QPushButton|new\s+QCheckBox|new\s+QRadioButton|new\s+QGroupBox|showMessage|Q_EMIT message)\s*\(\s*(?:MessageKind::\w+\s*,\s*)?(?:QStringLiteral|QLatin1String|QString::fromUtf8)?\s*\(?\s*"([^"]*)")rx");
  // Letters beyond format marks, units and file patterns.
  static const std::regex kWord(R"([A-Za-z]{3,})");
  // Names are the same in every language.
  static const std::regex kMarkup(R"(<[^>]*>|%\d|%L\d|\\n|sRGB|ACES|Dermis)");
  std::vector<std::string> found;
  for (std::sregex_iterator it(source.begin(), source.end(), kShown), end; it != end; ++it) {
    const std::string text = std::regex_replace((*it)[1].str(), kMarkup, " ");
    if (!std::regex_search(text, kWord)) continue;
    const auto line = 1 + std::count(source.begin(), source.begin() + it->position(), '\n');
    found.push_back(name + ":" + std::to_string(line) + ": " + text);
  }
  return found;
}

TEST(Translation, WhatIsShownGoesThroughTr) {
  const std::filesystem::path folder = std::filesystem::path(DERMIS_SOURCE_DIR) / "ui";
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    ++files;
    std::ifstream file(entry.path());
    const std::string source{std::istreambuf_iterator<char>(file), {}};
    for (const std::string& place : untranslated(source, entry.path().filename().string())) ADD_FAILURE() << place;
  }
  EXPECT_GT(files, 40);
}

TEST(Translation, ALiteralIsFoundAndWhatIsNoWordIsNot) {
  EXPECT_EQ(untranslated("a;\nlabel->setText(QStringLiteral(\"Hello there\"));", "f").size(), 1U);
  EXPECT_EQ(untranslated("auto* l = new QLabel(\"Plain words\", this);", "f").size(), 1U);
  EXPECT_EQ(untranslated("b->setText(tr(\"Hello there\"));", "f").size(), 0U);
  EXPECT_EQ(untranslated("b->setText(QStringLiteral(\"%1 × %2\"));", "f").size(), 0U);
}

TEST(Translation, TheTemplateForTranslatorsIsThere) {
  std::ifstream file(std::filesystem::path(DERMIS_SOURCE_DIR) / "translations/dermis_template.ts");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("<source>&amp;Save scene</source>"), std::string::npos)
      << "translations/dermis_template.ts is old; packaging/translations.sh writes it anew";
}

}  // namespace
}  // namespace dermis
