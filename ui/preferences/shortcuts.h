// The keyboard shortcuts of the window's commands: listed, changed, kept. The actions of the menus are the list.
#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class QMenuBar;

namespace dermis {

class Shortcuts : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QString id;     ///< its key in the settings
    QString menu;   ///< "File", "View › Ready-made views"
    QString label;  ///< without mnemonics and dots
    QPointer<QAction> action;
    QList<QKeySequence> standard;
  };

  explicit Shortcuts(QObject* parent = nullptr) : QObject(parent) {}
  /// Takes over all commands of the menus (but those of menus with the property "changing"), with the keys that are
  /// stored for them. To be called once, when the menus are complete.
  void collect(QMenuBar* menus);
  /// A key that is no command's, and what it does: it can't be given away.
  void reserve(const QKeySequence& keys, const QString& what) { m_reserved.insert(keys, what); }

  [[nodiscard]] const QList<Entry>& entries() const { return m_entries; }
  [[nodiscard]] bool isChanged(const Entry& entry) const;
  /// Empty keys take the shortcut away. Returns a sentence where the keys belong to another; then nothing changes.
  QString set(const Entry& entry, const QKeySequence& keys);
  QString reset(const Entry& entry);
  void resetAll();

 Q_SIGNALS:
  void changed();

 private:
  void collect(const QMenu* menu, const QString& path);
  [[nodiscard]] QString ownerOf(const QKeySequence& keys, const QAction* except) const;
  void store(const Entry& entry);

  QList<Entry> m_entries;
  QHash<QKeySequence, QString> m_reserved;
};

}  // namespace dermis
