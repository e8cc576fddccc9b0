// The rows of the Lights dock: what of a light can be set, and where it applies.
#include <algorithm>

#include "ui/docks/lights_panel.h"
#include "ui/docks/row_help.h"
#include "ui/document/document.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/rows/vector_editor.h"

namespace dermis {
namespace {

float floatOf(const ParameterValue& value) { return std::get<float>(value); }

}  // namespace

void LightsPanel::addEntry(GroupBox* group, const QString& label, const char* id, const QString& meaning,
                           ValueEditor* editor, Get get, Set set, Applies applies) {
  auto* row = new PropertyRow(tr("Light"), label, QStringLiteral("light.") + QLatin1String(id), editor, group);
  group->addRow(row);
  row->setDefault(get(Light{}));
  setRowHelp(*row, meaning);
  connect(row, &PropertyRow::edited, this,
          [this, label, set = std::move(set)](const ParameterValue& value, Gesture gesture) {
            const int index = selected();
            if (index < 0) return;
            Light light = m_document.scene().lights[static_cast<std::size_t>(index)];
            set(light, value);
            m_document.setLight(static_cast<std::size_t>(index), light, label, gesture);
          });
  m_entries.push_back({row, std::move(get), std::move(applies)});
}

void LightsPanel::buildRows() {
  GroupBox* basic = addGroup(tr("Light"), QStringLiteral("lights/light"));
  GroupBox* place = addGroup(tr("Place"), QStringLiteral("lights/place"));
  m_shape = addGroup(tr("Shape"), QStringLiteral("lights/shape"));
  GroupBox* motion = addGroup(tr("Motion"), QStringLiteral("lights/motion"));
  m_groups = {basic, place, m_shape, motion};
  const NumberRange open{-1e6, 1e6, -10, 10, {}};
  const auto isSpot = [](const Light& l) { return l.type == LightType::Spot; };

  QStringList types;
  for (int i = 0; i < 5; ++i) types << typeLabel(static_cast<LightType>(i));
  addEntry(
      basic, tr("Type"), "type",
      tr("How it shines: a point to all sides, a directional light from one side everywhere, a spot in a cone, a "
         "sphere and a rectangle from all of their surface"),
      new ChoiceEditor(types), [](const Light& l) { return EnumValue{static_cast<int>(l.type)}; },
      [](Light& l, const ParameterValue& v) { l.type = static_cast<LightType>(std::get<EnumValue>(v).index); });
  addEntry(
      basic, tr("Colour"), "color", tr("Colour of the light; its brightness multiplies the intensity"),
      new ColourEditor(false, NumberRange{}), [](const Light& l) { return Colour{l.color}; },
      [](Light& l, const ParameterValue& v) { l.color = std::get<Colour>(v).rgb; });
  addEntry(
      basic, tr("Intensity"), "intensity",
      tr("Radiant intensity of the light, which falls off with the square of the distance in scene units; of a "
         "directional light its irradiance"),
      new ScalarEditor(NumberRange{0, 1e6, 0, 50, {}}), [](const Light& l) { return l.intensity; },
      [](Light& l, const ParameterValue& v) { l.intensity = floatOf(v); });
  addEntry(
      basic, tr("Visible lamp"), "visible", tr("The lamp itself is seen in the picture and in reflections"),
      new SwitchEditor, [](const Light& l) { return ParameterValue(l.visible); },
      [](Light& l, const ParameterValue& v) { l.visible = std::get<bool>(v); });
  addEntry(
      basic, tr("Casts shadows"), "shadow", tr("Whether the model stops this light"), new SwitchEditor,
      [](const Light& l) { return ParameterValue(l.shadow); },
      [](Light& l, const ParameterValue& v) { l.shadow = std::get<bool>(v); });
  addEntry(
      place, tr("Position"), "position",
      tr("Where the light is, in scene units: +Y is up, +Z the side of the built-in cameras"), new TripleEditor(open),
      [](const Light& l) { return l.position; },
      [](Light& l, const ParameterValue& v) { l.position = std::get<glm::vec3>(v); },
      [](const Light& l) { return l.type != LightType::Directional; });
  addEntry(
      place, tr("Direction"), "direction", tr("The way the light travels; of any length but 0"),
      new TripleEditor(NumberRange{-1e3, 1e3, -1, 1, {}}), [](const Light& l) { return l.direction; },
      [](Light& l, const ParameterValue& v) {
        // A direction of no length is none: the light keeps the one it has.
        if (const auto d = std::get<glm::vec3>(v); glm::length(d) > 1e-6F) l.direction = d;
      },
      [](const Light& l) { return l.type != LightType::Point && l.type != LightType::Sphere; });
  addEntry(
      m_shape, tr("Inner angle"), "inner_degrees", tr("Half angle of the cone that is lit wholly"),
      new ScalarEditor(NumberRange{0, 90, 0, 90, QStringLiteral("°")}), [](const Light& l) { return l.innerDegrees; },
      [](Light& l, const ParameterValue& v) {
        l.innerDegrees = floatOf(v);
        l.outerDegrees = std::max(l.outerDegrees, l.innerDegrees);
      },
      isSpot);
  addEntry(
      m_shape, tr("Outer angle"), "outer_degrees", tr("Half angle of the cone outside of which nothing is lit"),
      new ScalarEditor(NumberRange{0, 90, 0, 90, QStringLiteral("°")}), [](const Light& l) { return l.outerDegrees; },
      [](Light& l, const ParameterValue& v) {
        l.outerDegrees = floatOf(v);
        l.innerDegrees = std::min(l.innerDegrees, l.outerDegrees);
      },
      isSpot);
  addEntry(
      m_shape, tr("Radius"), "radius_mm",
      tr("Radius of the sphere; of other lights, of the lamp that is seen. Larger makes softer shadows"),
      new ScalarEditor(NumberRange{0, 1e6, 0, 200, QStringLiteral("mm")}), [](const Light& l) { return l.radiusMm; },
      [](Light& l, const ParameterValue& v) { l.radiusMm = floatOf(v); },
      [](const Light& l) { return l.type == LightType::Sphere || l.visible; });
  addEntry(
      m_shape, tr("Size"), "size_mm", tr("Width and height of the rectangle. Larger makes softer shadows"),
      new VectorEditor(2, NumberRange{0, 1e6, 0, 1000, QStringLiteral("mm")}, {tr("Width"), tr("Height")}),
      [](const Light& l) { return l.sizeMm; },
      [](Light& l, const ParameterValue& v) { l.sizeMm = std::get<glm::vec2>(v); },
      [](const Light& l) { return l.type == LightType::Rect; });
  addEntry(
      motion, tr("Motion"), "animation.kind", tr("The light moves by itself: around the target, or to and fro"),
      new ChoiceEditor({tr("None"), tr("Orbit"), tr("Sway")}),
      [](const Light& l) { return EnumValue{static_cast<int>(l.animation.kind)}; },
      [](Light& l, const ParameterValue& v) {
        l.animation.kind = static_cast<AnimationKind>(std::get<EnumValue>(v).index);
      });
  const auto moves = [](const Light& l) { return l.animation.kind != AnimationKind::None; };
  addEntry(
      motion, tr("Amplitude"), "animation.amplitude", tr("How far it moves, in scene units"),
      new ScalarEditor(NumberRange{0, 1e6, 0, 10, {}}), [](const Light& l) { return l.animation.amplitude; },
      [](Light& l, const ParameterValue& v) { l.animation.amplitude = floatOf(v); }, moves);
  addEntry(
      motion, tr("Speed"), "animation.speed", tr("How fast it moves; negative, the other way round"),
      new ScalarEditor(NumberRange{-100, 100, 0, 5, QStringLiteral("rad/s")}),
      [](const Light& l) { return l.animation.speed; },
      [](Light& l, const ParameterValue& v) { l.animation.speed = floatOf(v); }, moves);
}

}  // namespace dermis
