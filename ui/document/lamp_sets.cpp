#include "ui/document/lamp_sets.h"

#include <QCoreApplication>
#include <array>

#include "core/light_rig/light_rig.h"
#include "ui/document/document.h"

namespace dermis {
namespace {

/// One lamp: where it stands as azimuth (0 is where a face looks, 90 is +X) and elevation, at a distance and of a size
/// in radii of the model, and what it sends to the model's middle beside the set's key.
struct Lamp {
  const char* set;
  const char* name;
  LightType type;
  float azimuth, elevation, distance;
  glm::vec2 size;
  float share;
  glm::vec3 color;
};

constexpr glm::vec3 kNeutral{1.0F}, kWarm{1.0F, 0.86F, 0.72F}, kCool{0.78F, 0.88F, 1.0F};

// After the set-ups of portrait photography: Hunter, Biver & Fuqua, "Light: Science & Magic", chapter 8.
constexpr std::array<Lamp, 12> kLamps = {{
    {"three-point", QT_TRANSLATE_NOOP("lamps", "Key"), LightType::Rect, -40, 30, 3.0F, {1.2F, 1.2F}, 1.0F, kWarm},
    {"three-point", QT_TRANSLATE_NOOP("lamps", "Fill"), LightType::Rect, 45, 8, 3.5F, {2.0F, 2.0F}, 0.3F, kCool},
    {"three-point", QT_TRANSLATE_NOOP("lamps", "Rim"), LightType::Rect, 150, 35, 3.0F, {0.5F, 1.5F}, 1.2F, kNeutral},
    {"rembrandt", QT_TRANSLATE_NOOP("lamps", "Key"), LightType::Rect, -48, 42, 2.6F, {0.7F, 0.7F}, 1.0F, kWarm},
    {"rembrandt", QT_TRANSLATE_NOOP("lamps", "Fill"), LightType::Rect, 60, 5, 3.5F, {2.0F, 2.0F}, 0.1F, kNeutral},
    {"butterfly", QT_TRANSLATE_NOOP("lamps", "Key"), LightType::Rect, 0, 45, 2.6F, {0.9F, 0.9F}, 1.0F, kNeutral},
    {"butterfly", QT_TRANSLATE_NOOP("lamps", "Fill"), LightType::Rect, 0, -35, 2.6F, {1.6F, 0.8F}, 0.25F, kNeutral},
    {"split", QT_TRANSLATE_NOOP("lamps", "Key"), LightType::Rect, -90, 5, 2.6F, {0.8F, 1.6F}, 1.0F, kNeutral},
    {"rim-pair", QT_TRANSLATE_NOOP("lamps", "Left rim"), LightType::Rect, -130, 15, 2.8F, {0.5F, 2.0F}, 1.2F, kCool},
    {"rim-pair", QT_TRANSLATE_NOOP("lamps", "Right rim"), LightType::Rect, 130, 15, 2.8F, {0.5F, 2.0F}, 1.2F, kWarm},
    {"ears",
     QT_TRANSLATE_NOOP("lamps", "Behind the ear"),
     LightType::Sphere,
     140,
     10,
     2.0F,
     {0.12F, 0.12F},
     2.0F,
     kWarm},
    {"ears", QT_TRANSLATE_NOOP("lamps", "Front"), LightType::Rect, -25, 20, 3.0F, {1.5F, 1.5F}, 0.4F, kNeutral},
}};

/// What the key sends to the middle of the model: as bright as the built-in environments.
constexpr float kKeyIrradiance = 2.5F;

}  // namespace

const std::vector<LampSet>& lampSets() {
  static const std::vector<LampSet> kSets = {
      {"three-point", QT_TRANSLATE_NOOP("lamps", "Three-point"),
       QT_TRANSLATE_NOOP("lamps", "A warm key, a cool fill, a rim from behind")},
      {"rembrandt", QT_TRANSLATE_NOOP("lamps", "Rembrandt"),
       QT_TRANSLATE_NOOP("lamps", "A high key from the side that leaves a triangle of light on the far cheek")},
      {"butterfly", QT_TRANSLATE_NOOP("lamps", "Butterfly"),
       QT_TRANSLATE_NOOP("lamps", "A high key from the front, a weak fill from below")},
      {"split", QT_TRANSLATE_NOOP("lamps", "Split"), QT_TRANSLATE_NOOP("lamps", "One key from the side: half a face")},
      {"rim-pair", QT_TRANSLATE_NOOP("lamps", "Rim pair"),
       QT_TRANSLATE_NOOP("lamps", "Two strips from behind, one cool and one warm")},
      {"ears", QT_TRANSLATE_NOOP("lamps", "Through the ear"),
       QT_TRANSLATE_NOOP("lamps", "A small lamp behind an ear, to judge transmission by")}};
  return kSets;
}

std::vector<Light> lampsOf(const QString& id, const Bounds& bounds, float millimetresPerUnit) {
  std::vector<Light> lights;
  const float radius = bounds.radius();
  for (const Lamp& lamp : kLamps) {
    if (id != QLatin1String(lamp.set)) continue;
    Light light;
    light.name = QCoreApplication::translate("lamps", lamp.name).toStdString();
    light.type = lamp.type;
    const glm::vec3 towards = rigDirection(lamp.azimuth, lamp.elevation);
    const float distance = lamp.distance * radius;
    light.position = bounds.centre() + distance * towards;
    light.direction = -towards;
    light.color = lamp.color;
    light.intensity = kKeyIrradiance * lamp.share * distance * distance;
    light.sizeMm = lamp.size * radius * millimetresPerUnit;
    light.radiusMm = lamp.size.x * radius * millimetresPerUnit;
    lights.push_back(std::move(light));
  }
  return lights;
}

void useLampSet(Document& document, const QString& id) {
  if (!document.isReady()) return;
  const std::vector<Light> lamps = lampsOf(id, document.model()->bounds, document.millimetresPerUnit());
  if (lamps.empty()) return;
  document.undoStack().beginMacro(QCoreApplication::translate("lamps", "Set of lamps"));
  while (!document.scene().lights.empty()) document.removeLight(document.scene().lights.size() - 1);
  for (const Light& lamp : lamps) document.addLight(lamp);
  document.undoStack().endMacro();
}

}  // namespace dermis
