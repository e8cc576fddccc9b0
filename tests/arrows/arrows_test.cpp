// The arrows of docs/architecture.md, read off the #include lines. The CMake targets enforce most of them at link time;
// this also catches a header that happens to be on the compiler's path.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "arrows/include_rules.h"

namespace dermis::arrows {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path kSource = DERMIS_SOURCE_DIR;

TEST(Arrows, CoreKnowsNeitherOpenGlNorQtNorOthersFileFormats) {
  EXPECT_THAT(violations(kSource / "renderer/core",
                         {kGl, kQt, kAssimp, kOpenImageIo, kOpenColorIo, kCommandLine, kUi, kApp, kImport}),
              IsEmpty());
}

TEST(Arrows, ImportKnowsNeitherOpenGlNorQt) {
  EXPECT_THAT(violations(kSource / "renderer/import", {kGl, kQt, kOpenColorIo, kCommandLine, kUi, kApp}), IsEmpty());
}

TEST(Arrows, RendererKnowsNoQtAndNoFileLibraries) {
  EXPECT_THAT(violations(kSource / "renderer", {kQt, kAssimp, kOpenImageIo, kCommandLine, kUi, kApp, kImport},
                         {"core", "import"}),
              IsEmpty());
}

TEST(Arrows, UiMakesNoGlCallsAndHasNoFileFormats) {
  // QOpenGLWidget and its context are how the widget hosts the renderer; functions of GL come only through libepoxy or
  // Qt's wrappers.
  const std::regex glCalls(
      R"((epoxy|GL|EGL|GLES[23]?)/.*|(.*/)?(gl|passes|lighting)/.*|(QtOpenGL/)?QOpenGL(Functions|ExtraFunctions|VersionFunctions).*)");
  EXPECT_THAT(
      violations(kSource / "ui", {glCalls, kAssimp, kOpenImageIo, kOpenColorIo, kJson, kCommandLine, kApp, kImport}),
      IsEmpty());
}

TEST(Arrows, CommandsKnowNoShadingAndNoWidgets) {
  const std::regex widgets(R"(Q(tWidgets/.*|Widget|MainWindow|Dialog|Slider|OpenGL.*))");
  EXPECT_THAT(violations(kSource / "app", {kAssimp, kOpenImageIo, kOpenColorIo, kImport, widgets}), IsEmpty());
}

TEST(Arrows, PublicRendererHeaderNeedsNoGl) {
  std::ifstream file(kSource / "renderer/renderer.h");
  ASSERT_TRUE(file) << "renderer/renderer.h is missing";
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const Include& include : includesOf(text)) EXPECT_FALSE(std::regex_match(include.header, kGl)) << include.header;
}

TEST(Arrows, SearchFindsWhatIsForbidden) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "dermis-arrows";
  std::filesystem::create_directories(folder / "core");
  std::ofstream(folder / "bad.cpp")
      << "#include <vector>\n#include <QWidget>\n// #include <epoxy/gl.h>\n#  include \"epoxy/gl.h\"\n";
  std::ofstream(folder / "core/worse.h") << "#include <assimp/scene.h>\n";
  EXPECT_THAT(violations(folder, {kGl, kQt, kAssimp}, {"core"}),
              ElementsAre(HasSubstr("bad.cpp:2 includes QWidget"), HasSubstr("bad.cpp:4 includes epoxy/gl.h")));
  EXPECT_THAT(violations(folder, {kAssimp}), ElementsAre(HasSubstr("worse.h:1 includes assimp/scene.h")));
  std::filesystem::remove_all(folder);
}

TEST(Arrows, FamiliesTellTheirHeadersFromOurs) {
  for (const char* header : {"QWidget", "QtWidgets/QWidget", "qglobal.h"})
    EXPECT_TRUE(std::regex_match(header, kQt)) << header;
  for (const char* header : {"core/base/result.h", "glm/glm.hpp", "queue", "renderer.h"}) {
    EXPECT_FALSE(std::regex_match(header, kQt)) << header;
    EXPECT_FALSE(std::regex_match(header, kGl)) << header;
  }
}

}  // namespace
}  // namespace dermis::arrows
