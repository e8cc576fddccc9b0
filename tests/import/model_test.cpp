// Good models: what they come out as.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.h"

namespace dermis {
namespace {

using namespace fixtures;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Model load(const std::filesystem::path& path) {
  auto model = module().loadModel(path);
  if (!model) throw std::runtime_error(model.error().message);
  EXPECT_EQ(brokenPromise(*model), "");
  return std::move(*model);
}

std::vector<std::string> slotNames(const Model& model) {
  std::vector<std::string> names;
  for (const ModelSlot& slot : model.slots) names.push_back(slot.name);
  return names;
}

/// Whether the tangent frame at every corner of every triangle with UVs lies along +u and +v on the surface.
void expectTangentsAlongUvs(const Model& model, double least) {
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return model.indices[i + k]; };
    const glm::dvec3 e1 = glm::dvec3(model.positions[at(1)]) - glm::dvec3(model.positions[at(0)]);
    const glm::dvec3 e2 = glm::dvec3(model.positions[at(2)]) - glm::dvec3(model.positions[at(0)]);
    const glm::dvec2 u1 = glm::dvec2(model.uvs[at(1)]) - glm::dvec2(model.uvs[at(0)]);
    const glm::dvec2 u2 = glm::dvec2(model.uvs[at(2)]) - glm::dvec2(model.uvs[at(0)]);
    const double area = u1.x * u2.y - u2.x * u1.y;
    if (std::abs(area) < 1e-12) continue;
    const glm::dvec3 alongU = glm::normalize((u2.y * e1 - u1.y * e2) / area);
    const glm::dvec3 alongV = glm::normalize((u1.x * e2 - u2.x * e1) / area);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 tangent(model.tangents[at(k)].x, model.tangents[at(k)].y, model.tangents[at(k)].z);
      const glm::dvec3 bitangent =
          static_cast<double>(model.tangents[at(k)].w) * glm::cross(glm::dvec3(model.normals[at(k)]), tangent);
      ASSERT_GT(glm::dot(tangent, alongU), least) << "triangle " << i / 3;
      ASSERT_GT(glm::dot(bitangent, alongV), least) << "triangle " << i / 3;
    }
  }
}

TEST(ObjModel, HasOneSlotAMaterialInTheFilesOrder) {
  const Folder folder;
  folder.put("cube.mtl", "newmtl front\nKd 0.5 0.25 0.125\nNs 100\nnewmtl unused\nnewmtl rest\nKd 1 1 1\nd 0.5\n");
  const Model model = load(folder.put("cube.obj", objCube("cube.mtl")));
  EXPECT_THAT(slotNames(model), ElementsAre("front", "rest"));
  ASSERT_EQ(model.parts.size(), 2U);
  EXPECT_EQ(model.parts[0].indexCount, 6U);
  EXPECT_EQ(model.parts[1].indexCount, 30U);
  EXPECT_THAT(model.warnings, IsEmpty());

  const MaterialParameters& front = model.slots[0].imported.parameters;
  EXPECT_EQ(model.slots[0].imported.model, ShadingModel::MetallicRoughness);
  EXPECT_EQ(front.baseAlbedo.rgb, glm::vec3(0.5F, 0.25F, 0.125F));
  EXPECT_NEAR(front.specularPerceptualRoughness, std::pow(2.0 / 102.0, 0.25), 1e-5);
  const MaterialParameters& rest = model.slots[1].imported.parameters;
  EXPECT_EQ(rest.metallicRoughnessAlphaMode, AlphaMode::Blend);
  EXPECT_FLOAT_EQ(rest.metallicRoughnessOpacity, 0.5F);
}

TEST(ObjModel, MissingNormalsAreSmoothAcrossGroupsMaterialsAndSeams) {
  const Folder folder;
  const Model sphere = load(folder.put("sphere.obj", objSphere()));
  EXPECT_THAT(slotNames(sphere), ElementsAre("skin"));
  for (std::size_t i = 0; i < sphere.positions.size(); ++i)
    ASSERT_GT(glm::dot(glm::normalize(sphere.positions[i]), sphere.normals[i]), 0.999F) << "vertex " << i;
  // 12 bands of 24: one vertex a corner of the grid, the two rows of the poles one a triangle.
  EXPECT_EQ(sphere.positions.size(), 11U * 25U + 24U + 24U);
  EXPECT_EQ(sphere.indices.size() / 3, 24U * 22U);
}

TEST(ObjModel, MissingNormalsKeepSharpEdges) {
  const Folder folder;
  const Model cube = load(folder.put("cube.obj", objCube()));
  EXPECT_EQ(cube.positions.size(), 24U) << "four corners a face";
  for (std::size_t i = 0; i < cube.indices.size(); i += 3) {
    const auto corner = [&](std::size_t c) { return cube.positions[cube.indices[i + c]]; };
    const glm::vec3 face = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_GT(glm::dot(face, cube.normals[cube.indices[i + c]]), 0.9999F) << "triangle " << i / 3;
  }

  // A cylinder of 12 sides: round about its axis, flat at its ends.
  std::string obj;
  constexpr int kSides = 12;
  for (const float z : {-1.0F, 1.0F})
    for (int k = 0; k < kSides; ++k) {
      const double phi = 2.0 * std::numbers::pi * k / kSides;
      obj += fmt::format("v {} {} {}\n", std::cos(phi), std::sin(phi), z);
    }
  std::string lower = "f", upper = "f";
  for (int k = 0; k < kSides; ++k) {
    obj += fmt::format("f {} {} {} {}\n", k + 1, (k + 1) % kSides + 1, kSides + (k + 1) % kSides + 1, kSides + k + 1);
    lower += fmt::format(" {}", kSides - k);
    upper += fmt::format(" {}", kSides + k + 1);
  }
  const Model cylinder = load(folder.put("cylinder.obj", obj + lower + "\n" + upper + "\n"));
  EXPECT_EQ(cylinder.positions.size(), 4U * kSides);
  for (std::size_t i = 0; i < cylinder.positions.size(); ++i) {
    const glm::vec3 p = cylinder.positions[i], n = cylinder.normals[i];
    const float round = glm::dot(n, glm::vec3(p.x, p.y, 0.0F)), flat = n.z * p.z;
    EXPECT_GT(std::max(round, flat), 0.999F) << "vertex " << i;
  }
}

TEST(ObjModel, SurvivesANulAtItsEndAndMixedLineEnds) {
  const Folder folder;
  const std::string plain = objSphere();
  const Model clean = load(folder.put("clean.obj", plain));
  const Model model = load(folder.put("nul.obj", plain + '\0'));
  EXPECT_EQ(model.indices, clean.indices);
  EXPECT_EQ(model.positions, clean.positions);
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(ObjModel, CutsConcaveQuadsAndPolygonsInsideThem) {
  const Folder folder;
  // A dart whose second corner is the dent, and an L of six corners.
  const Model dart = load(folder.put("dart.obj", "v 0 0 0\nv 0.1 0.1 0\nv 0.4 0 0\nv 0.1 0.4 0\nf 1 2 3 4\n"));
  const auto area = [](const Model& m) {
    double sum = 0.0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
      const glm::vec3 a = m.positions[m.indices[i]];
      sum +=
          0.5 * static_cast<double>(glm::cross(m.positions[m.indices[i + 1]] - a, m.positions[m.indices[i + 2]] - a).z);
    }
    return sum;
  };
  EXPECT_EQ(dart.indices.size(), 6U);
  EXPECT_NEAR(area(dart), 0.06, 1e-6);
  for (std::size_t i = 0; i < dart.indices.size(); i += 3) {
    const glm::vec3 a = dart.positions[dart.indices[i]];
    EXPECT_GT(glm::cross(dart.positions[dart.indices[i + 1]] - a, dart.positions[dart.indices[i + 2]] - a).z, 0.0F);
  }
  const Model ell = load(
      folder.put("l.obj", "v 0 0 0\nv 0.2 0 0\nv 0.2 0.1 0\nv 0.1 0.1 0\nv 0.1 0.3 0\nv 0 0.3 0\nf 1 2 3 4 5 6\n"));
  EXPECT_EQ(ell.indices.size(), 12U);
  EXPECT_NEAR(area(ell), 0.04, 1e-6);
}

TEST(ObjModel, FindsTexturesWhateverTheSlashAndTheCase) {
  const Folder folder;
  folder.put("Maps/Face_COL.png", pngBytes());
  folder.put("Maps/face_normal.png", pngBytes());
  folder.put(
      "cube.mtl",
      "newmtl front\nmap_Kd maps\\face_col.PNG\nmap_Bump C:\\work\\face_normal.png\nnewmtl rest\nmap_Kd nowhere.png\n");
  const Model model = load(folder.put("cube.obj", objCube("cube.mtl")));
  EXPECT_EQ(model.slots[0].imported.texture(TextureSlot::Albedo).path, (folder / "Maps/Face_COL.png").string());
  EXPECT_EQ(model.slots[0].imported.texture(TextureSlot::Normal).path, (folder / "Maps/face_normal.png").string());
  EXPECT_FALSE(model.slots[1].imported.texture(TextureSlot::Albedo).present());
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_THAT(model.warnings[0], HasSubstr("nowhere.png"));
}

TEST(ObjModel, SizeTellsTheUnit) {
  const Folder folder;
  const auto scaled = [&](double size) {
    return load(folder.put("t.obj", fmt::format("v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nf 1 2 3\n", size)));
  };
  EXPECT_FLOAT_EQ(scaled(0.3).millimetresPerUnit, 1000.0F);
  EXPECT_FLOAT_EQ(scaled(2.5).millimetresPerUnit, 100.0F);
  EXPECT_FLOAT_EQ(scaled(30).millimetresPerUnit, 10.0F);
  EXPECT_FLOAT_EQ(scaled(12).millimetresPerUnit, 25.4F);
  EXPECT_FLOAT_EQ(scaled(300).millimetresPerUnit, 1.0F);
  EXPECT_FLOAT_EQ(scaled(0.05).millimetresPerUnit, 1000.0F);  // an eyeball
  EXPECT_FLOAT_EQ(scaled(1.0).millimetresPerUnit, 300.0F);    // made to fit a unit cube
  EXPECT_THAT(scaled(30).unitSource, HasSubstr("centimetres"));
}

TEST(ObjModel, WithoutUvsOrNormalsStillShows) {
  const Folder folder;
  const Model model = load(folder.put("bare.obj", "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nf 1 2 3\n"));
  EXPECT_FALSE(model.hasUvs);
  EXPECT_EQ(model.normals[0], glm::vec3(0, 0, 1));
  EXPECT_THAT(slotNames(model), ElementsAre("default"));
}

TEST(ObjModel, UvsWithoutAreaGetAnyFrame) {
  const Folder folder;
  const Model model = load(folder.put("flat.obj", "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nvt 0.5 0.5\nf 1/1 2/1 3/1\n"));
  EXPECT_TRUE(model.hasUvs);
}

TEST(Tangents, LieAlongTheUvs) {
  const Folder folder;
  expectTangentsAlongUvs(load(folder.put("sphere.obj", objSphere(24, 48))), 0.9);
}

TEST(Tangents, SplitVerticesThatMirroredUvsShare) {
  const Folder folder;
  // Two quads side by side; the right one has the left one's UVs, mirrored at the edge they share.
  const Model model = load(folder.put("mirror.obj",
                                      "v -0.2 0 0\nv 0 0 0\nv 0 0.2 0\nv -0.2 0.2 0\nv 0.2 0 0\nv 0.2 0.2 0\n"
                                      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                      "f 1/1 2/2 3/3 4/4\nf 2/2 5/1 6/4 3/3\n"));
  EXPECT_EQ(model.positions.size(), 8U);
  expectTangentsAlongUvs(model, 0.999);
}

TEST(GltfModel, TurnsVRoundAndKeepsTheTangentConvention) {
  const Folder folder;
  for (const bool binary : {true, false}) {
    const Gltf gltf = gltfQuad();
    const Model model = load(binary ? folder.put("quad.glb", gltf.glb()) : folder.put("quad.gltf", gltf.text()));
    ASSERT_EQ(model.positions.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(model.uvs[i].x, (model.positions[i].x + 0.1F) * 5.0F, 1e-6F);
      EXPECT_NEAR(model.uvs[i].y, (model.positions[i].y + 0.1F) * 5.0F, 1e-6F);
      EXPECT_NEAR(model.tangents[i].x, 1.0F, 1e-6F);
      EXPECT_EQ(model.tangents[i].w, 1.0F);
    }
    EXPECT_FLOAT_EQ(model.millimetresPerUnit, 1000.0F);
    EXPECT_FLOAT_EQ(model.slots[0].imported.parameters.baseMetallic, 0.25F);
    EXPECT_FLOAT_EQ(model.slots[0].imported.parameters.specularPerceptualRoughness, 0.75F);
  }
}

TEST(GltfModel, KeepsTheFilesOwnTangents) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  const std::size_t tangents = gltf.floats({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, "VEC4");
  gltf.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = tangents;
  const Model model = load(folder.put("t.glb", gltf.glb()));
  EXPECT_EQ(model.tangents[0], glm::vec4(0, 1, 0, -1));
}

TEST(GltfModel, NodesMoveTurnAndMirror) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  gltf.json["nodes"] = {{{"children", {1}}, {"translation", {1, 0, 0}}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  const Model model = load(folder.put("m.glb", gltf.glb()));
  EXPECT_NEAR(model.bounds.centre().x, 1.0F, 1e-6F);
  // Mirrored, and still counter-clockwise seen from where its normal points.
  for (std::size_t i = 0; i < model.indices.size(); i += 3) {
    const glm::vec3 a = model.positions[model.indices[i]];
    const glm::vec3 cross =
        glm::cross(model.positions[model.indices[i + 1]] - a, model.positions[model.indices[i + 2]] - a);
    EXPECT_GT(glm::dot(cross, model.normals[model.indices[i]]), 0.0F);
  }
  expectTangentsAlongUvs(model, 0.999);
}

TEST(GltfModel, PacksMetallicRoughnessAndOcclusion) {
  const Folder folder;
  folder.put("orm.png", pngBytes());
  Gltf gltf = gltfQuad();
  gltf.json["images"] = {{{"uri", "orm.png"}}};
  gltf.json["textures"] = {{{"source", 0}}};
  nlohmann::json& material = gltf.json["materials"][0];
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  material["occlusionTexture"] = {{"index", 0}, {"strength", 0.5}};
  material["normalTexture"] = {{"index", 0}, {"scale", 0.75}};
  material["emissiveFactor"] = {1.0, 0.5, 0.0};
  material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 8.0;
  material["alphaMode"] = "MASK";
  material["alphaCutoff"] = 0.3;
  material["doubleSided"] = true;
  const Model model = load(folder.put("pbr.glb", gltf.glb()));
  const Material& imported = model.slots[0].imported;
  EXPECT_EQ(imported.texture(TextureSlot::Metallic).channel, TextureChannel::B);
  EXPECT_EQ(imported.texture(TextureSlot::Roughness).channel, TextureChannel::G);
  EXPECT_EQ(imported.texture(TextureSlot::Occlusion).channel, TextureChannel::R);
  EXPECT_EQ(imported.texture(TextureSlot::Roughness).path, (folder / "orm.png").string());
  EXPECT_FLOAT_EQ(imported.parameters.occlusionStrength, 0.5F);
  EXPECT_FLOAT_EQ(imported.parameters.surfaceNormalStrength, 0.75F);
  EXPECT_FLOAT_EQ(imported.parameters.metallicRoughnessEmissiveStrength, 8.0F);
  EXPECT_EQ(imported.parameters.metallicRoughnessEmissive.rgb, glm::vec3(1.0F, 0.5F, 0.0F));
  EXPECT_EQ(imported.parameters.metallicRoughnessAlphaMode, AlphaMode::Mask);
  EXPECT_FLOAT_EQ(imported.parameters.metallicRoughnessAlphaCutoff, 0.3F);
  EXPECT_TRUE(imported.parameters.metallicRoughnessDoubleSided);
}

TEST(GltfModel, BringsEmbeddedImages) {
  const Folder folder;
  const std::string png = pngBytes(8, 2);
  Gltf gltf = gltfQuad();
  gltf.json["images"] = {{{"bufferView", gltf.view(png)}, {"mimeType", "image/png"}}};
  gltf.json["textures"] = {{{"source", 0}}};
  gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  const Model model = load(folder.put("e.glb", gltf.glb()));
  EXPECT_EQ(model.slots[0].imported.texture(TextureSlot::Albedo).path, "embedded:0");
  ASSERT_EQ(model.embedded.size(), 1U);
  EXPECT_EQ(model.embedded[0].bytes.size(), png.size());
  Warnings warnings;
  const auto image = module().loadImage(model.embedded[0].bytes, model.embedded[0].name, {}, warnings);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 8);
}

TEST(GltfModel, ReadsQuantisedAndSparseData) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  // UVs as normalised 16-bit integers.
  const std::size_t uv = gltf.shorts({0, 65535, 65535, 65535, 65535, 0, 0, 0}, "VEC2");
  gltf.json["accessors"][uv]["normalized"] = true;
  gltf.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uv;
  // The third corner moved by a sparse accessor.
  const std::uint16_t which = 2;
  const float moved[3] = {0.3F, 0.3F, 0.0F};
  const std::size_t indices = gltf.view({reinterpret_cast<const char*>(&which), 2});
  const std::size_t values = gltf.view({reinterpret_cast<const char*>(moved), sizeof(moved)});
  gltf.json["accessors"][0]["sparse"] = {{"count", 1},
                                         {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                         {"values", {{"bufferView", values}}}};
  const Model model = load(folder.put("q.glb", gltf.glb()));
  EXPECT_NEAR(model.bounds.max.x, 0.3F, 1e-6F);
  EXPECT_NEAR(model.uvs[2].x, 1.0F, 1e-6F);
  EXPECT_NEAR(model.uvs[2].y, 1.0F, 1e-6F);
}

TEST(GltfModel, SkinsStandInTheirPose) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  const std::size_t joints = gltf.shorts({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  const std::size_t weights = gltf.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const std::size_t bind = gltf.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4");
  nlohmann::json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = joints;
  attributes["WEIGHTS_0"] = weights;
  gltf.json["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", bind}}};
  // The mesh's own node is moved away, which a skin ignores; the joint is raised by 2.
  gltf.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}}, {{"translation", {0, 2, 0}}}};
  gltf.json["scenes"] = {{{"nodes", {0, 1}}}};
  const Model model = load(folder.put("s.glb", gltf.glb()));
  EXPECT_NEAR(model.bounds.centre().x, 0.0F, 1e-5F);
  EXPECT_NEAR(model.bounds.centre().y, 2.0F, 1e-5F);
}

TEST(GltfModel, NamesRepeatedAndMissing) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  const nlohmann::json primitive = gltf.json["meshes"][0]["primitives"][0];
  gltf.json["materials"] = {{{"name", "skin"}}, {{"name", "skin"}}, nlohmann::json::object(), {{"name", "unused"}}};
  nlohmann::json& primitives = gltf.json["meshes"][0]["primitives"];
  for (const int material : {1, 2}) {
    primitives.push_back(primitive);
    primitives.back()["material"] = material;
  }
  EXPECT_THAT(slotNames(load(folder.put("n.glb", gltf.glb()))), ElementsAre("skin", "skin.2", "default"));
}

TEST(PlyModel, ReadsTextAndBinary) {
  const Folder folder;
  for (const bool binary : {false, true}) {
    const Model model = load(folder.put("t.ply", plyTetrahedron(binary)));
    EXPECT_EQ(model.positions.size(), 12U) << "its edges are sharp";
    EXPECT_EQ(model.indices.size(), 12U);
    EXPECT_FLOAT_EQ(model.millimetresPerUnit, 1000.0F);
  }
}

TEST(StlModel, IsSmoothedBecauseItsNormalsAreTheFacets) {
  const Folder folder;
  for (const bool binary : {false, true}) {
    const Model model = load(folder.put("t.stl", stlOctahedron(binary)));
    EXPECT_EQ(model.positions.size(), 6U);
    EXPECT_EQ(model.indices.size(), 24U);
  }
}

TEST(ColladaModel, KeepsItsOwnUnitAndStandsUp) {
  const Folder folder;
  const Model model = load(folder.put("t.dae", daeTriangle(0.01, "Z_UP")));
  EXPECT_FLOAT_EQ(model.millimetresPerUnit, 10.0F);
  EXPECT_NEAR(model.bounds.max.x, 10.0F, 1e-4F);
  EXPECT_NEAR(model.bounds.max.y, 30.0F, 1e-4F);
  EXPECT_THAT(slotNames(model), ElementsAre("red"));
  EXPECT_EQ(model.slots[0].imported.parameters.baseAlbedo.rgb, glm::vec3(1, 0, 0));
  EXPECT_NEAR(load(folder.put("y.dae", daeTriangle(1.0, "Y_UP"))).bounds.max.z, 30.0F, 1e-4F);
}

TEST(FbxModel, KeepsItsOwnUnitAndStandsUp) {
  const Folder folder;
  const Model model = load(folder.put("t.fbx", fbxTriangle(100.0, true)));
  EXPECT_FLOAT_EQ(model.millimetresPerUnit, 1000.0F);
  EXPECT_NEAR(model.bounds.max.y, 30.0F, 1e-4F);
  EXPECT_THAT(slotNames(model), ElementsAre("red"));
  const Model upright = load(folder.put("y.fbx", fbxTriangle(1.0, false)));
  EXPECT_FLOAT_EQ(upright.millimetresPerUnit, 10.0F);
  EXPECT_NEAR(upright.bounds.max.z, 30.0F, 1e-4F);
}

}  // namespace
}  // namespace dermis
