// A light rig written out in the scene, as the editor saves an edited one, through the commands.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json rigWith(double radiance) {
  const json box = {{"type", "softbox"}, {"name", "Key"},    {"azimuth_degrees", -30}, {"elevation_degrees", 30},
                    {"distance_m", 2},   {"size_m", {1, 1}}, {"radiance", radiance}};
  return {{"format", "dermis.rig"}, {"version", 1}, {"name", "One box"}, {"width", 256}, {"elements", {box}}};
}

class InlineRig : public testing::Test {
 protected:
  TemporaryFolder m_folder;

  std::string sceneIn(const json& environment) {
    const json all = {{"format", "dermis.scene"},
                      {"version", 1},
                      {"model", {{"builtin", "sphere"}}},
                      {"environment", environment},
                      {"camera", {{"position", {0, 0, 5}}, {"target", {0, 0, 0}}, {"orthographic_height", 2.4}}}};
    return m_folder.write("look.dermis", all.dump()).string();
  }
  ProgramResult render(const std::string& scene, const std::string& name) {
    return runDermis(
        {"render", scene, "--size", "32x32", "--samples", "2", "--no-metadata", "-o", (m_folder / name).string()});
  }
};

TEST_F(InlineRig, LightsAsTheSameRigInAFile) {
  m_folder.write("rig.json", rigWith(40.0).dump());
  ProgramResult done = render(sceneIn({{"path", "rig.json"}}), "file.png");
  ASSERT_EQ(done.exitCode, 0) << done.allErrors();
  done = render(sceneIn({{"rig", rigWith(40.0)}}), "inline.png");
  ASSERT_EQ(done.exitCode, 0) << done.allErrors();
  EXPECT_EQ(contentOf(m_folder / "inline.png"), contentOf(m_folder / "file.png"));
  ASSERT_EQ(render(sceneIn({{"rig", rigWith(10.0)}}), "dimmer.png").exitCode, 0);
  EXPECT_NE(contentOf(m_folder / "dimmer.png"), contentOf(m_folder / "inline.png"));
}

TEST_F(InlineRig, IsSavedInThePicturesMetadataAndVerified) {
  const std::string picture = (m_folder / "look.png").string();
  const ProgramResult done =
      runDermis({"render", sceneIn({{"rig", rigWith(40.0)}}), "--size", "32x32", "--samples", "2", "-o", picture});
  ASSERT_EQ(done.exitCode, 0) << done.allErrors();
  const ProgramResult inspected = runDermis({"inspect", picture, "--json"});
  const json said = json::parse(inspected.output, nullptr, false);
  EXPECT_EQ(said["metadata"]["dermis"]["scene"]["environment"]["rig"]["elements"][0]["name"], "Key")
      << inspected.output;
  const ProgramResult same = runDermis({"verify", picture});
  EXPECT_EQ(same.exitCode, 0) << same.allErrors();
}

TEST_F(InlineRig, AFaultIsNamedByItsPlaceInTheScene) {
  json rig = rigWith(40.0);
  rig["elements"][0]["type"] = "lamp";
  const ProgramResult refused = render(sceneIn({{"rig", rig}}), "none.png");
  EXPECT_NE(refused.exitCode, 0);
  ASSERT_EQ(refused.errors.size(), 1U) << refused.allErrors();
  EXPECT_THAT(refused.errors[0], HasSubstr("look.dermis"));
  EXPECT_THAT(refused.errors[0], HasSubstr("/environment/rig/elements/0/type"));
}

}  // namespace
}  // namespace dermis::test
