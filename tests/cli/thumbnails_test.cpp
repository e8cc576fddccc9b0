// dermis thumbnails: a picture of each preset.
#include <gmock/gmock.h>

#include <fstream>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class Thumbnails : public testing::Test {
 protected:
  TemporaryFolder m_folder;
  fs::path m_out = m_folder.path() / "out";
};

TEST_F(Thumbnails, EachPresetHasAPictureOfItsOwnUnderItsName) {
  const ProgramResult result = runDermis({"thumbnails", "builtin:jade", "milk=builtin:milk", "builtin:eye_brown", "-o",
                                          m_out.string(), "--size", "48x40", "--samples", "1"});
  EXPECT_EQ(result.exitCode, 0) << result.allErrors();
  EXPECT_THAT(result.errors, IsEmpty());
  std::vector<Image> pictures;
  std::string expected;
  for (const char* name : {"jade.png", "milk.png", "eye_brown.png"}) {
    pictures.push_back(readPicture(m_out / name));
    EXPECT_EQ(pictures.back().width, 48);
    EXPECT_EQ(pictures.back().height, 40);
    expected += (m_out / name).string() + "\n";
  }
  EXPECT_EQ(result.output, expected);
  EXPECT_NE(pictures[0].pixels, pictures[1].pixels);
  EXPECT_NE(pictures[1].pixels, pictures[2].pixels);
}

TEST_F(Thumbnails, AreTheSameAloneAndTogether) {
  const std::vector<std::string> how = {"--size", "32x32", "--samples", "2", "-o"};
  const auto draw = [&](std::vector<std::string> presets, const fs::path& folder) {
    std::vector<std::string> arguments = {"thumbnails"};
    arguments.insert(arguments.end(), presets.begin(), presets.end());
    arguments.insert(arguments.end(), how.begin(), how.end());
    arguments.push_back(folder.string());
    EXPECT_EQ(runDermis(arguments).exitCode, 0);
  };
  draw({"builtin:face_tone_vi", "builtin:jade", "builtin:skin_tone_ii"}, m_out);
  for (const char* name : {"face_tone_vi", "jade", "skin_tone_ii"}) {
    const fs::path alone = m_folder.path() / name;
    draw({std::string("builtin:") + name}, alone);
    EXPECT_EQ(readPicture(alone / (std::string(name) + ".png")).pixels,
              readPicture(m_out / (std::string(name) + ".png")).pixels)
        << name;
  }
}

TEST_F(Thumbnails, OneThatCannotBeDrawnKeepsNoneOfTheOthersFromIt) {
  const fs::path broken = m_folder.path() / "broken.json";
  std::ofstream(broken) << "{ \"material\": ";
  const ProgramResult result = runDermis({"thumbnails", "builtin:milk", broken.string(), "builtin:none", "builtin:wax",
                                          "-o", m_out.string(), "--size", "16x16", "--samples", "1"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.allErrors(), HasSubstr("broken.json"));
  EXPECT_THAT(result.allErrors(), HasSubstr("none"));
  EXPECT_TRUE(fs::exists(m_out / "milk.png"));
  EXPECT_TRUE(fs::exists(m_out / "wax.png"));
  EXPECT_FALSE(fs::exists(m_out / "broken.png"));
}

TEST_F(Thumbnails, TwoOfOneNameAreNotDrawnOverEachOther) {
  const ProgramResult result = runDermis({"thumbnails", "builtin:milk", "milk=builtin:wax", "-o", m_out.string()});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.allErrors(), HasSubstr("milk.png"));
  EXPECT_FALSE(fs::exists(m_out));
}

TEST_F(Thumbnails, NamesAreNamesOfFiles) {
  const ProgramResult result = runDermis({"thumbnails", "../x=builtin:milk", "-o", m_out.string()});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.allErrors(), HasSubstr("../x=builtin:milk"));
  EXPECT_FALSE(fs::exists(m_out));
}

}  // namespace
}  // namespace dermis::test
