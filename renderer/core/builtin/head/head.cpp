#include "core/builtin/head/head.h"

#include <array>
#include <mutex>

#include "core/builtin/head/asymmetry.h"
#include "core/builtin/head/eyes.h"
#include "core/builtin/head/hairs.h"
#include "core/builtin/head/head_cache.h"
#include "core/builtin/head/head_look.h"
#include "core/builtin/head/head_mesh.h"
#include "core/builtin/head/refine.h"
#include "core/builtin/head/tear_line.h"
#include "core/scene/primitives.h"
#include "core/scene/tangents.h"

namespace dermis {
namespace {

using namespace sculpt;

constexpr float kMillimetresPerMetre = 1000.0F, kMetresPerMillimetre = 0.001F;

/// Texture coordinates of the two eyes side by side: the left eye in the left half.
void placeEyeUvs(Model& eye, bool left) {
  for (glm::vec2& uv : eye.uvs) uv = glm::vec2(left ? 0.25F : 0.75F, 0.5F) + 0.98F * 0.5F * (uv - 0.5F);
}

/// Both eyes' copies of a part of the left one, in metres.
Model bothEyes(const Model& part) {
  Model both;
  for (const bool left : {true, false}) {
    Model one = part;
    placeEyeUvs(one, left);
    const glm::vec3 symmetrical(left ? kEyeCentre.x : -kEyeCentre.x, kEyeCentre.y, kEyeCentre.z);
    appendModel(both, one, {glm::vec3(kMetresPerMillimetre), {}, kMetresPerMillimetre * asymmetrical(symmetrical)});
  }
  both.slots.resize(1);  // the second eye's has become the first's
  both.parts = {{0, 0, static_cast<std::uint32_t>(both.indices.size())}};
  return both;
}

/// What is clear before the eyes: corneas and tears.
Model lenses(const Sculpt& sculpt, int segments, int tearPieces) {
  Model lens = bothEyes(makeCornea(segments));
  Model tears = makeTearLine(sculpt, tearPieces);
  completeTangents(tears);
  appendModel(lens, tears, {glm::vec3(kMetresPerMillimetre), {}, glm::vec3(0.0F)});
  lens.slots.resize(1);
  lens.parts = {{0, 0, static_cast<std::uint32_t>(lens.indices.size())}};
  return lens;
}

Model faceModel(const AtlasMesh& mesh, const std::vector<glm::vec3>& normals) {
  Model model;
  model.slots.push_back({"face", Material{}});
  for (std::size_t v = 0; v < mesh.pointOf.size(); ++v) {
    const std::uint32_t point = mesh.pointOf[v];
    model.positions.push_back(kMetresPerMillimetre * asymmetrical(mesh.points[point]));
    model.normals.push_back(asymmetricalNormal(mesh.points[point], normals[point]));
    model.uvs.push_back(mesh.uvs[v]);
    model.bounds.grow(model.positions.back());
  }
  model.tangents.resize(model.positions.size(), glm::vec4(0.0F));
  for (const glm::uvec3& t : mesh.triangles) model.indices.insert(model.indices.end(), {t.x, t.y, t.z});
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  completeTangents(model);
  return model;
}

}  // namespace

void describeHead(Model& model) {
  const auto slots = headSlots();
  model.slots.assign(slots.begin(), slots.end());
  model.millimetresPerUnit = kMillimetresPerMetre;
  model.unitSource = "built in: metres";
}

std::optional<HeadLevel> headLevel(std::string_view name) {
  if (name == "head-low") return HeadLevel::Low;
  if (name == "head") return HeadLevel::Medium;
  if (name == "head-high") return HeadLevel::High;
  return std::nullopt;
}

Head makeHead(HeadLevel level) {
  const Sculpt sculpt;
  AtlasMesh mesh = coarseHeadMesh(sculpt);
  for (int i = 0; i < static_cast<int>(level); ++i) mesh = refined(mesh, sculpt);
  constexpr std::array<int, 3> kEyeSegments = {32, 64, 96};
  const auto index = static_cast<std::size_t>(level);
  const std::vector<glm::vec3> normals = settled(mesh, sculpt);
  Head head;
  head.millimetresPerUv = mesh.millimetresPerUv;
  for (const std::uint32_t point : mesh.pointOf) {
    head.rest.push_back(mesh.points[point]);
    head.restNormals.push_back(normals[point]);
  }
  Model model = faceModel(mesh, normals);
  appendModel(model, bothEyes(makeEyeball(kEyeSegments[index])));
  constexpr std::array<int, 3> kTearPieces = {24, 40, 64};
  appendModel(model, lenses(sculpt, kEyeSegments[index], kTearPieces[index]));
  constexpr std::array<int, 3> kHairPieces = {2, 3, 5};
  Model hairs = makeHairs(sculpt, kHairPieces[index]);
  completeTangents(hairs);
  appendModel(model, hairs, {glm::vec3(kMetresPerMillimetre), {}, glm::vec3(0.0F)});
  describeHead(model);
  head.model = std::move(model);
  return head;
}

std::shared_ptr<const Head> builtinHead(HeadLevel level) {
  static std::mutex mutex;
  static std::array<std::weak_ptr<const Head>, 3> remembered;
  const std::lock_guard lock(mutex);  // who comes second waits for the first's result
  std::weak_ptr<const Head>& slot = remembered[static_cast<std::size_t>(level)];
  if (std::shared_ptr<const Head> head = slot.lock()) return head;
  const std::filesystem::path file = headCacheFile(level);
  std::shared_ptr<const Head> head;
  if (std::optional<Head> cached = readHead(file)) {
    head = std::make_shared<const Head>(std::move(*cached));
  } else {
    head = std::make_shared<const Head>(makeHead(level));
    writeHead(file, *head);
  }
  slot = head;
  return head;
}

}  // namespace dermis
