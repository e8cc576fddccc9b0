#include "ui/docks/rig_box.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/light_rig/rig_gestures.h"
#include "ui/docks/row_help.h"
#include "ui/document/rig_edit.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/theme/metrics.h"
#include "ui/viewport/rig_marks.h"

namespace dermis {

RigBox::RigBox(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  m_group = new GroupBox(tr("Light rig"), QStringLiteral("environment/rig"), this);
  column->addWidget(m_group);
  m_state = new QLabel(m_group);
  m_state->setObjectName(QStringLiteral("rig.state"));
  m_state->setProperty("quiet", true);
  m_state->setWordWrap(true);
  m_group->addRow(m_state);
  m_elements = new QuietComboBox(m_group);
  m_elements->setObjectName(QStringLiteral("rig.element"));
  m_elements->setAccessibleName(tr("Light rig › Element"));
  m_elements->setToolTip(
      tr("Which of the rig's lights the fields below are for; a click on its handle chooses it too"));
  m_elements->setPlaceholderText(tr("Choose a light of the rig"));
  m_group->addRow(m_elements);
  m_on = new PropertyRow(tr("Light rig"), tr("On"), QStringLiteral("rig.enabled"), new SwitchEditor(), m_group);
  setRowHelp(*m_on, tr("Whether this light of the rig shines"));
  m_group->addRow(m_on);
  m_azimuth = addRow(tr("Azimuth"), "azimuth_degrees", {-36000, 36000, -180, 180, QStringLiteral("°")},
                     [](RigElement e, float v) {
                       e.azimuthDegrees = v;
                       return e;
                     });
  setRowHelp(*m_azimuth, tr("About the vertical: 0° is the side of the built-in cameras, 90° the subject's left"));
  m_elevation =
      addRow(tr("Elevation"), "elevation_degrees", {-90, 90, -90, 90, QStringLiteral("°")}, [](RigElement e, float v) {
        e.elevationDegrees = v;
        return e;
      });
  setRowHelp(*m_elevation, tr("Above the horizon: 90° is overhead, below 0° is under the subject"));
  m_width = addRow(tr("Width"), "width", {0.001, 10000, 0, 10, {}}, [](const RigElement& e, float v) {
    const auto size = sizeOf(e);
    return size ? withSize(e, {v, size->size.y}) : e;
  });
  m_height = addRow(tr("Height"), "height", {0.001, 10000, 0, 10, {}}, [](const RigElement& e, float v) {
    const auto size = sizeOf(e);
    return size ? withSize(e, {size->size.x, v}) : e;
  });
  m_width->setHelp(
      tr("Across, or the diameter of what is round; in metres, or in degrees as the subject sees it. From 0.001 m or "
         "0.01° upwards"));
  m_height->setHelp(tr("Upwards; in metres, or in degrees as the subject sees it. From 0.001 m or 0.01° upwards"));
  m_amount = addRow(tr("Brightness"), "amount", {0, 1e9, 0, 20, {}}, &withAmount);
  setRowHelp(
      *m_amount,
      tr("Radiance of the brightest place, or what the rig's file says instead: irradiance, cd/m² or lux; of a sky, a "
         "factor"));
  m_save = new QPushButton(tr("Save rig as…"), m_group);
  m_save->setObjectName(QStringLiteral("rig.save"));
  m_save->setAccessibleName(tr("Light rig › Save as a file"));
  m_save->setToolTip(
      tr("Writes the rig as it is now to a .json file of its own; what the program carries stays as it is"));
  m_group->addRow(m_save);
  connect(m_save, &QPushButton::clicked, this, &RigBox::saveRequested);
  hide();
}

PropertyRow* RigBox::addRow(const QString& label, const char* id, const NumberRange& range, Change change) {
  auto* row = new PropertyRow(tr("Light rig"), label, QStringLiteral("rig.") + QLatin1String(id),
                              new ScalarEditor(range), m_group);
  m_group->addRow(row);
  connect(row, &PropertyRow::edited, this,
          [this, label, change = std::move(change)](const ParameterValue& value, Gesture gesture) {
            const int index = m_edit == nullptr ? -1 : m_edit->selected();
            if (index < 0) return;
            const auto at = static_cast<std::size_t>(index);
            m_edit->setElement(at, change(m_edit->rig()->elements.at(at), std::get<float>(value)),
                               tr("%1 in the light rig").arg(label), gesture);
          });
  return row;
}

void RigBox::setEdit(RigEdit& edit) {
  m_edit = &edit;
  connect(&edit, &RigEdit::changed, this, &RigBox::refresh);
  connect(&edit, &RigEdit::selectionChanged, this, &RigBox::refresh);
  connect(m_elements, &QComboBox::activated, m_edit, [this](int row) { m_edit->select(row); });
  connect(m_on, &PropertyRow::edited, this, [this](const ParameterValue& value, Gesture gesture) {
    const int index = m_edit->selected();
    if (index < 0) return;
    RigElement element = m_edit->rig()->elements.at(static_cast<std::size_t>(index));
    element.enabled = std::get<bool>(value);
    m_edit->setElement(static_cast<std::size_t>(index), element, tr("Light on or off"), gesture);
  });
  refresh();
}

void RigBox::refresh() {
  const LightRig* rig = m_edit->rig();
  setVisible(rig != nullptr && !rig->elements.empty());
  if (rig == nullptr || rig->elements.empty()) return;
  {
    const QSignalBlocker blocker(m_elements);
    m_elements->clear();
    for (const RigElement& one : rig->elements) m_elements->addItem(marks::nameOf(one));
    m_elements->setCurrentIndex(m_edit->selected());
  }
  const QString name = QString::fromStdString(rig->name);
  m_state->setText(m_edit->isOwn() ? tr("%1, changed; kept in the scene").arg(name) : name);
  if (m_edit->selected() < 0) {
    for (PropertyRow* row : {m_on, m_azimuth, m_elevation, m_width, m_height, m_amount}) row->hide();
    return;
  }
  showElement(rig->elements.at(static_cast<std::size_t>(m_edit->selected())));
}

void RigBox::showDefaults(const RigElement& before) {
  m_on->setDefault(ParameterValue(before.enabled));
  m_azimuth->setDefault(ParameterValue(before.azimuthDegrees));
  m_elevation->setDefault(ParameterValue(before.elevationDegrees));
  if (const auto size = sizeOf(before)) {
    m_width->setDefault(ParameterValue(size->size.x));
    m_height->setDefault(ParameterValue(size->size.y));
  }
  m_amount->setDefault(ParameterValue(amountOf(before)));
}

void RigBox::showElement(const RigElement& element) {
  const bool placed = hasPlace(element.type);
  const auto size = sizeOf(element);
  m_on->show();
  for (PropertyRow* row : {m_azimuth, m_elevation}) row->setVisible(placed);
  m_width->setVisible(size.has_value());
  m_height->setVisible(size && !size->isRound);
  m_amount->setVisible(element.type != RigElementType::Ground);
  if (const RigElement* before = m_edit->original(static_cast<std::size_t>(m_edit->selected()))) showDefaults(*before);
  m_on->showValue(ParameterValue(element.enabled));
  m_azimuth->showValue(ParameterValue(element.azimuthDegrees));
  m_elevation->showValue(ParameterValue(element.elevationDegrees));
  if (size) {
    const NumberRange range = size->inDegrees ? NumberRange{0.01, 179, 0, 120, QStringLiteral("°")}
                                              : NumberRange{0.001, 10000, 0, 5, QStringLiteral("m")};
    for (PropertyRow* row : {m_width, m_height}) static_cast<ScalarEditor*>(row->editor())->setNumberRange(range);
    m_width->showValue(ParameterValue(size->size.x));
    m_height->showValue(ParameterValue(size->size.y));
  }
  m_amount->showValue(ParameterValue(amountOf(element)));
}

}  // namespace dermis
