// What is in a picture that the program wrote, beside the pixels.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The JSON that `dermis inspect --json` writes of a file.
json inspected(const std::filesystem::path& file) {
  const ProgramResult result = runDermis({"inspect", file.string(), "--json"});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
  return json::parse(result.output, nullptr, false);
}

class Picture : public testing::Test {
 protected:
  TemporaryFolder m_folder;

  ProgramResult render(const std::string& name, const std::vector<std::string>& arguments = {},
                       const std::map<std::string, std::string>& environment = {}) {
    std::vector<std::string> all = {"render", "--size", "48x32", "--samples", "2", "-o", (m_folder / name).string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProgramResult result = runDermis(all, environment);
    EXPECT_EQ(result.exitCode, 0) << result.allErrors();
    EXPECT_THAT(result.output, IsEmpty());
    return result;
  }
};

TEST_F(Picture, EveryFormatCarriesTheSceneVersionAndRenderer) {
  for (const char* name : {"look.png", "look.jpg", "look.tif", "look.exr"}) {
    render(name);
    const json image = inspected(m_folder / name);
    EXPECT_EQ(image["width"], 48) << name;
    EXPECT_EQ(image["height"], 32) << name;
    const json& said = image["metadata"]["dermis"];
    ASSERT_TRUE(said.is_object()) << name << ": " << image.dump();
    EXPECT_EQ(said["scene"]["format"], "dermis.scene") << name;
    EXPECT_TRUE(said["scene"]["materials"].contains("face")) << name;
    EXPECT_FALSE(said["version"].get<std::string>().empty()) << name;
    EXPECT_FALSE(said["gl_renderer"].get<std::string>().empty()) << name;
  }
}

TEST_F(Picture, NoMetadataLeavesAllOut) {
  for (const char* name : {"bare.png", "bare.exr"}) {
    render(name, {"--no-metadata"});
    EXPECT_THAT(contentOf(m_folder / name), Not(HasSubstr("dermis"))) << name;
  }
}

TEST_F(Picture, PathsAreRelativeToTheSceneAndOnlyNamesOutsideIt) {
  const std::string mesh = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  m_folder.write("project/meshes/inside.obj", mesh);
  m_folder.write("elsewhere/outside.json",
                 R"({"format": "dermis.material", "version": 1, "model": "metallic_roughness", "parameters": {}})");
  m_folder.write("project/look.dermis",
                 R"({"format": "dermis.scene", "version": 1, "model": {"path": "meshes/inside.obj"},
      "materials": {"*": "../elsewhere/outside.json"}})");
  render("look.png", {(m_folder / "project/look.dermis").string()});
  const json said = inspected(m_folder / "look.png")["metadata"]["dermis"];
  EXPECT_EQ(said["scene"]["model"]["path"], "meshes/inside.obj");
  EXPECT_THAT(said.dump(), Not(HasSubstr(m_folder.path().string())));
  std::map<std::string, std::string> hashes;
  for (const json& input : said["inputs"]) hashes[input["path"]] = input["xxh64"];
  EXPECT_EQ(hashes.count("meshes/inside.obj"), 1U);
  EXPECT_EQ(hashes.count("outside.json"), 1U);
  EXPECT_EQ(hashes["meshes/inside.obj"].size(), 16U);
}

TEST_F(Picture, IsVerifiedByRenderingAgain) {
  render("look.png", {"--set", "face/specular.perceptual_roughness=0.3", "--camera", "three-quarter"});
  const ProgramResult same = runDermis({"verify", (m_folder / "look.png").string(), "--tolerance", "0.01"});
  EXPECT_EQ(same.exitCode, 0) << same.allErrors() << same.output;
  render("bare.png", {"--no-metadata"});
  EXPECT_EQ(runDermis({"verify", (m_folder / "bare.png").string()}).exitCode, 3);
}

TEST_F(Picture, BallsAndChartAreToldAndDrawnAgain) {
  const std::string plain = (m_folder / "plain.png").string(), shown = (m_folder / "shown.png").string();
  render("plain.png");
  render("shown.png", {"--balls", "--chart"});
  EXPECT_EQ(runDermis({"compare", plain, shown, "--tolerance", "0.02"}).exitCode, 4);
  EXPECT_FALSE(inspected(plain)["metadata"]["dermis"].contains("references"));
  EXPECT_EQ(inspected(shown)["metadata"]["dermis"]["references"], (json{{"balls", true}, {"chart", true}}));
  EXPECT_EQ(runDermis({"verify", shown, "--tolerance", "0.01"}).exitCode, 0);
}

TEST_F(Picture, AovsAreFilesOfTheirOwnBesideAPng) {
  const std::string look = (m_folder / "look.png").string();
  const ProgramResult result = runDermis({"render", "--size", "48x32", "--samples", "2", "--aov", "Thickness", "--aov",
                                          "normal", "--view", "raw", "-o", look});
  ASSERT_EQ(result.exitCode, 0) << result.allErrors();
  // What the colours stand for is said, because the picture has no legend.
  EXPECT_THAT(result.output, HasSubstr("look.thickness.png: 0 to 20 mm"));
  EXPECT_THAT(result.output, Not(HasSubstr("normal")));
  const std::string normal = (m_folder / "look.normal.png").string();
  EXPECT_EQ(inspected(normal)["metadata"]["dermis"]["aov"], "normal");
  EXPECT_FALSE(inspected(look)["metadata"]["dermis"].contains("aov"));
  EXPECT_EQ(runDermis({"compare", look, normal, "--tolerance", "0.05"}).exitCode, 4);
  EXPECT_EQ(runDermis({"verify", normal, "--tolerance", "0.01"}).exitCode, 0);
}

TEST_F(Picture, AovsAreLayersOfAnExr) {
  render("look.exr", {"--view", "raw", "--aov", "diffuse_scattered", "--aov", "energy"});
  EXPECT_FALSE(std::filesystem::exists(m_folder / "look.energy.exr"));
  const std::string said = inspected(m_folder / "look.exr").dump();
  for (const char* channel : {"diffuse_scattered.R", "diffuse_scattered.B", "energy.R"})
    EXPECT_THAT(said, HasSubstr(channel));
  EXPECT_EQ(inspected(m_folder / "look.exr")["metadata"]["dermis"]["scene"]["format"], "dermis.scene");
}

TEST_F(Picture, ComparisonKnowsSameFromDifferent) {
  render("a.png");
  render("b.png", {"--set", "face/base.albedo=0.1,0.6,0.2"});
  const std::string a = (m_folder / "a.png").string();
  const std::string b = (m_folder / "b.png").string();
  EXPECT_EQ(runDermis({"compare", a, a, "--tolerance", "0"}).exitCode, 0);
  EXPECT_EQ(runDermis({"compare", a, b, "--tolerance", "0.001"}).exitCode, 4);
  EXPECT_EQ(runDermis({"compare", a, b}).exitCode, 0);
  const ProgramResult result = runDermis({"compare", a, b, "--json", "-o", (m_folder / "heat.png").string()});
  const json figures = json::parse(result.output, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << result.output;
  EXPECT_GT(figures["flip"].get<double>(), 0.0);
  EXPECT_LE(figures["flip"].get<double>(), 1.0);
  EXPECT_TRUE(std::filesystem::exists(m_folder / "heat.png"));
}

TEST_F(Picture, TheLocaleChangesNothing) {
  const std::vector<std::string> arguments = {"--set", "face/specular.perceptual_roughness=0.35", "--environment",
                                              "constant:0.5,0.75,1"};
  render("c.png", arguments, {{"LC_ALL", "C"}});
  render("hr.png", arguments, {{"LC_ALL", "hr_HR.UTF-8"}});
  EXPECT_EQ(contentOf(m_folder / "c.png"), contentOf(m_folder / "hr.png"));
}

TEST_F(Picture, ViewsAndCamerasAreCaseInsensitive) {
  render("a.png", {"--view", "thesis", "--camera", "Top-Left"});
  render("b.png", {"--view", "THESIS", "--camera", "top-left"});
  EXPECT_EQ(contentOf(m_folder / "a.png"), contentOf(m_folder / "b.png"));
}

}  // namespace
}  // namespace dermis::test
