// The Lights dock: the list, and editors of the selected light.
#pragma once

#include <functional>
#include <vector>

#include "core/scene/scene.h"
#include "ui/docks/panel.h"
#include "ui/rows/value_editor.h"

class QListWidget;
class QToolButton;

namespace dermis {

class Document;
class PropertyRow;

class LightsPanel : public Panel {
  Q_OBJECT
 public:
  explicit LightsPanel(Document& document, QWidget* parent = nullptr);
  void addLight(LightType type);
  void removeSelected();
  void duplicateSelected();
  /// -1: none.
  void select(int light);

 Q_SIGNALS:
  void selectionChanged(int light);

 private:
  struct Entry {
    PropertyRow* row = nullptr;
    std::function<ParameterValue(const Light&)> get;
    std::function<bool(const Light&)> applies;
  };
  using Get = std::function<ParameterValue(const Light&)>;
  using Set = std::function<void(Light&, const ParameterValue&)>;
  using Applies = std::function<bool(const Light&)>;
  [[nodiscard]] static QString typeLabel(LightType type);
  void buildList();
  void buildRows();
  void addEntry(GroupBox* group, const QString& label, const char* id, const QString& meaning, ValueEditor* editor,
                Get get, Set set, Applies applies = {});
  void refresh();
  void refreshEditors();
  [[nodiscard]] static QString nameOf(const Light& light, std::size_t index);
  void rename(std::size_t index, const QString& name);
  [[nodiscard]] int selected() const;

  Document& m_document;
  QListWidget* m_list = nullptr;
  QToolButton* m_add = nullptr;
  QToolButton* m_duplicate = nullptr;
  QToolButton* m_remove = nullptr;
  std::vector<GroupBox*> m_groups;
  GroupBox* m_shape = nullptr;
  std::vector<Entry> m_entries;
};

}  // namespace dermis
