// Models written for other programs: what is read back is what went out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fixtures.h"

namespace dermis {
namespace {

using namespace fixtures;
using testing::HasSubstr;

/// Middle of a triangle's positions, normals and UVs: tells triangles of a sphere apart, in whatever order they come.
using Middle = std::array<float, 8>;

std::vector<Middle> middles(const Model& model, bool withUvs) {
  std::vector<Middle> result;
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    Middle middle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = model.indices[i + k];
      const glm::vec3 position = model.positions[v] * model.millimetresPerUnit;
      for (int c = 0; c < 3; ++c) {
        middle.at(static_cast<std::size_t>(c)) += position[c] / 3.0F;
        middle.at(static_cast<std::size_t>(3 + c)) += model.normals[v][c] / 3.0F;
      }
      if (!withUvs) continue;
      middle[6] += model.uvs[v].x / 3.0F;
      middle[7] += model.uvs[v].y / 3.0F;
    }
    result.push_back(middle);
  }
  const auto rounded = [](const Middle& m) {
    return std::array{std::lround(m[0] * 20.0F), std::lround(m[1] * 20.0F), std::lround(m[2] * 20.0F)};
  };
  std::ranges::sort(result, {}, rounded);
  return result;
}

Model read(const std::filesystem::path& path) {
  auto model = module().loadModel(path);
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

/// A sphere of 100 mm whose caps are another slot.
Model twoSlots(const Folder& folder) {
  Model model = read(folder.put("sphere.obj", objSphere(12, 24)));
  ModelSlot caps = model.slots.front();
  caps.name = "caps";
  model.slots.front().name = "band";
  model.slots.push_back(caps);
  const std::uint32_t third = model.parts.front().indexCount / 9 * 3;
  model.parts.push_back({1, third, model.parts.front().indexCount - third});
  model.parts.front().indexCount = third;
  model.millimetresPerUnit = 1000.0F;
  return model;
}

class ModelWriter : public testing::TestWithParam<const char*> {};

TEST_P(ModelWriter, WhatIsReadBackIsWhatWentOut) {
  const Folder folder;
  const Model model = twoSlots(folder);
  const std::string extension = GetParam();
  const std::filesystem::path path = folder / ("out" + extension);
  const auto written = module().writeModel(path, model);
  ASSERT_TRUE(written.has_value()) << written.error().message;
  const Model again = read(path);
  const bool withUvs = extension != ".stl";
  const auto expected = middles(model, withUvs), got = middles(again, withUvs);
  ASSERT_EQ(got.size(), expected.size());
  EXPECT_GT(expected.size(), 500U);
  // STL keeps no vertex normals: ours are made anew.
  const std::array<float, 3> tolerance = {1e-3F, extension == ".stl" ? 0.05F : 1e-4F, 1e-5F};
  for (std::size_t i = 0; i < got.size(); ++i)
    for (std::size_t c = 0; c < 8; ++c)
      ASSERT_NEAR(got[i].at(c), expected[i].at(c), tolerance.at(c / 3)) << "triangle " << i << ", " << c;
  if (extension == ".obj" || extension == ".glb") {
    ASSERT_EQ(again.slots.size(), 2U);
    EXPECT_EQ(again.slots[0].name, "band");
    EXPECT_EQ(again.slots[1].name, "caps");
    EXPECT_EQ(again.parts[0].indexCount, model.parts[0].indexCount);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ModelWriter, testing::Values(".glb", ".obj", ".ply", ".stl"),
                         [](const auto& row) { return std::string(row.param).substr(1); });

TEST(ModelWriterErrors, AnEndingThatIsNoModelsAndAFolderThatIsNotThere) {
  const Folder folder;
  const Model model = twoSlots(folder);
  const auto wrongEnding = module().writeModel(folder / "out.fbx", model);
  ASSERT_FALSE(wrongEnding.has_value());
  EXPECT_THAT(wrongEnding.error().message, HasSubstr(".glb, .obj, .ply or .stl"));
  const auto noFolder = module().writeModel(folder / "none/out.glb", model);
  ASSERT_FALSE(noFolder.has_value());
  EXPECT_EQ(noFolder.error().kind, Error::Kind::Runtime);
}

}  // namespace
}  // namespace dermis
