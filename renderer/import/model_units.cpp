#include "import/model_units.h"

#include <assimp/metadata.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dermis::import {
namespace {

struct Unit {
  const char* name;
  float millimetres;
};
/// In the order of preference where two would make a head of it.
constexpr std::array kUnits = {Unit{"metres", 1000.0F}, Unit{"centimetres", 10.0F}, Unit{"millimetres", 1.0F},
                               Unit{"decimetres", 100.0F}, Unit{"inches", 25.4F}};

// A head is about 230 mm from crown to chin, a bust 300 to 450 mm.
constexpr float kSmallestHeadMm = 150.0F;
constexpr float kLargestBustMm = 600.0F;
constexpr float kTypicalBustMm = 300.0F;
/// Eyes and lenses of a head that comes in several files of metres.
constexpr float kSmallestPartMm = 15.0F;

std::string unitPhrase(float millimetres) {
  for (const Unit& unit : kUnits)
    if (std::abs(unit.millimetres - millimetres) < 1e-4F * unit.millimetres) return unit.name;
  return fmt::format("{} mm", millimetres);
}

void guess(Model& model) {
  const glm::vec3 size = model.bounds.max - model.bounds.min;
  const float extent = std::max({size.x, size.y, size.z});
  const auto take = [&](float millimetres, const std::string& why) {
    model.millimetresPerUnit = millimetres;
    model.unitSource = why;
  };
  if (!(extent > 0.0F)) return take(1000.0F, "guessed: metres");
  for (const Unit& unit : kUnits) {
    const float mm = extent * unit.millimetres;
    if (mm >= kSmallestHeadMm && mm <= kLargestBustMm)
      return take(unit.millimetres, fmt::format("guessed from the size: {} (largest extent {:.0f} mm)", unit.name, mm));
  }
  if (extent * 1000.0F >= kSmallestPartMm && extent * 1000.0F < kSmallestHeadMm)
    return take(1000.0F,
                fmt::format("guessed from the size: metres (a part, largest extent {:.0f} mm)", extent * 1000.0F));
  const float millimetres = std::clamp(kTypicalBustMm / extent, 1e-6F, 1e6F);
  take(millimetres,
       fmt::format("guessed: the largest extent, {:.4g} units, is taken for {:.0f} mm", extent, kTypicalBustMm));
}

/// The `meter` attribute of COLLADA's <asset><unit>, 1 where there is none (COLLADA 1.4.1, chapter 5, "unit").
float colladaMetres(std::string_view text) {
  const std::size_t unit = text.find("<unit");
  if (unit == std::string_view::npos) return 1.0F;
  const std::string_view element = text.substr(unit, text.find('>', unit) - unit);
  std::size_t at = element.find("meter=");
  if (at == std::string_view::npos || at + 8 > element.size()) return 1.0F;
  at += 7;  // the quotation mark too
  float metres = 1.0F;
  const auto [end, error] = std::from_chars(element.data() + at, element.data() + element.size(), metres);
  return error == std::errc() && std::isfinite(metres) && metres > 0.0F ? metres : 1.0F;
}

/// An axis of FBX's GlobalSettings as a unit vector; zero where it makes no sense.
glm::dvec3 fbxAxis(const aiMetadata& settings, const char* axis, const char* sign, int otherwise) {
  std::int32_t index = otherwise, direction = 1;
  static_cast<void>(settings.Get(axis, index));
  static_cast<void>(settings.Get(sign, direction));
  glm::dvec3 out(0.0);
  if (index >= 0 && index < 3) out[index] = direction < 0 ? -1.0 : 1.0;
  return out;
}

}  // namespace

glm::dmat4 correction(const aiScene& scene, const std::string& format, std::string_view text) {
  if (format == ".dae") return glm::dmat4(glm::dmat3(1.0 / static_cast<double>(colladaMetres(text))));
  if (format != ".fbx" || scene.mMetaData == nullptr) return glm::dmat4(1.0);
  const aiMetadata& settings = *scene.mMetaData;
  const glm::dmat3 axes(fbxAxis(settings, "CoordAxis", "CoordAxisSign", 0),
                        fbxAxis(settings, "UpAxis", "UpAxisSign", 1),
                        fbxAxis(settings, "FrontAxis", "FrontAxisSign", 2));
  // Three different axes, right-handed; anything else is a mistake of the writer, and turning by it would be another.
  return glm::determinant(axes) == 1.0 ? glm::dmat4(glm::transpose(axes)) : glm::dmat4(1.0);
}

void findUnit(Model& model, const aiScene& scene, const std::string& format, std::string_view text) {
  if (format == ".gltf" || format == ".glb" || format == ".vrm") {
    model.millimetresPerUnit = 1000.0F;
    model.unitSource = "glTF: metres";
    return;
  }
  if (format == ".dae") {
    model.millimetresPerUnit = 1000.0F * colladaMetres(text);
    model.unitSource = "COLLADA: " + unitPhrase(model.millimetresPerUnit);
    return;
  }
  // FBX counts in centimetres: UnitScaleFactor says how many.
  double centimetres = 0.0;
  float single = 0.0F;
  if (format == ".fbx" && scene.mMetaData != nullptr) {
    if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) && scene.mMetaData->Get("UnitScaleFactor", single))
      centimetres = static_cast<double>(single);
    if (std::isfinite(centimetres) && centimetres > 0.0) {
      model.millimetresPerUnit = static_cast<float>(centimetres * 10.0);
      model.unitSource = "FBX: " + unitPhrase(model.millimetresPerUnit);
      return;
    }
  }
  guess(model);
}

}  // namespace dermis::import
