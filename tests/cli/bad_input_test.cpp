// Files that are missing, cut short or lying: one sentence that names the file, and exit code 3; outputs that cannot be
// written: 1.
#include <gmock/gmock.h>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class BadInput : public testing::Test {
 protected:
  TemporaryFolder m_folder;

  ProgramResult render(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"render", "--size", "16x16", "--samples", "1", "-o", (m_folder / "x.png").string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return runDermis(all);
  }
  void expectUnusable(const ProgramResult& result, const std::string& place) {
    EXPECT_EQ(result.exitCode, 3) << result.allErrors();
    ASSERT_THAT(result.errors, SizeIs(1));
    EXPECT_THAT(result.errors[0], HasSubstr(place));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "x.png"));
  }
  std::string scene(const std::string& name, const std::string& body) {
    return m_folder.write(name, R"({"format": "dermis.scene", "version": 1, )" + body + "}").string();
  }
};

TEST_F(BadInput, MissingScene) { expectUnusable(render({(m_folder / "missing.dermis").string()}), "missing.dermis"); }

TEST_F(BadInput, TruncatedScene) {
  expectUnusable(render({m_folder.write("cut.dermis", R"({"format": "dermis.scene", "version": 1,)").string()}),
                 "cut.dermis");
}

TEST_F(BadInput, SceneOfAFutureVersion) {
  expectUnusable(render({m_folder.write("new.dermis", R"({"format": "dermis.scene", "version": 999})").string()}),
                 "/version");
}

TEST_F(BadInput, ParameterOfAWrongTypeIsNamedByItsPointer) {
  expectUnusable(
      render({scene("type.dermis", R"("materials": {"*": {"format": "dermis.material", "version": 1, "model": "skin",
      "parameters": {"specular.perceptual_roughness": "shiny"}}})")}),
      "/materials/*/parameters/specular.perceptual_roughness");
}

TEST_F(BadInput, NumbersThatAreNoneAreRefused) {
  expectUnusable(render({scene("nan.dermis", R"("camera": {"position": [0, 0, 1e999]})")}), "nan.dermis");
}

TEST_F(BadInput, MissingModel) {
  expectUnusable(render({scene("nomodel.dermis", R"("model": {"path": "nothing.glb"})")}), "nothing.glb");
}

TEST_F(BadInput, MissingMapIsNamedWithItsSlot) {
  const ProgramResult result =
      render({scene("nomap.dermis", R"("model": {"builtin": "plane"}, "materials": {"*": {"format": "dermis.material",
      "version": 1, "model": "skin", "parameters": {}, "textures": {"albedo": {"path": "nothing.png"}}}})")});
  expectUnusable(result, "nothing.png");
  EXPECT_THAT(result.errors[0], HasSubstr("albedo"));
}

TEST_F(BadInput, MissingEnvironmentPresetAndBuiltin) {
  expectUnusable(render({"--environment", (m_folder / "no.hdr").string()}), "no.hdr");
  expectUnusable(render({"--material", (m_folder / "no.json").string()}), "no.json");
  expectUnusable(render({scene("moon.dermis", R"("environment": {"builtin": "moon"})")}), "moon");
  expectUnusable(render({scene("teapot.dermis", R"("model": {"builtin": "teapot"})")}), "teapot");
}

TEST_F(BadInput, BrokenColourConfiguration) {
  const std::string config = m_folder.write("config.ocio", "not a configuration").string();
  const ProgramResult result = runDermis(
      {"render", "--size", "16x16", "--samples", "1", "-o", (m_folder / "x.png").string()}, {{"OCIO", config}});
  expectUnusable(result, "config.ocio");
}

TEST_F(BadInput, DamagedModelsAndImages) {
  using namespace std::string_literals;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"garbage.glb", "glTF"s + std::string(64, '\0')},
      {"empty.obj", ""},
      {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
      {"beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n"},
      {"cut.stl", "solid x\nfacet normal 0 0 1\n outer loop\n  vertex 0 0"},
      {"garbage.exr", "v/1\x01"s + std::string(64, 'x')},
      {"empty.png", ""},
      {"zero.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n"},
      {"cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\nab"},
      {"huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000 +X 2000000\n"},
      {"list.json", "[1, 2, 3]"},
      {"other.json", R"({"format": "something.else", "version": 1})"},
  };
  for (const auto& [name, bytes] : files) {
    const ProgramResult result = runDermis({"inspect", m_folder.write(name, bytes).string()});
    EXPECT_EQ(result.exitCode, 3) << name << ": " << result.allErrors();
    ASSERT_THAT(result.errors, SizeIs(1)) << name;
    EXPECT_THAT(result.errors[0], HasSubstr(name));
  }
}

TEST_F(BadInput, ModelsWithStrangeNumbersAreRefusedOrRepaired) {
  const std::string nan =
      m_folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 4 3\n").string();
  const ProgramResult inspected = runDermis({"inspect", nan, "--json"});
  EXPECT_TRUE(inspected.exitCode == 0 || inspected.exitCode == 3) << inspected.allErrors();
  if (inspected.exitCode == 0) {
    EXPECT_EQ(render({"--model", nan}).exitCode, 0);
  }

  const std::string flat =
      m_folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.5\nf 1/1 2/1 3/1\n").string();
  const ProgramResult drawn = render({"--model", flat});
  EXPECT_EQ(drawn.exitCode, 0) << drawn.allErrors();
}

TEST_F(BadInput, ImagesOfTwoSizesCannotBeCompared) {
  ASSERT_EQ(render({}).exitCode, 0);
  const std::string other = (m_folder / "y.png").string();
  ASSERT_EQ(runDermis({"render", "--size", "8x8", "--samples", "1", "-o", other}).exitCode, 0);
  const ProgramResult result = runDermis({"compare", (m_folder / "x.png").string(), other});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.errors, SizeIs(1));
}

TEST_F(BadInput, OutputsThatCannotBeWritten) {
  const std::string nowhere = (m_folder / "no/such/folder/x.png").string();
  ProgramResult result = runDermis({"render", "--size", "16x16", "-o", nowhere});
  EXPECT_EQ(result.exitCode, 1);
  ASSERT_THAT(result.errors, SizeIs(1));
  EXPECT_THAT(result.errors[0], HasSubstr("folder"));

  std::filesystem::create_directory(m_folder / "folder.png");
  result = runDermis({"render", "--size", "16x16", "-o", (m_folder / "folder.png").string()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.errors, SizeIs(1));

  // A folder that takes no files: the kernel's own is closed to the superuser too.
  result = runDermis({"render", "--size", "16x16", "-o", "/proc/x.png"});
  EXPECT_EQ(result.exitCode, 1);
  ASSERT_THAT(result.errors, SizeIs(1));
  EXPECT_THAT(result.errors[0], HasSubstr("/proc/x.png"));
}

TEST_F(BadInput, AnUnwritableCacheIsNoError) {
  const std::string file = m_folder.write("a-file", "").string();
  const ProgramResult result = runDermis(
      {"render", "--size", "16x16", "--samples", "1", "-o", (m_folder / "x.png").string()}, {{"XDG_CACHE_HOME", file}});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
}

TEST_F(BadInput, WarningsDoNotChangeTheExitCode) {
  const ProgramResult result = render({"--set", "specular.perceptual_roughness=7"});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("specular.perceptual_roughness")));
}

}  // namespace
}  // namespace dermis::test
