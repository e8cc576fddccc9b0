#include "ui/docks/lights_panel.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/document/document.h"
#include "ui/preferences/list_keys.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
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

const char* typeIcon(LightType type) { return kTypes.at(static_cast<std::size_t>(type)).icon; }

/// Three significant digits: a number that a person can read and type again.
float tidy(float number) {
  if (number == 0.0F) return number;
  const float step = std::pow(10.0F, std::floor(std::log10(std::abs(number))) - 2.0F);
  return std::round(number / step) * step;
}

}  // namespace

QString LightsPanel::typeLabel(LightType type) { return tr(kTypes.at(static_cast<std::size_t>(type)).label); }

QString LightsPanel::nameOf(const Light& light, std::size_t index) {
  return light.name.empty() ? tr("%1 %2").arg(typeLabel(light.type)).arg(index + 1)
                            : QString::fromStdString(light.name);
}

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
