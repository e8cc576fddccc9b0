#include "ui/rows/choice_editors.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QWheelEvent>

namespace dermis {

QuietComboBox::QuietComboBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(6);
  setMaxVisibleItems(20);
}

void QuietComboBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

ChoiceEditor::ChoiceEditor(const QStringList& words, QWidget* parent) : ValueEditor(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  m_box = new QuietComboBox(this);
  m_box->addItems(words);
  row->addWidget(m_box, 1);
  setFocusProxy(m_box);
  connect(m_box, &QComboBox::activated, this,
          [this](int index) { Q_EMIT edited(ParameterValue(EnumValue{index}), newGesture()); });
}

void ChoiceEditor::showValue(const ParameterValue& value) {
  const QSignalBlocker blocker(m_box);
  m_box->setCurrentIndex(std::get<EnumValue>(value).index);
}

void ChoiceEditor::nameControls(const QString& path, const QString& id) {
  m_box->setAccessibleName(path);
  m_box->setObjectName(id + QStringLiteral(".choice"));
}

SwitchEditor::SwitchEditor(QWidget* parent) : ValueEditor(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  m_box = new QCheckBox(this);
  row->addWidget(m_box);
  row->addStretch(1);
  setFocusProxy(m_box);
  connect(m_box, &QCheckBox::toggled, this, [this](bool on) { Q_EMIT edited(ParameterValue(on), newGesture()); });
}

void SwitchEditor::showValue(const ParameterValue& value) {
  const QSignalBlocker blocker(m_box);
  m_box->setChecked(std::get<bool>(value));
}

void SwitchEditor::nameControls(const QString& path, const QString& id) {
  m_box->setAccessibleName(path);
  m_box->setObjectName(id + QStringLiteral(".switch"));
}

}  // namespace dermis
