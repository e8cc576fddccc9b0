// What the program comes with, so that a first start need not make it.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "cli/program.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What is kept below a folder, by its endings, sorted.
std::vector<std::string> keptBelow(const fs::path& folder) {
  std::vector<std::string> endings;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.path().extension().string().starts_with(".dermis")) endings.push_back(entry.path().extension());
  std::ranges::sort(endings);
  return endings;
}

TEST(ShippedLook, AFirstStartReadsItAndMakesOnlyWhatIsMissing) {
  const TemporaryFolder folder;
  const fs::path program = folder / "bin/dermis", shipped = folder / "share/dermis/cache";
  fs::create_directories(folder / "bin");
  fs::create_directories(folder / "share/dermis");
  fs::copy_file(DERMIS_BINARY, program);
  const std::vector<std::string> bake = {"bake", "look", "-o", shipped.string()};
  const ProgramResult baked = runProgram(program.string(), bake);
  ASSERT_EQ(baked.exitCode, 0) << baked.allErrors();
  EXPECT_THAT(baked.errors, IsEmpty());
  const std::vector<std::string> all = keptBelow(shipped);
  EXPECT_THAT(all, testing::IsSupersetOf({".dermisenv", ".dermishead", ".dermismap", ".dermismesh"}));

  const auto draw = [&](const std::string& name) {
    const ProgramResult drawn = runProgram(
        program.string(),
        {"render", "--size", "64x48", "--samples", "2", "--no-metadata", "-o", (folder / (name + ".png")).string()},
        {{"XDG_CACHE_HOME", (folder / name).string()}, {"MESA_SHADER_CACHE_DIR", (folder / "driver").string()}});
    EXPECT_EQ(drawn.exitCode, 0) << drawn.allErrors();
    return keptBelow(folder / name);
  };
  EXPECT_THAT(draw("first"), IsEmpty()) << "nothing was left to be made";

  // A damaged file is made again, for the user alone; all else is still read.
  const auto light = std::ranges::find_if(fs::directory_iterator(shipped / "bakes"), fs::directory_iterator(),
                                          [](const fs::path& file) { return file.extension() == ".dermisenv"; });
  ASSERT_NE(light, fs::directory_iterator());
  const fs::path damaged = light->path();
  fs::resize_file(damaged, fs::file_size(damaged) / 2);
  EXPECT_THAT(draw("mended"), ElementsAre(".dermisenv"));
  EXPECT_EQ(contentOf(folder / "mended.png"), contentOf(folder / "first.png"));

  // Made again it is whole, and rid of what no look asks for.
  const fs::path old = shipped / "maps/0123456789abcdef-0123456789abcdef.dermismap";
  folder.write("share/dermis/cache/maps/0123456789abcdef-0123456789abcdef.dermismap", "of an earlier version");
  fs::last_write_time(old, fs::last_write_time(damaged) - std::chrono::hours(1));
  ASSERT_EQ(runProgram(program.string(), bake).exitCode, 0);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_THAT(draw("again"), IsEmpty());
}

TEST(ShippedLook, AFolderThatCannotBeFilledIsNamed) {
  const TemporaryFolder folder;
  const ProgramResult nowhere = runDermis({"bake", "look", "-o", (folder / "none/cache").string()});
  EXPECT_EQ(nowhere.exitCode, 1);
  EXPECT_THAT(nowhere.allErrors(), HasSubstr((folder / "none/cache").string()));
}

}  // namespace
}  // namespace dermis::test
