#include "ui/docks/lights_panel.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/docks/row_help.h"
#include "ui/document/document.h"
#include "ui/preferences/list_keys.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/rows/vector_editor.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

struct TypeRow {
  LightType type;
  const char* label;
  const char* icon;
};
constexpr std::array<TypeRow, 5> kTypes = {
    {{LightType::Point, QT_TRANSLATE_NOOP("dermis::LightsPanel", "Point"), "light"},
     {LightType::Directional, QT_TRANSLATE_NOOP("dermis::LightsPanel", "Directional"), "sun"},
     {LightType::Spot, QT_TRANSLATE_NOOP("dermis::LightsPanel", "Spot"), "spot"},
     {LightType::Sphere, QT_TRANSLATE_NOOP("dermis::LightsPanel", "Sphere"), "sphere"},
     {LightType::Rect, QT_TRANSLATE_NOOP("dermis::LightsPanel", "Rectangle"), "rect-light"}}};

QString typeLabel(LightType type) { return LightsPanel::tr(kTypes.at(static_cast<std::size_t>(type)).label); }
const char* typeIcon(LightType type) { return kTypes.at(static_cast<std::size_t>(type)).icon; }

QString nameOf(const Light& light, std::size_t index) {
  return light.name.empty() ? LightsPanel::tr("%1 %2").arg(typeLabel(light.type)).arg(index + 1)
                            : QString::fromStdString(light.name);
}

/// Three significant digits: a number that a person can read and type again.
float tidy(float number) {
  if (number == 0.0F) return number;
  const float step = std::pow(10.0F, std::floor(std::log10(std::abs(number))) - 2.0F);
  return std::round(number / step) * step;
}

float floatOf(const ParameterValue& value) { return std::get<float>(value); }

}  // namespace

LightsPanel::LightsPanel(Document& document, QWidget* parent) : Panel(parent), m_document(document) {
  buildList();
  buildRows();
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Lights || what == Change::Unit) refresh();
  });
  refresh();
}

void LightsPanel::buildList() {
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("lights.list"));
  m_list->setAccessibleName(tr("Lights"));
  m_list->setFixedHeight(108);
  m_list->setIconSize(QSize(16, 16));
  auto* line = new QHBoxLayout();
  m_add = new QToolButton(this);
  m_add->setObjectName(QStringLiteral("lights.add"));
  m_add->setIcon(themeIcon("add"));
  m_add->setText(tr("Add light"));
  m_add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_add->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_add);
  for (const TypeRow& row : kTypes)
    connect(menu->addAction(themeIcon(row.icon), tr(row.label)), &QAction::triggered, this,
            [this, type = row.type] { addLight(type); });
  m_add->setMenu(menu);
  m_remove = iconButton("remove", tr("Remove the selected light"), this);
  m_remove->setObjectName(QStringLiteral("lights.remove"));
  m_duplicate = iconButton("duplicate", tr("Duplicate the selected light"), this);
  m_duplicate->setObjectName(QStringLiteral("lights.duplicate"));
  line->addWidget(m_add);
  line->addStretch(1);
  line->addWidget(m_duplicate);
  line->addWidget(m_remove);
  strip()->addWidget(m_list);
  strip()->addLayout(line);
  connect(m_remove, &QToolButton::clicked, this, &LightsPanel::removeSelected);
  connect(m_duplicate, &QToolButton::clicked, this, &LightsPanel::duplicateSelected);
  m_list->setToolTip(tr("F2 or a double click renames a light, Ctrl+D duplicates it, Delete removes it"));
  m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(renameKey(m_list), &QAction::triggered, this, [this] {
    if (QListWidgetItem* item = m_list->currentItem()) m_list->editItem(item);
  });
  connect(duplicateKey(m_list), &QAction::triggered, this, &LightsPanel::duplicateSelected);
  connect(removeKey(m_list), &QAction::triggered, this, &LightsPanel::removeSelected);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    refreshEditors();
    Q_EMIT selectionChanged(row);
  });
  connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const auto index = static_cast<std::size_t>(m_list->row(item));
    if (index >= m_document.scene().lights.size()) return;
    Light light = m_document.scene().lights[index];
    light.enabled = item->checkState() == Qt::Checked;
    m_document.setLight(index, light, tr("on or off"), newGesture());
    if (item->text() != nameOf(light, index)) rename(index, item->text());
  });
}

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

int LightsPanel::selected() const {
  const int row = m_list->currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < m_document.scene().lights.size() ? row : -1;
}

void LightsPanel::addLight(LightType type) {
  // A key light: above, to the right and in front of what is looked at, bright enough to be seen at once.
  Light light;
  light.type = type;
  if (m_document.model()) {
    const Bounds& bounds = m_document.model()->bounds;
    const glm::vec3 away = glm::normalize(glm::vec3(0.7F, 0.8F, 1.0F));
    const float distance = 3.0F * bounds.radius();
    light.position = bounds.centre() + distance * away;
    light.direction = -away;
    light.intensity = type == LightType::Directional ? 2.0F : 2.0F * distance * distance;
    for (int i = 0; i < 3; ++i) {
      light.position[i] = tidy(light.position[i]);
      light.direction[i] = tidy(light.direction[i]);
    }
    light.intensity = tidy(light.intensity);
    const float radiusMm = bounds.radius() * m_document.millimetresPerUnit();
    light.radiusMm = tidy((type == LightType::Sphere ? 0.2F : 0.05F) * radiusMm);
    light.sizeMm = glm::vec2(tidy(0.8F * radiusMm), tidy(1.2F * radiusMm));
  }
  m_document.addLight(light);
  m_list->setCurrentRow(m_list->count() - 1);
}

void LightsPanel::select(int light) { m_list->setCurrentRow(light); }

void LightsPanel::removeSelected() {
  if (const int index = selected(); index >= 0) m_document.removeLight(static_cast<std::size_t>(index));
}

void LightsPanel::duplicateSelected() {
  const int index = selected();
  if (index < 0 || m_document.scene().lights.size() >= kMaxLights) return;
  Light copy = m_document.scene().lights[static_cast<std::size_t>(index)];
  // A little to the side, so that both can be taken hold of in the picture.
  if (m_document.model()) copy.position.x += tidy(0.3F * m_document.model()->bounds.radius());
  const QString name = nameOf(copy, static_cast<std::size_t>(index));
  if (!copy.name.empty()) copy.name = tr("%1 copy").arg(name).toStdString();
  m_document.addLight(copy, tr("Duplicate %1").arg(name));
  m_list->setCurrentRow(m_list->count() - 1);
}

void LightsPanel::rename(std::size_t index, const QString& name) {
  Light light = m_document.scene().lights[index];
  light.name = name.simplified().toStdString();
  // Its kind and number are no name: they follow when another light goes.
  Light unnamed = light;
  unnamed.name.clear();
  if (light.name == nameOf(unnamed, index).toStdString()) light = unnamed;
  m_document.setLight(index, light, tr("name"), newGesture());
  refresh();
}

void LightsPanel::refresh() {
  const std::vector<Light>& lights = m_document.scene().lights;
  {
    const QSignalBlocker blocker(m_list);
    const int row = m_list->currentRow();
    while (m_list->count() > static_cast<int>(lights.size())) delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < static_cast<int>(lights.size())) {
      auto* item = new QListWidgetItem(m_list);
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
      QListWidgetItem* item = m_list->item(static_cast<int>(i));
      item->setText(nameOf(lights[i], i));
      item->setIcon(themeIcon(typeIcon(lights[i].type)));
      item->setCheckState(lights[i].enabled ? Qt::Checked : Qt::Unchecked);
    }
    m_list->setCurrentRow(std::min(std::max(row, lights.empty() ? -1 : 0), static_cast<int>(lights.size()) - 1));
  }
  m_add->setEnabled(m_document.isReady() && lights.size() < kMaxLights);
  m_add->setToolTip(lights.size() < kMaxLights ? tr("Add a light")
                                               : tr("There are %1 lights, as many as a scene takes").arg(kMaxLights));
  refreshEditors();
}

void LightsPanel::refreshEditors() {
  const int index = selected();
  m_remove->setEnabled(index >= 0);
  m_duplicate->setEnabled(index >= 0 && m_document.scene().lights.size() < kMaxLights);
  for (GroupBox* group : m_groups) group->setVisible(index >= 0);
  if (index < 0) return;
  const Light& light = m_document.scene().lights[static_cast<std::size_t>(index)];
  for (const Entry& entry : m_entries) {
    entry.row->setVisible(!entry.applies || entry.applies(light));
    entry.row->showValue(entry.get(light));
  }
  m_shape->setVisible(light.type == LightType::Spot || light.type == LightType::Sphere ||
                      light.type == LightType::Rect || light.visible);
}

}  // namespace dermis
