// A scene whose map is a set of UDIM tiles, through the commands.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "core/image/comparison.h"
#include "core/io/importer.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class UdimScene : public testing::Test {
 protected:
  TemporaryFolder m_folder;

  void tile(const std::string& name, std::uint8_t value) {
    ImageLayer layer{"", {"Y"}, {}};
    layer.image.width = layer.image.height = 4;
    layer.image.channels = 1;
    layer.image.pixels.assign(16, std::byte{value});
    std::filesystem::create_directories((m_folder / name).parent_path());
    ASSERT_TRUE((*importer())->writeImage(m_folder / name, {layer}, {}));
  }
  /// A plane of two by two squares that shows its emission.
  std::string scene(const std::string& path) {
    const json map = {{"path", path}, {"uv_scale", {2, 2}}, {"color_space", "linear"}};
    const json material = {{"format", "dermis.material"},
                           {"version", 1},
                           {"model", "metallic_roughness"},
                           {"parameters", {{"base.albedo", 0}, {"metallic_roughness.emissive", 1}}},
                           {"textures", {{"emissive", map}}}};
    const json all = {{"format", "dermis.scene"},
                      {"version", 1},
                      {"model", {{"builtin", "plane"}}},
                      {"materials", {{"*", material}}},
                      {"environment", {{"constant", {0, 0, 0}}, {"background", "none"}}},
                      {"camera", {{"position", {0, 0, 5}}, {"target", {0, 0, 0}}, {"orthographic_height", 2}}}};
    return m_folder.write("look.dermis", all.dump()).string();
  }
  ProgramResult render(const std::string& from, const std::string& name, const std::string& view) {
    return runDermis(
        {"render", from, "--size", "16x16", "--samples", "1", "--view", view, "-o", (m_folder / name).string()});
  }
};

TEST_F(UdimScene, IsRenderedInspectedAndVerified) {
  tile("maps/skin.1001.png", 51);
  tile("maps/skin.1002.png", 102);
  tile("maps/skin.1012.png", 204);
  for (const char* path : {"maps/skin.<UDIM>.png", "maps/skin.%(UDIM)d.png", "maps/skin.1002.png"}) {
    const ProgramResult done = render(scene(path), "raw.exr", "raw");
    ASSERT_EQ(done.exitCode, 0) << path << done.allErrors();
    ASSERT_EQ(done.warnings.size(), 1U) << path;
    EXPECT_THAT(done.warnings[0], HasSubstr("1011")) << path;
    Warnings warnings;
    const auto image = (*importer())->loadImage(m_folder / "raw.exr", {}, warnings);
    ASSERT_TRUE(image) << image.error().message;
    const std::vector<float> red = channelValues(*image, 0);
    EXPECT_NEAR(red[12 * 16 + 4], 0.2F, 0.005F) << path;
    EXPECT_NEAR(red[12 * 16 + 12], 0.4F, 0.005F) << path;
    EXPECT_NEAR(red[4 * 16 + 12], 0.8F, 0.005F) << path;
    EXPECT_NEAR(red[4 * 16 + 4], 0.0F, 0.005F) << path;
  }
  ASSERT_EQ(render(scene("maps/skin.<UDIM>.png"), "look.png", "Raw").exitCode, 0);
  const std::string picture = (m_folder / "look.png").string();
  const ProgramResult good = runDermis({"verify", picture, "--tolerance", "0.001"});
  EXPECT_EQ(good.exitCode, 0) << good.allErrors();
  EXPECT_TRUE(good.warnings.empty() || good.warnings[0].find("1011") != std::string::npos) << good.warnings[0];
  tile("maps/skin.1012.png", 10);
  const ProgramResult changed = runDermis({"verify", picture, "--tolerance", "0.001"});
  EXPECT_EQ(changed.exitCode, 4);
  ASSERT_FALSE(changed.warnings.empty());
  EXPECT_THAT(changed.warnings[0], HasSubstr("skin.1012.png"));

  const ProgramResult said = runDermis({"inspect", (m_folder / "maps/skin.<UDIM>.png").string(), "--json"});
  ASSERT_EQ(said.exitCode, 0) << said.allErrors();
  const json set = json::parse(said.output, nullptr, false);
  EXPECT_EQ(set["kind"], "udim set");
  ASSERT_EQ(set["tiles"].size(), 3U);
  EXPECT_EQ(set["tiles"][2]["number"], 1012);
  EXPECT_EQ(set["tiles"][2]["width"], 4);
  const ProgramResult one = runDermis({"inspect", (m_folder / "maps/skin.1002.png").string(), "--json"});
  EXPECT_EQ(json::parse(one.output, nullptr, false)["udim_set"], "skin.<UDIM>.png");
}

TEST_F(UdimScene, WithoutTilesIsUnusable) {
  const ProgramResult none = render(scene("maps/skin.<UDIM>.png"), "raw.exr", "raw");
  EXPECT_EQ(none.exitCode, 3);
  ASSERT_EQ(none.errors.size(), 1U);
  EXPECT_THAT(none.errors[0], HasSubstr("skin.<UDIM>.png"));
}

}  // namespace
}  // namespace dermis::test
