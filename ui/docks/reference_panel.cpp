#include "ui/docks/reference_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/docks/labelled.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/theme/icons.h"

namespace dermis {

ReferencePanel::ReferencePanel(ReferencePhoto& photo, QWidget* parent) : Panel(parent), m_photo(photo) {
  auto* open = new QPushButton(themeIcon("open"), tr("Choose photograph…"), this);
  open->setObjectName(QStringLiteral("reference.choose"));
  open->setAccessibleName(tr("Choose a reference photograph"));
  open->setToolTip(tr("A picture to compare with. It is remembered by the editor, not by the scene."));
  strip()->addWidget(open);
  m_name = new QLabel(this);
  m_name->setProperty("quiet", true);
  strip()->addWidget(m_name);
  connect(open, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Choose a reference photograph"),
                                                      QFileInfo(m_photo.settings().path).path(),
                                                      tr("Pictures (*.png *.jpg *.jpeg *.webp *.bmp);;All files (*)"));
    if (!path.isEmpty()) choose(path);
  });

  GroupBox* group = addGroup(tr("Reference photograph"), QStringLiteral("reference/photograph"));
  m_place = new QuietComboBox(group);
  m_place->setObjectName(QStringLiteral("reference.place"));
  m_place->setAccessibleName(tr("Where the photograph is shown"));
  m_place->setToolTip(tr("Over the picture, beside it, or not at all"));
  m_place->addItems({tr("Off"), tr("Over the picture"), tr("Beside the picture")});
  group->addRow(labelled(tr("Shown"), m_place, group));
  connect(m_place, &QComboBox::activated, this, [this](int index) {
    ReferencePhoto::Settings next = m_photo.settings();
    next.place = static_cast<ReferencePhoto::Place>(index);
    m_photo.set(next);
  });
  m_opacity = addNumber(group, tr("Opacity"), "opacity", 0, 1, 0, 1, &ReferencePhoto::Settings::opacity);
  m_opacity->setHelp(tr("How much of the picture it hides"));
  m_wipe = addNumber(group, tr("Wipe"), "wipe", 0, 1, 0, 1, &ReferencePhoto::Settings::wipe);
  m_wipe->setHelp(tr("The share of the picture, from the left, that it lies over; the line can be dragged"));
  m_scale = addNumber(group, tr("Scale"), "scale", 0.01, 100, 0.2, 3, &ReferencePhoto::Settings::scale);
  m_scale->setHelp(tr("1 is as high as the viewport"));
  const auto addOffset = [&](const QString& label, const char* id, bool across) {
    auto* row = new PropertyRow(tr("Reference"), label, QStringLiteral("reference.") + QLatin1String(id),
                                new ScalarEditor(NumberRange{-10, 10, -1, 1, {}}), group);
    row->setDefault(ParameterValue(0.0F));
    row->setHelp(tr("In heights of the viewport"));
    group->addRow(row);
    connect(row, &PropertyRow::edited, this, [this, across](const ParameterValue& value, Gesture) {
      ReferencePhoto::Settings next = m_photo.settings();
      (across ? next.offset.rx() : next.offset.ry()) = static_cast<double>(std::get<float>(value));
      m_photo.set(next);
    });
    return row;
  };
  m_x = addOffset(tr("Right"), "x", true);
  m_y = addOffset(tr("Down"), "y", false);
  finish();
  connect(&m_photo, &ReferencePhoto::changed, this, &ReferencePanel::refresh);
  refresh();
}

PropertyRow* ReferencePanel::addNumber(GroupBox* group, const QString& label, const char* id, double lowest,
                                       double highest, double softLowest, double softHighest,
                                       double ReferencePhoto::Settings::*member) {
  auto* row = new PropertyRow(tr("Reference"), label, QStringLiteral("reference.") + QLatin1String(id),
                              new ScalarEditor(NumberRange{lowest, highest, softLowest, softHighest, {}}), group);
  row->setDefault(ParameterValue(static_cast<float>(ReferencePhoto::Settings().*member)));
  group->addRow(row);
  connect(row, &PropertyRow::edited, this, [this, member](const ParameterValue& value, Gesture) {
    ReferencePhoto::Settings next = m_photo.settings();
    next.*member = static_cast<double>(std::get<float>(value));
    m_photo.set(next);
  });
  return row;
}

void ReferencePanel::choose(const QString& path) {
  ReferencePhoto::Settings next = m_photo.settings();
  next.path = path;
  if (next.place == ReferencePhoto::Place::Off) next.place = ReferencePhoto::Place::Over;
  m_photo.set(next);
}

void ReferencePanel::refresh() {
  const ReferencePhoto::Settings& now = m_photo.settings();
  m_name->setText(now.path.isEmpty() ? tr("No photograph") : QFileInfo(now.path).fileName());
  m_name->setToolTip(now.path);
  const QSignalBlocker blocker(m_place);
  m_place->setCurrentIndex(static_cast<int>(now.place));
  const auto show = [](PropertyRow* row, double value) { row->showValue(ParameterValue(static_cast<float>(value))); };
  show(m_opacity, now.opacity);
  show(m_wipe, now.wipe);
  show(m_scale, now.scale);
  show(m_x, now.offset.x());
  show(m_y, now.offset.y());
  // What would change nothing that is seen isn't asked for.
  const bool over = now.place == ReferencePhoto::Place::Over;
  for (PropertyRow* row : {m_opacity, m_wipe}) row->setVisible(over);
  for (PropertyRow* row : {m_scale, m_x, m_y}) row->setVisible(now.place != ReferencePhoto::Place::Off);
}

}  // namespace dermis
