// Bad models: one sentence each, and never a crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "fixtures.h"

namespace dermis {
namespace {

using namespace fixtures;
using testing::AllOf;
using testing::HasSubstr;

/// The sentence a file is refused with; empty where it loads.
std::string refusal(const std::filesystem::path& path) {
  const auto model = module().loadModel(path);
  if (model) return {};
  EXPECT_EQ(model.error().kind, Error::Kind::Input) << model.error().message;
  EXPECT_TRUE(isOneSentence(model.error().message, path.filename().string())) << model.error().message;
  return model.error().message;
}

TEST(BadModel, MissingEmptyAndFolder) {
  const Folder folder;
  EXPECT_NE(refusal(folder / "nowhere.obj"), "");
  EXPECT_THAT(refusal(folder.put("empty.obj", "")), HasSubstr("empty"));
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_NE(refusal(folder / "folder.obj"), "");
}

TEST(BadModel, NotFiniteVerticesAreNamed) {
  const Folder folder;
  EXPECT_THAT(refusal(folder.put("nan.obj", "o nose\nv 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")),
              AllOf(HasSubstr("nose"), HasSubstr("vertex 1")));
  Gltf gltf = gltfQuad();
  const float bad = std::numeric_limits<float>::quiet_NaN();
  gltf.binary.replace(12, 4, reinterpret_cast<const char*>(&bad), 4);
  EXPECT_THAT(refusal(folder.put("nan.glb", gltf.glb())), HasSubstr("vertex 1"));
  const float huge = std::numeric_limits<float>::infinity();
  gltf.binary.replace(12, 4, reinterpret_cast<const char*>(&huge), 4);
  EXPECT_THAT(refusal(folder.put("inf.glb", gltf.glb())), HasSubstr("vertex 1"));
}

TEST(BadModel, NotFiniteNormalsAndUvsAreRepaired) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  const float bad = std::numeric_limits<float>::quiet_NaN();
  gltf.binary.replace(48, 4, reinterpret_cast<const char*>(&bad), 4);      // a normal
  gltf.binary.replace(96 + 8, 4, reinterpret_cast<const char*>(&bad), 4);  // a UV
  const auto model = module().loadModel(folder.put("n.glb", gltf.glb()));
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(brokenPromise(*model), "");
  EXPECT_EQ(model->warnings.size(), 2U);
}

TEST(BadModel, IndicesOutOfRange) {
  const Folder folder;
  Gltf gltf = gltfQuad();
  gltf.json["accessors"].push_back(gltf.json["accessors"][3]);
  gltf.json["meshes"][0]["primitives"][0]["indices"] = gltf.shorts({0, 1, 9});
  EXPECT_THAT(refusal(folder.put("i.glb", gltf.glb())), HasSubstr("vertex 9"));
  EXPECT_NE(refusal(folder.put("i.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 77\n")), "");
  std::string ply = plyTetrahedron(false);
  ply.replace(ply.rfind("3 1 2 3"), 7, "3 1 2 9");
  EXPECT_NE(refusal(folder.put("i.ply", ply)), "");
}

TEST(BadModel, NothingToShow) {
  const Folder folder;
  EXPECT_NE(refusal(folder.put("points.obj", "v 0 0 0\nv 1 0 0\n")), "");
  EXPECT_THAT(refusal(folder.put("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")), HasSubstr("area"));
  EXPECT_NE(refusal(folder.put("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")), "");
  Gltf gltf = gltfQuad();
  gltf.json.erase("meshes");
  gltf.json["nodes"][0].erase("mesh");
  EXPECT_NE(refusal(folder.put("none.glb", gltf.glb())), "");
}

TEST(BadModel, TrianglesWithoutAreaAreLeftOut) {
  const Folder folder;
  const auto model = module().loadModel(folder.put("some.obj", "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nf 1 2 3\nf 1 1 2\n"));
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->indices.size(), 3U);
  EXPECT_EQ(model->warnings.size(), 1U);
}

TEST(BadModel, GltfThatLies) {
  const Folder folder;
  const auto refused = [&](const std::function<void(Gltf&)>& spoil) {
    Gltf gltf = gltfQuad();
    spoil(gltf);
    return refusal(folder.put("lie.glb", gltf.glb()));
  };
  EXPECT_THAT(refused([](Gltf& g) { g.json["accessors"][0]["count"] = 4000000000U; }), HasSubstr("/accessors/0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["accessors"][0]["count"] = 5; }), HasSubstr("/accessors/0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["accessors"][0]["byteOffset"] = 40; }), HasSubstr("/accessors/0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["bufferViews"][0]["byteLength"] = 100000; }), HasSubstr("/bufferViews/0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["bufferViews"][0]["byteOffset"] = -4; }), HasSubstr("/bufferViews/0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["nodes"][0]["mesh"] = 7; }), HasSubstr("/nodes/0/mesh"));
  EXPECT_THAT(refused([](Gltf& g) {
                g.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
              }),
              HasSubstr("/nodes/"));
  EXPECT_THAT(refused([](Gltf& g) {
                g.json["materials"][0]["normalTexture"] = {{"index", 3}};
              }),
              HasSubstr("/materials/0/normalTexture"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["asset"]["version"] = "1.0"; }), HasSubstr("1.0"));
  EXPECT_THAT(refused([](Gltf& g) { g.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              HasSubstr("draco"));
  EXPECT_THAT(refusal(folder.put("lie.glb", "v 0 0 0\n")), HasSubstr("GLB"));
  EXPECT_THAT(refusal(folder.put("lie.gltf", "{\"asset\":")), HasSubstr("byte"));
}

TEST(BadModel, DeepNestingIsRefusedBeforeARecursiveParserSeesIt) {
  const Folder folder;
  EXPECT_NE(refusal(folder.put("deep.gltf", std::string(200000, '['))), "");
  std::string xml;
  for (int i = 0; i < 100000; ++i) xml += "<node>";
  EXPECT_THAT(refusal(folder.put("deep.dae", "<?xml version=\"1.0\"?><COLLADA>" + xml)), HasSubstr("deep"));
  EXPECT_THAT(refusal(folder.put(
                  "deep.fbx", "; FBX 7.4.0\n" +
                                  [] {
                                    std::string text;
                                    for (int i = 0; i < 100000; ++i) text += "A: {";
                                    return text;
                                  }())),
              HasSubstr("deep"));
}

TEST(BadModel, PlyThatPromisesTooMuch) {
  const Folder folder;
  std::string ply = plyTetrahedron(true);
  ply.replace(ply.find("vertex 4"), 8, "vertex 4000000000");
  EXPECT_THAT(refusal(folder.put("p.ply", ply)), HasSubstr("4000000000"));
}

TEST(BadModel, WrongExtension) {
  const Folder folder;
  for (const char* name : {"png.obj", "png.glb", "png.ply", "png.stl", "png.fbx", "png.dae", "png.xyz", "png"})
    EXPECT_NE(refusal(folder.put(name, pngBytes(32, 32))), "") << name;
}

TEST(BadModel, CutOffAnywhereIsOneSentenceOrAWholeModel) {
  const Folder folder;
  const auto cut = [&](const std::string& name, const std::string& whole) {
    for (std::size_t step = 0; step < 40; ++step) {
      const auto path = folder.put(name, whole.substr(0, whole.size() * step / 40));
      const auto model = module().loadModel(path);
      if (model)
        EXPECT_EQ(brokenPromise(*model), "") << name << " at " << step;
      else
        EXPECT_TRUE(isOneSentence(model.error().message, name)) << model.error().message;
    }
  };
  cut("c.obj", objCube());
  cut("c.glb", gltfQuad().glb());
  cut("c.gltf", gltfQuad().text());
  cut("c.ply", plyTetrahedron(true));
  cut("t.ply", plyTetrahedron(false));
  cut("c.stl", stlTetrahedron(true));
  cut("c.dae", daeTriangle(1.0, "Y_UP"));
  cut("c.fbx", fbxTriangle(1.0, false));
}

TEST(Model, StopsWhenAsked) {
  const Folder folder;
  std::stop_source stop;
  stop.request_stop();
  const auto model = module().loadModel(folder.put("s.obj", objSphere()), stop.get_token());
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, Error::Kind::Cancelled);
}

TEST(Model, FilesOutsideItsFolderAreNotOpened) {
  const Folder folder;
  folder.put("secret.bin", std::string(1000, 'x'));
  Gltf gltf = gltfQuad();
  nlohmann::json document = gltf.json;
  document["buffers"] = {{{"byteLength", gltf.binary.size()}, {"uri", "../secret.bin"}}};
  EXPECT_THAT(refusal(folder.put("inside/o.gltf", document.dump())), HasSubstr("secret.bin"));
}

}  // namespace
}  // namespace dermis
