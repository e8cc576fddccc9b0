// Copying and pasting groups of values and whole materials, as text, between slots and between programs.
#pragma once

#include <QObject>

class QAction;

namespace dermis {

class Document;
class Loading;

class MaterialClipboard : public QObject {
  Q_OBJECT
 public:
  MaterialClipboard(Document& document, Loading& loading, QObject* parent = nullptr);
  /// "Copy group", for the menus of a group's heading and its rows. Owned by `owner`.
  [[nodiscard]] QAction* copyGroupAction(const QString& group, QObject* owner);
  [[nodiscard]] QAction* copyMaterialAction() const { return m_copyMaterial; }
  [[nodiscard]] QAction* pasteAction() const { return m_paste; }
  void copyGroup(const QString& group);
  void copyMaterial();
  /// A group's values or a whole material, whichever the clipboard holds, on every edited slot as one entry.
  void paste();

 private:
  Document& m_document;
  Loading& m_loading;
  QAction* m_copyMaterial = nullptr;
  QAction* m_paste = nullptr;
};

}  // namespace dermis
