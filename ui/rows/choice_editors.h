// Editors of a choice among words, and of yes or no.
#pragma once

#include <QComboBox>

#include "ui/rows/value_editor.h"

class QCheckBox;

namespace dermis {

/// A combo box that the wheel turns only when it has the focus, so that scrolling a panel changes nothing, and that is
/// as narrow as its place wants it.
class QuietComboBox : public QComboBox {
  Q_OBJECT
 public:
  explicit QuietComboBox(QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

class ChoiceEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit ChoiceEditor(const QStringList& words, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void showMixed(bool mixed) override;
  void nameControls(const QString& path, const QString& id) override;
  [[nodiscard]] QComboBox* box() const { return m_box; }
  [[nodiscard]] QStringList words() const override;

 private:
  void refresh();

  QuietComboBox* m_box = nullptr;
  int m_index = 0;
  bool m_mixed = false;
};

class SwitchEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit SwitchEditor(QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void showMixed(bool mixed) override;
  void nameControls(const QString& path, const QString& id) override;

 private:
  void refresh();

  QCheckBox* m_box = nullptr;
  bool m_on = false;
  bool m_mixed = false;
};

}  // namespace dermis
