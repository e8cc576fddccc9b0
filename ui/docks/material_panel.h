// The Material dock: slot, shading model, preset, and a row for each parameter of the table.
#pragma once

#include <map>
#include <vector>

#include "core/material/parameter_table.h"
#include "ui/docks/panel.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace dermis {

class Document;
class Loading;
class PropertyRow;

class MaterialPanel : public Panel {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, Loading& loading, QWidget* parent = nullptr);
  void focusSearch();

 Q_SIGNALS:
  void savePresetRequested();

 private:
  struct Entry {
    const ParameterRow* parameter = nullptr;
    PropertyRow* row = nullptr;
    GroupBox* group = nullptr;
  };
  void buildStrip();
  void buildRows();
  void refresh();
  void refreshSlots();
  void refreshVisibility();

  Document& m_document;
  Loading& m_loading;
  QComboBox* m_slot = nullptr;
  QComboBox* m_model = nullptr;
  QLineEdit* m_search = nullptr;
  QLabel* m_preset = nullptr;
  QToolButton* m_revert = nullptr;
  QLabel* m_nothing = nullptr;
  std::vector<Entry> m_entries;
  std::vector<GroupBox*> m_groups;
};

}  // namespace dermis
