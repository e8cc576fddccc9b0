// A line below the menus that says how tall an opened model is, and lets its unit be put right: nothing stops for it.
#pragma once

#include <QFrame>

class QButtonGroup;
class QLabel;

namespace dermis {

class Document;
class ElidedLabel;
class NumberField;

class ModelUnitBar : public QFrame {
  Q_OBJECT
 public:
  explicit ModelUnitBar(Document& document, QWidget* parent = nullptr);
  /// After `name` was opened; `source` says where its unit came from.
  void ask(const QString& name, const QString& source);
  /// For the model that is open.
  void ask();

 private:
  void refresh();

  Document& m_document;
  QString m_name;
  QString m_source;
  QLabel* m_text = nullptr;
  ElidedLabel* m_why = nullptr;  ///< where the unit came from
  QButtonGroup* m_units = nullptr;
  NumberField* m_number = nullptr;
};

}  // namespace dermis
