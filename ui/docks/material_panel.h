// The Material dock: slot, shading model, preset, and a row for each parameter of the table.
#pragma once

#include <map>
#include <vector>

#include "core/material/parameter_table.h"
#include "ui/docks/panel.h"
#include "ui/rows/gesture.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace dermis {

class Document;
class Loading;
class MaterialClipboard;
class PropertyRow;
class SearchField;
class SlotChooser;

class MaterialPanel : public Panel {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, Loading& loading, QWidget* parent = nullptr);
  void focusSearch();
  /// Copying and pasting of groups and materials, for the menus.
  [[nodiscard]] MaterialClipboard* clipboard() const { return m_clipboard; }

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
  /// On all slots that are edited; `component`: only this one of a vector.
  void edit(const ParameterRow& parameter, const ParameterValue& value, std::optional<int> component, Gesture gesture);
  /// "face 0.45" lines where the edited slots have different values of it; else empty.
  [[nodiscard]] QString differencesOf(const ParameterRow& parameter) const;
  void refreshVisibility();

  Document& m_document;
  Loading& m_loading;
  MaterialClipboard* m_clipboard = nullptr;
  SlotChooser* m_slots = nullptr;
  QComboBox* m_model = nullptr;
  SearchField* m_search = nullptr;
  QLabel* m_preset = nullptr;
  QToolButton* m_revert = nullptr;
  QLabel* m_nothing = nullptr;
  std::vector<Entry> m_entries;
  std::vector<GroupBox*> m_groups;
};

}  // namespace dermis
