// Small pictures kept under tests/golden, one line of cases.json each, rendered again and compared by named tolerances.
// With DERMIS_GOLDEN_UPDATE set the pictures are replaced instead: tests/golden/update.sh.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "core/image/comparison.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kFolder = DERMIS_GOLDEN_DIR;

/// How far a picture may be from the kept one.
struct Tolerance {
  double mean;     ///< of all channels
  double maximum;  ///< of any channel
  double past;     ///< a pixel with a channel further off than this fails …
  double failing;  ///< … and this share of the pixels may
};

const json& cases() {
  static const json kCases = json::parse(contentOf(kFolder / "cases.json"));
  return kCases;
}

Tolerance tolerance(const std::string& name) {
  const json& t = cases()["tolerances"][name];
  return {t["mean"], t["maximum"], t["past"], t["failing"]};
}

/// Standard deviation of the green channel: a black or empty picture has none.
double variation(const Image& image) {
  const std::vector<float> values = channelValues(image, 1);
  double sum = 0.0, squares = 0.0;
  for (const float v : values) {
    sum += static_cast<double>(v);
    squares += static_cast<double>(v) * static_cast<double>(v);
  }
  const auto n = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsKept) {
  const auto& list = cases()["cases"];
  const auto it = std::find_if(list.begin(), list.end(), [](const json& c) { return c["name"] == GetParam(); });
  ASSERT_NE(it, list.end());
  const TemporaryFolder folder;
  fs::copy(kFolder / "maps", folder / "maps", fs::copy_options::recursive);
  const fs::path picture = folder / (GetParam() + ".png");
  std::vector<std::string> arguments = {
      "render", "--size", it->value("size", "128x128"), "--samples", "16", "--no-metadata", "-o", picture.string()};
  if (it->contains("scene")) {
    json scene = {{"format", "dermis.scene"}, {"version", 1}};
    scene.update((*it)["scene"]);
    arguments.push_back(folder.write("scene.dermis", scene.dump()).string());
  }
  for (const json& argument : it->value("arguments", json::array())) arguments.push_back(argument);
  const ProgramResult result = runDermis(arguments);
  ASSERT_EQ(result.exitCode, 0) << result.allErrors();

  const fs::path kept = kFolder / "pictures" / picture.filename();
  const Image now = readPicture(picture);
  EXPECT_GT(variation(now), 0.02) << "the picture is empty";
  if (std::getenv("DERMIS_GOLDEN_UPDATE") != nullptr) {
    fs::copy_file(picture, kept, fs::copy_options::overwrite_existing);
    return;
  }
  ASSERT_TRUE(fs::exists(kept)) << "no kept picture; tests/golden/update.sh makes it";
  const Tolerance allowed = tolerance(it->value("tolerance", "filtered"));
  const auto comparison = compareImages(readPicture(kept), now, allowed.past);
  ASSERT_TRUE(comparison) << comparison.error().message;
  EXPECT_LE(comparison->mean, allowed.mean);
  EXPECT_LE(comparison->maximum, allowed.maximum);
  EXPECT_LE(comparison->failing, allowed.failing);
  if (HasFailure())
    if (const char* where = std::getenv("DERMIS_GOLDEN_OUT"))
      fs::copy_file(picture, fs::path(where) / picture.filename(), fs::copy_options::overwrite_existing);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const json& c : cases()["cases"]) result.push_back(c["name"]);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(names()), [](const auto& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-'; }, '_');
  return name;
});

}  // namespace
}  // namespace dermis::test
