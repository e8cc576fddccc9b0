// Help, versions, exit codes and what goes to stdout.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

const std::vector<std::string> kCommands = {"render",     "bake",      "inspect", "compare",   "verify",
                                            "parameters", "benchmark", "export",  "thumbnails"};

TEST(Usage, VersionIsOneLine) {
  const ProgramResult result = runDermis({"--version"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, StartsWith("dermis "));
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST(Usage, HelpNamesEveryCommandAndTheExitCodes) {
  const ProgramResult result = runDermis({"--help"});
  EXPECT_EQ(result.exitCode, 0);
  for (const std::string& command : kCommands) EXPECT_THAT(result.output, HasSubstr(command));
  EXPECT_THAT(result.output, HasSubstr("Exit codes"));
}

TEST(Usage, EveryCommandHasHelpWithExamples) {
  for (const std::string& command : kCommands) {
    const ProgramResult result = runDermis({command, "--help"});
    EXPECT_EQ(result.exitCode, 0) << command;
    EXPECT_THAT(result.output, HasSubstr("Examples:")) << command;
  }
}

TEST(Usage, CommandNamesAreCaseInsensitive) { EXPECT_EQ(runDermis({"Parameters", "--json"}).exitCode, 0); }

/// A command line that says something wrong by itself.
class WrongUsage : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(WrongUsage, IsOneSentenceAndTwo) {
  const ProgramResult result = runDermis(GetParam());
  EXPECT_EQ(result.exitCode, 2) << result.allErrors();
  EXPECT_THAT(result.errors, SizeIs(1));
  EXPECT_THAT(result.output, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    CommandLines, WrongUsage,
    testing::Values(std::vector<std::string>{"no-such-command"}, std::vector<std::string>{"--no-such-option"},
                    std::vector<std::string>{"render", "--no-such-option"}, std::vector<std::string>{"render"},
                    std::vector<std::string>{"render", "-o", "picture.gif"},
                    std::vector<std::string>{"render", "-o", "picture"},
                    std::vector<std::string>{"render", "--size", "12", "-o", "x.png"},
                    std::vector<std::string>{"render", "--size", "0x8", "-o", "x.png"},
                    std::vector<std::string>{"render", "--size", "8x8x8", "-o", "x.png"},
                    std::vector<std::string>{"render", "--samples", "0", "-o", "x.png"},
                    std::vector<std::string>{"render", "--samples", "many", "-o", "x.png"},
                    std::vector<std::string>{"render", "--camera", "behind", "-o", "x.png"},
                    std::vector<std::string>{"render", "--camera", "{\"position\": 3}", "-o", "x.png"},
                    std::vector<std::string>{"render", "--camera", "{\"position\"", "-o", "x.png"},
                    std::vector<std::string>{"render", "--view", "no such view", "-o", "x.png"},
                    std::vector<std::string>{"render", "--aov", "no_such_aov", "-o", "x.exr"},
                    std::vector<std::string>{"render", "--aov", "normal", "-o", "x.gif"},
                    std::vector<std::string>{"render", "--model", "builtin:teapot", "-o", "x.png"},
                    std::vector<std::string>{"render", "--environment", "builtin:moon", "-o", "x.png"},
                    std::vector<std::string>{"render", "--environment", "constant:1,2", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "specular.perceptual_roughness", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "no.such.parameter=1", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "specular.perceptual_roughness=shiny", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "specular.perceptual_roughness=nan", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "nose/specular.perceptual_roughness=0.3", "-o",
                                             "x.png"},
                    std::vector<std::string>{"render", "--set", "lens/subsurface.scale=2", "-o", "x.png"},
                    std::vector<std::string>{"render", "--set", "thesis.sss_scale=2", "-o", "x.png"},
                    std::vector<std::string>{"compare", "only-one.png"},
                    std::vector<std::string>{"compare", "a.png", "b.png", "--tolerance", "-1"},
                    std::vector<std::string>{"parameters", "--json", "--markdown"},
                    std::vector<std::string>{"look.dermis", "--fullscreen"}));

TEST(Usage, TheEditorWithoutADisplayIsOneSentenceAndOne) {
  for (const std::map<std::string, std::string>& environment :
       {std::map<std::string, std::string>{}, {{"DISPLAY", ""}}, {{"DISPLAY", ":4321"}}}) {
    const ProgramResult result = runDermis({}, environment);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.errors, SizeIs(1)) << result.allErrors();
  }
}

TEST(Usage, ParametersAsJsonIsNothingElse) {
  const ProgramResult result = runDermis({"parameters", "--json"});
  EXPECT_EQ(result.exitCode, 0);
  const json rows = json::parse(result.output, nullptr, false);
  ASSERT_TRUE(rows.is_array());
  EXPECT_THAT(result.output, HasSubstr("subsurface.radius_mm"));
}

TEST(Usage, ParametersInEveryForm) {
  EXPECT_THAT(runDermis({"parameters"}).output, HasSubstr("specular.perceptual_roughness"));
  EXPECT_THAT(runDermis({"parameters", "--markdown"}).output, HasSubstr("| "));
  EXPECT_TRUE(json::parse(runDermis({"parameters", "--schema"}).output, nullptr, false).is_object());
}

TEST(Usage, BenchmarkAsJsonIsNothingElseAndLoadsNoImportModule) {
  const ProgramResult result = runDermis({"benchmark", "--json", "--size", "64x64", "--frames", "2"});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
  const json figures = json::parse(result.output, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << result.output;
  for (const char* key : {"gl", "load", "bake", "frame_moving"}) EXPECT_TRUE(figures.contains(key)) << key;
  EXPECT_FALSE(figures["gl"]["renderer"].get<std::string>().empty());
  EXPECT_FALSE(figures["import_module_loaded"].get<bool>());
}

TEST(Usage, GlInfoSaysWhichPlatformDraws) {
  const ProgramResult result = runDermis({"render", "--gl-info"});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
  EXPECT_THAT(result.output, HasSubstr("EGL"));
}

}  // namespace
}  // namespace dermis::test
