// The Texture maps dock: the maps that the current material can wear.
#pragma once

#include <array>
#include <optional>

#include "core/material/texture_slot.h"
#include "ui/docks/panel.h"
#include "ui/docks/texture_row.h"

class QLabel;

namespace dermis {

class Document;
class Loading;
class MapWatcher;

class TexturesPanel : public Panel {
  Q_OBJECT
 public:
  TexturesPanel(Document& document, Loading& loading, QWidget* parent = nullptr);
  /// Files dropped on a map's row, or (unset) on the panel: one file for one map; else all find theirs by name.
  void take(std::optional<TextureSlot> slot, const QStringList& paths);
  /// Asks for a folder whose files find their maps by name.
  void chooseFolder();
  /// The missing map of the current slot is in that file now.
  void locate(TextureSlot slot, const QString& path);
  /// Whether the dock is to be seen: what changes meanwhile is shown then.
  void setSeen(bool seen);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildRows();
  void connectRow(TextureRow* row, TextureSlot slot);
  void assign(TextureSlot slot, const QString& path);
  void choose(TextureSlot slot);
  void askWhere(TextureSlot slot);
  /// One change of the binding on every edited slot that wears the map; each keeps the rest of its own.
  void changeBinding(TextureSlot slot, const BindingChange& change, Gesture gesture);
  void showReport(const QString& report);
  void refresh();

  bool m_isSeen = false;
  bool m_isStale = true;  ///< the rows show what was before
  Document& m_document;
  Loading& m_loading;
  MapWatcher* m_watcher = nullptr;
  QLabel* m_title = nullptr;
  QWidget* m_report = nullptr;
  QLabel* m_reportText = nullptr;
  QLabel* m_nothing = nullptr;  ///< the last of the rows, which are made when they are first seen
  std::array<TextureRow*, kTextureSlotCount> m_rows{};
};

}  // namespace dermis
